//! The same drawing as vector graphics, for a report.

mod wires;

use crate::block::Cell;
use crate::listing::{Title, heading};
use crate::{Drawing, Element, Names, Picture, Symbol};
use svg::Document;
use svg::node::element::{Group, Path, Rectangle, Text};
use unoclp_checked::SourceMap;
use wires::{arms, horizontal, is_rail, is_text, vertical};

/// A column of the drawing, in units of the page.
const COLUMN: f32 = 9.0;
/// A row with a wire: symbols, and what they are called above them.
const WIRE_ROW: f32 = 40.0;
/// A row with text alone.
const TEXT_ROW: f32 = 17.0;
/// A line of a heading.
const HEADING: f32 = 17.0;
/// Between rungs.
const GAP: f32 = 22.0;
/// Around all.
const MARGIN: f32 = 24.0;
/// The wire's distance from the upper edge of its row.
const AXIS: f32 = 26.0;
/// The height of the symbols, from the wire up and down.
const HALF: f32 = 9.0;
/// Millimetres of a unit: 80 columns go on a page of A4 with its margins.
const MILLIMETRES: f32 = 0.225;

const SANS: &str = "Helvetica, Arial, 'DejaVu Sans', sans-serif";
const MONO: &str = "'DejaVu Sans Mono', Consolas, Menlo, monospace";
const INK: &str = "#1a1a1a";

/// The drawing as an SVG document under the heading `about`, its rungs under their titles.
pub fn to_svg(
    drawing: &Drawing<'_>,
    map: &SourceMap,
    names: &Names,
    title: Title<'_>,
    about: &str,
) -> String {
    let mut page = Page {
        drawing,
        group: Group::new(),
        y: MARGIN,
    };
    page.text(MARGIN, page.y + 16.0, about, &Font::TITLE);
    page.y += 40.0;
    for (index, picture) in drawing.rungs.iter().enumerate() {
        for (line, text) in heading(drawing, map, names, title, index)
            .iter()
            .enumerate()
        {
            let font = if line == 0 {
                Font::HEADING
            } else {
                Font::REMARK
            };
            page.text(MARGIN, page.y + 12.0, text, &font);
            page.y += HEADING;
        }
        page.y += 4.0;
        page.rung(picture);
        page.y += GAP;
    }
    let width = drawing.width as f32 * COLUMN + 2.0 * MARGIN;
    let height = page.y - GAP + MARGIN;
    let paper = Rectangle::new()
        .set("width", width)
        .set("height", height)
        .set("fill", "#ffffff");
    Document::new()
        .set("width", format!("{:.1}mm", width * MILLIMETRES))
        .set("height", format!("{:.1}mm", height * MILLIMETRES))
        .set("viewBox", (0.0, 0.0, width, height))
        .add(svg::node::element::Title::new(about))
        .add(paper)
        .add(page.group)
        .to_string()
}

/// How text is set.
struct Font {
    family: &'static str,
    size: f32,
    bold: bool,
    centred: bool,
}

impl Font {
    const TITLE: Font = Font::new(SANS, 18.0, true, false);
    const HEADING: Font = Font::new(SANS, 13.0, true, false);
    const REMARK: Font = Font::new(SANS, 13.0, false, false);
    /// What a symbol is called.
    const POINT: Font = Font::new(SANS, 13.0, false, true);
    /// Within a symbol.
    const LETTER: Font = Font::new(SANS, 12.0, true, true);
    /// Within a box; its width is that of the columns.
    const BOXED: Font = Font::new(MONO, 13.5, false, true);
    /// Names, notes and connections.
    const NOTE: Font = Font::new(MONO, 13.5, false, false);

    const fn new(family: &'static str, size: f32, bold: bool, centred: bool) -> Font {
        Font {
            family,
            size,
            bold,
            centred,
        }
    }
}

/// A page that fills from the top.
struct Page<'p> {
    drawing: &'p Drawing<'p>,
    group: Group,
    y: f32,
}

