//! The same drawing as vector graphics: on paper, for a report, or on a screen that shows it live.

mod screen;
mod sheet;
mod wires;

use crate::block::Cell;
use crate::listing::{Title, heading};
use crate::{Drawing, Element, Names, Net, Picture, Symbol};
use svg::Document;
use svg::node::element::{Group, Path, Rectangle, Text};
use unoclp_checked::SourceMap;
use wires::{NO_NET, Wires, arms, horizontal, is_rail, is_text, vertical};

pub use screen::to_screen;
pub use sheet::{Area, Labels, Sheet, to_sheet};

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
        screen: false,
        ids: None,
        areas: Vec::new(),
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
    /// What a style sheet calls it.
    class: &'static str,
}

impl Font {
    const TITLE: Font = Font::new(SANS, 18.0, true, false, "title");
    const HEADING: Font = Font::new(SANS, 13.0, true, false, "heading");
    const REMARK: Font = Font::new(SANS, 13.0, false, false, "remark");
    /// What a symbol is called.
    const POINT: Font = Font::new(SANS, 13.0, false, true, "point");
    /// Within a symbol.
    const LETTER: Font = Font::new(SANS, 12.0, true, true, "letter");
    /// Within a box; its width is that of the columns.
    const BOXED: Font = Font::new(MONO, 13.5, false, true, "boxed");
    /// Names, notes and connections.
    const NOTE: Font = Font::new(MONO, 13.5, false, false, "note");

    const fn new(
        family: &'static str,
        size: f32,
        bold: bool,
        centred: bool,
        class: &'static str,
    ) -> Font {
        Font {
            family,
            size,
            bold,
            centred,
            class,
        }
    }
}

/// A page that fills from the top.
struct Page<'p> {
    drawing: &'p Drawing<'p>,
    group: Group,
    y: f32,
    /// Whether a style sheet says how all of it looks, and what is live has a name.
    screen: bool,
    /// What elements are known by where they are edited.
    ids: Option<&'p dyn Fn(usize) -> u32>,
    /// Where elements are.
    areas: Vec<(usize, Area)>,
}

impl Page<'_> {
    fn text(&mut self, x: f32, y: f32, text: &str, font: &Font) {
        if self.screen {
            let text = Text::new(text).set("x", x).set("y", y);
            return self.add(text.set("class", font.class));
        }
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
        if self.screen {
            let path = Path::new().set("d", data).set("stroke-width", width);
            return self.add(path.set("class", "line"));
        }
        let path = Path::new()
            .set("d", data)
            .set("fill", "none")
            .set("stroke", INK)
            .set("stroke-linecap", "square")
            .set("stroke-width", width);
        self.add(path);
    }

    /// A wire; on a screen one that its net can light.
    fn wire(&mut self, data: String, net: u32) {
        if !self.screen {
            return self.line(data, 1.4);
        }
        let wire = Path::new().set("d", data);
        self.add(match net {
            NO_NET => wire.set("class", "wire"),
            net => wire.set("class", format!("wire n{net}")),
        });
    }

    /// The wires on both sides of a symbol, each from one place to another.
    fn leads(
        &mut self,
        (before, behind): (Option<Net>, Net),
        left: (f32, f32),
        right: (f32, f32),
        y: f32,
    ) {
        let left = format!("M{} {y}H{}", left.0, left.1);
        let right = format!("M{} {y}H{}", right.0, right.1);
        if !self.screen {
            return self.line(left + &right, 1.4);
        }
        self.wire(left, before.map_or(NO_NET, Net::number));
        self.wire(right, behind.number());
    }

    /// The edge of a box.
    fn edge(&self) -> Rectangle {
        match self.screen {
            true => Rectangle::new().set("class", "line"),
            false => Rectangle::new().set("fill", "none").set("stroke", INK),
        }
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
        let mut wires = Wires::new(self.screen);
        for (index, row) in picture.rows.iter().enumerate() {
            self.row(row, axes[index]);
            horizontal(row, axes[index], &mut wires);
            if let Some(next) = picture.rows.get(index + 1) {
                vertical(row, next, axes[index], axes[index + 1], &mut wires);
            }
        }
        for (net, data) in wires.paths {
            self.wire(data, net);
        }
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
                let text: String = row[column..end].iter().map(|cell| cell.ch).collect();
                let before = column.checked_sub(1).and_then(|before| row[before].net);
                self.element(element, &text, (column, end), axis, before);
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

    /// An element between two columns; `text` is what it is in characters, `before` the net before it.
    fn element(
        &mut self,
        index: usize,
        text: &str,
        columns: (usize, usize),
        y: f32,
        before: Option<Net>,
    ) {
        let drawing = self.drawing;
        let Some(element) = drawing.ladder().elements.get(index) else {
            return;
        };
        if !self.screen {
            return self.symbol(element, text, columns, y, before);
        }
        let outer = std::mem::take(&mut self.group);
        self.symbol(element, text, columns, y, before);
        let inner = std::mem::replace(&mut self.group, outer);
        let mut named = screen::named(element, index, inner, columns, y);
        if let Some(ids) = self.ids {
            named = named.set("data-id", ids(index));
            let edges = (x(columns.0 as f32), x(columns.1 as f32));
            self.areas.push((index, sheet::area(edges, y)));
        }
        self.add(named);
    }

    fn symbol(
        &mut self,
        element: &Element,
        text: &str,
        (from, to): (usize, usize),
        y: f32,
        before: Option<Net>,
    ) {
        let (left, right) = (x(from as f32), x(to as f32));
        let nets = (before, element.net);
        let middle = (left + right) / 2.0;
        let (above, below) = (y - HALF, y + HALF);
        match &element.symbol {
            Symbol::Contact { closed, text } => {
                let (a, b) = (middle - 6.0, middle + 6.0);
                self.leads(nets, (left, a), (b, right), y);
                self.line(format!("M{a} {above}V{below}M{b} {above}V{below}"), 1.8);
                if *closed {
                    let (a, b) = (a - 1.0, b + 1.0);
                    self.line(format!("M{a} {below}L{b} {above}"), 1.4);
                }
                self.text(middle, above - 4.0, text, &Font::POINT);
            }
            Symbol::Inline(text) => self.inline(text, (left, right), y, nets),
            Symbol::Coil { letter, text } => {
                let (a, b) = (middle - 8.0, middle + 8.0);
                self.leads(nets, (left, a), (b, right), y);
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
                let edge = self
                    .edge()
                    .set("stroke-width", 1.6)
                    .set("x", left)
                    .set("y", above - 2.0)
                    .set("width", right - left)
                    .set("height", 2.0 * HALF + 4.0);
                self.add(edge);
                self.text(middle, y + 4.5, inside, &Font::BOXED);
            }
            Symbol::Leave { inverted, text } => {
                let start = right - text.len() as f32 * COLUMN;
                if *inverted {
                    let behind = left + 5.0 * COLUMN;
                    self.inline("NOT", (left, behind), y, nets);
                    self.wire(
                        format!("M{behind} {y}H{}", start - 2.0),
                        element.net.number(),
                    );
                }
                self.text(start, y + 4.5, text, &Font::NOTE);
            }
        }
    }

    /// Letters between two bars.
    fn inline(&mut self, text: &str, (left, right): (f32, f32), y: f32, nets: (Option<Net>, Net)) {
        let (above, below) = (y - HALF, y + HALF);
        let middle = (left + right) / 2.0;
        let half = 4.0 + 5.0 * text.len() as f32;
        let (a, b) = (middle - half, middle + half);
        self.leads(nets, (left, a), (b, right), y);
        self.line(format!("M{a} {above}V{below}M{b} {above}V{below}"), 1.8);
        self.text(middle, y + 4.5, text, &Font::LETTER);
    }
}

/// The left edge of a column.
fn x(column: f32) -> f32 {
    MARGIN + column * COLUMN
}