impl Page<'_> {
    fn text(&mut self, x: f32, y: f32, text: &str, font: &Font) {
        let text = Text::new(text)
            .set("x", x)
            .set("y", y)
            .set("fill", INK)
            .set("font-family", font.family)
            .set("font-size", font.size)
            .set("font-weight", if font.bold { "bold" } else { "normal" })
            .set("text-anchor", if font.centred { "middle" } else { "start" });
        self.add(text);
    }

    fn add(&mut self, node: impl svg::Node) {
        self.group = std::mem::take(&mut self.group).add(node);
    }

    fn line(&mut self, data: String, width: f32) {
        let path = Path::new()
            .set("d", data)
            .set("fill", "none")
            .set("stroke", INK)
            .set("stroke-linecap", "square")
            .set("stroke-width", width);
        self.add(path);
    }

    fn rung(&mut self, picture: &Picture) {
        let top = self.y;
        let mut axes = Vec::new();
        for row in &picture.rows {
            let wired = row
                .iter()
                .any(|cell| arms(*cell).iter().any(|&arm| arm) && !is_rail(cell));
            axes.push(self.y + if wired { AXIS } else { TEXT_ROW / 2.0 });
            self.y += if wired { WIRE_ROW } else { TEXT_ROW };
        }
        let mut wires = String::new();
        for (index, row) in picture.rows.iter().enumerate() {
            self.row(row, axes[index]);
            horizontal(row, axes[index], &mut wires);
            if let Some(next) = picture.rows.get(index + 1) {
                vertical(row, next, axes[index], axes[index + 1], &mut wires);
            }
        }
        self.line(wires, 1.4);
        let right = (self.drawing.width - 1) as f32;
        let rails = [0.0, right].map(|column| format!("M{} {top}V{}", x(column + 0.5), self.y));
        self.line(rails.concat(), 2.6);
    }

    /// The symbols and texts of a row.
    fn row(&mut self, row: &[Cell], axis: f32) {
        let mut column = 0;
        while column < row.len() {
            let cell = row[column];
            let mut end = column + 1;
            if let Some(element) = cell.element {
                while row
                    .get(end)
                    .is_some_and(|cell| cell.element == Some(element))
                {
                    end += 1;
                }
                let drawing = self.drawing;
                let text: String = row[column..end].iter().map(|cell| cell.ch).collect();
                self.symbol(
                    &drawing.ladder().elements[element],
                    &text,
                    (column, end),
                    axis,
                );
            } else if cell.ch == '→' {
                let (left, right) = (x(column as f32), x(end as f32));
                let (tip, up, down) = (right - 2.0, axis - 4.0, axis + 4.0);
                self.line(format!("M{left} {axis}H{tip}"), 1.4);
                let back = tip - 6.0;
                self.line(format!("M{back} {up}L{tip} {axis}L{back} {down}"), 1.4);
            } else if is_text(cell) {
                // Words with single blanks between them.
                let goes_on = |at: usize| row.get(at).is_some_and(|cell| is_text(*cell));
                while goes_on(end) || row.get(end) == Some(&Cell::BLANK) && goes_on(end + 1) {
                    end += 1;
                }
                let text: String = row[column..end].iter().map(|cell| cell.ch).collect();
                let text = text.replace('\0', "");
                self.text(x(column as f32), axis + 4.5, &text, &Font::NOTE);
            }
            column = end;
        }
    }

    /// An element between two columns; `text` is what it is in characters.
    fn symbol(&mut self, element: &Element, text: &str, (from, to): (usize, usize), y: f32) {
        let (left, right) = (x(from as f32), x(to as f32));
        let middle = (left + right) / 2.0;
        let (above, below) = (y - HALF, y + HALF);
        match &element.symbol {
            Symbol::Contact { closed, text } => {
                let (a, b) = (middle - 6.0, middle + 6.0);
                self.line(format!("M{left} {y}H{a}M{b} {y}H{right}"), 1.4);
                self.line(format!("M{a} {above}V{below}M{b} {above}V{below}"), 1.8);
                if *closed {
                    let (a, b) = (a - 1.0, b + 1.0);
                    self.line(format!("M{a} {below}L{b} {above}"), 1.4);
                }
                self.text(middle, above - 4.0, text, &Font::POINT);
            }
            Symbol::Inline(text) => self.inline(text, (left, right), y),
            Symbol::Coil { letter, text } => {
                let (a, b) = (middle - 8.0, middle + 8.0);
                self.line(format!("M{left} {y}H{a}M{b} {y}H{right}"), 1.4);
                let (c, d) = (middle - 4.0, middle + 4.0);
                let arcs = format!(
                    "M{c} {above}A11 11 0 0 0 {c} {below}M{d} {above}A11 11 0 0 1 {d} {below}"
                );
                self.line(arcs, 1.8);
                match letter {
                    ' ' => {}
                    '/' => self.line(format!("M{c} {below}L{d} {above}"), 1.4),
                    letter => self.text(middle, y + 4.5, &letter.to_string(), &Font::LETTER),
                }
                self.text(middle, above - 4.0, text, &Font::POINT);
            }
            Symbol::Box { .. } => {
                let inside = text.trim_start_matches("[ ").trim_end_matches(" ]");
                let edge = Rectangle::new()
                    .set("x", left)
                    .set("y", above - 2.0)
                    .set("width", right - left)
                    .set("height", 2.0 * HALF + 4.0)
                    .set("fill", "none")
                    .set("stroke", INK)
                    .set("stroke-width", 1.6);
                self.add(edge);
                self.text(middle, y + 4.5, inside, &Font::BOXED);
            }
            Symbol::Leave { inverted, text } => {
                let start = right - text.len() as f32 * COLUMN;
                if *inverted {
                    let behind = left + 5.0 * COLUMN;
                    self.inline("NOT", (left, behind), y);
                    self.line(format!("M{behind} {y}H{}", start - 2.0), 1.4);
                }
                self.text(start, y + 4.5, text, &Font::NOTE);
            }
        }
    }

    /// Letters between two bars.
    fn inline(&mut self, text: &str, (left, right): (f32, f32), y: f32) {
        let (above, below) = (y - HALF, y + HALF);
        let middle = (left + right) / 2.0;
        let half = 4.0 + 5.0 * text.len() as f32;
        let (a, b) = (middle - half, middle + half);
        self.line(format!("M{left} {y}H{a}M{b} {y}H{right}"), 1.4);
        self.line(format!("M{a} {above}V{below}M{b} {above}V{below}"), 1.8);
        self.text(middle, y + 4.5, text, &Font::LETTER);
    }
}

/// The left edge of a column.
fn x(column: f32) -> f32 {
    MARGIN + column * COLUMN
}
