//! What a drawing is drawn on, rung by rung.

use super::area::Area;
use super::node::{Node, data, digits};
use super::wires::{Wires, arms, horizontal, is_rail, is_text, vertical};
use super::{AXIS, GAP, HEADING, MARGIN, RAIL, TEXT_ROW, WIRE, WIRE_ROW, x};
use crate::block::Cell;
use crate::{Ladder, Net, Picture, Rung};
use std::borrow::Cow;
use std::ops::Range;

pub(super) const SANS: &str = "Helvetica, Arial, 'DejaVu Sans', sans-serif";
pub(super) const MONO: &str = "'DejaVu Sans Mono', Consolas, Menlo, monospace";
pub(super) const INK: &str = "#1a1a1a";

/// How text is set.
pub(super) struct Font {
    family: &'static str,
    pub(super) size: f32,
    bold: bool,
    centred: bool,
    /// Whether it ends where it is, and begins elsewhere.
    end: bool,
    /// What a style sheet calls it.
    class: &'static str,
}

impl Font {
    pub(super) const TITLE: Font = Font::new(SANS, 18.0, true, false, "title");
    pub(super) const HEADING: Font = Font::new(SANS, 13.0, true, false, "heading");
    pub(super) const REMARK: Font = Font::new(SANS, 13.0, false, false, "remark");
    /// What a symbol is called.
    pub(super) const POINT: Font = Font::new(SANS, 13.0, false, true, "point");
    /// Within a symbol.
    pub(super) const LETTER: Font = Font::new(SANS, 12.0, true, true, "letter");
    /// Within a box; its width is that of the columns.
    pub(super) const BOXED: Font = Font::new(MONO, 13.5, false, true, "boxed");
    /// When a block runs.
    pub(super) const ORDER: Font = Font::new(SANS, 10.0, false, false, "order");
    /// What a point is named, over its address.
    pub(super) const NAME: Font = Font::new(SANS, 13.0, false, true, "name");
    /// The pins of a box on its left.
    pub(super) const INPUT: Font = Font::new(SANS, 11.5, false, false, "input");
    /// Those on its right.
    pub(super) const OUTPUT: Font = Font {
        end: true,
        ..Font::new(SANS, 11.5, false, false, "output")
    };
    /// What a timer or a counter is to reach, before its pin.
    pub(super) const PRESET: Font = Font {
        end: true,
        ..Font::new(MONO, 13.0, false, false, "preset")
    };
    /// What it has come to, behind its pin.
    pub(super) const COUNT: Font = Font::new(MONO, 13.0, false, false, "count");
    /// Notes and connections.
    pub(super) const NOTE: Font = Font::new(MONO, 13.5, false, false, "note");

    pub(super) const fn new(
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
            end: false,
            class,
        }
    }

    /// A text that looks so by itself, without a style sheet.
    pub(super) fn written(&self, x: f32, y: f32, text: &str) -> Node {
        Node::text(&printable(text))
            .set("x", x)
            .set("y", y)
            .set("fill", INK)
            .set("font-family", self.family)
            .set("font-size", self.size)
            .set("font-weight", if self.bold { "bold" } else { "normal" })
            .set(
                "text-anchor",
                match (self.centred, self.end) {
                    (true, _) => "middle",
                    (false, true) => "end",
                    (false, false) => "start",
                },
            )
    }
}

/// A page that fills from the top.
pub(super) struct Page<'p> {
    pub(super) ladder: &'p Ladder,
    /// Columns, rails included.
    pub(super) width: usize,
    pub(super) group: Node,
    pub(super) y: f32,
    /// On a screen, where a style sheet says how all of it looks, and what is live has a name: the rung that is drawn.
    pub(super) screen: Option<&'p Rung>,
    /// What elements are known by where they are edited.
    pub(super) ids: Option<&'p dyn Fn(usize) -> u32>,
    /// Where elements are.
    pub(super) areas: Vec<(usize, Area)>,
}

impl<'p> Page<'p> {
    /// An empty page of paper, of so many columns, that begins at this height.
    pub(super) fn new(ladder: &'p Ladder, width: usize, y: f32) -> Page<'p> {
        Page {
            ladder,
            width,
            group: Node::group(),
            y,
            screen: None,
            ids: None,
            areas: Vec::new(),
        }
    }

    /// One for a rung on a screen, of so many columns.
    pub(super) fn on_screen(ladder: &'p Ladder, rung: &'p Rung, width: usize) -> Page<'p> {
        Page {
            ladder,
            width,
            group: Node::group(),
            y: 0.0,
            screen: Some(rung),
            ids: None,
            areas: Vec::new(),
        }
    }

    /// A rung under its heading. What comes next is below it, with a gap between.
    pub(super) fn headed(&mut self, heading: &[String], picture: &Picture) {
        self.heading(heading);
        self.rung(picture);
        self.y += GAP;
    }

    /// The heading of a rung.
    pub(super) fn heading(&mut self, heading: &[String]) {
        for (line, text) in heading.iter().enumerate() {
            let font = if line == 0 {
                &Font::HEADING
            } else {
                &Font::REMARK
            };
            self.text(MARGIN, self.y + 12.0, text, font);
            self.y += HEADING;
        }
        self.y += 4.0;
    }

    pub(super) fn text(&mut self, x: f32, y: f32, text: &str, font: &Font) {
        if self.screen.is_some() {
            let text = Node::text(&printable(text)).set("x", x).set("y", y);
            return self.add(text.set("class", font.class));
        }
        self.add(font.written(x, y, text));
    }

    pub(super) fn add(&mut self, node: Node) {
        self.group.add(node);
    }

    pub(super) fn line(&mut self, data: String, width: f32) {
        if self.screen.is_some() {
            let path = Node::path().set("d", data).set("stroke-width", width);
            return self.add(path.set("class", "line"));
        }
        let path = Node::path()
            .set("d", data)
            .set("fill", "none")
            .set("stroke", INK)
            .set("stroke-linecap", "square")
            .set("stroke-width", width);
        self.add(path);
    }

    /// A wire; on a screen one that its net can light.
    pub(super) fn wire(&mut self, data: String, net: Option<Net>) {
        let Some(rung) = self.screen else {
            return self.line(data, WIRE);
        };
        let wire = Node::path().set("d", data);
        self.add(match net {
            None => wire.set("class", "wire"),
            Some(net) => wire.set("class", of_net("wire", rung.net(net))),
        });
    }

    /// The wires on both sides of a symbol, each from one place to another.
    pub(super) fn leads(
        &mut self,
        (before, behind): (Option<Net>, Net),
        left: (f32, f32),
        right: (f32, f32),
        y: f32,
    ) {
        let left = data(&[('M', &[left.0, y]), ('H', &[left.1])]);
        let right = data(&[('M', &[right.0, y]), ('H', &[right.1])]);
        if self.screen.is_none() {
            return self.line(left + &right, WIRE);
        }
        self.wire(left, before);
        self.wire(right, Some(behind));
    }

    /// The edge of a box.
    pub(super) fn edge(&self) -> Node {
        match self.screen {
            Some(_) => Node::rectangle().set("class", "box"),
            None => Node::rectangle().set("fill", "#ffffff").set("stroke", INK),
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
        let mut wires = Wires::new(self.screen.is_some());
        for (index, row) in picture.rows.iter().enumerate() {
            horizontal(row, axes[index], &mut wires);
            if let Some(next) = picture.rows.get(index + 1) {
                vertical(row, next, axes[index], axes[index + 1], &mut wires);
            }
        }
        for (net, data) in wires.paths {
            self.wire(data, net);
        }
        self.rails(top);
        // Symbols hide the ends of wires.
        for row in 0..picture.rows.len() {
            self.row(&picture.rows[row..], &axes[row..]);
        }
    }

    /// From the top of a rung to where it ends; the left one has power while the program runs.
    fn rails(&mut self, top: f32) {
        let right = (self.width - 1) as f32;
        for (column, class) in [(0.0, of_net("rail", 0)), (right, "rail".to_owned())] {
            let rail = data(&[('M', &[x(column + 0.5), top]), ('V', &[self.y])]);
            match self.screen {
                Some(_) => self.add(Node::path().set("d", rail).set("class", class)),
                None => self.line(rail, RAIL),
            }
        }
    }

    /// The symbols and texts of a row: where the wires of it are, and of those below.
    fn row(&mut self, rows: &[Vec<Cell>], axes: &[f32]) {
        let ([row, below @ ..], Some(&axis)) = (rows, axes.first()) else {
            return;
        };
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
                // A box is drawn at its wire, with all that is below it.
                if !text.trim().is_empty() {
                    self.element(element, &text, (column, end), axes, before);
                }
            } else if cell.ch == '→' {
                let (left, right) = (x(column as f32), x(end as f32));
                let (tip, up, down) = (right - 2.0, axis - 4.0, axis + 4.0);
                self.wire(format!("M{left} {axis}H{tip}"), cell.net);
                let back = tip - 6.0;
                self.wire(format!("M{back} {up}L{tip} {axis}L{back} {down}"), cell.net);
            } else if is_text(cell) {
                // Words with single blanks between them.
                let goes_on = |at: usize| row.get(at).is_some_and(|cell| is_text(*cell));
                while goes_on(end) || row.get(end) == Some(&Cell::BLANK) && goes_on(end + 1) {
                    end += 1;
                }
                let text: String = row[column..end].iter().map(|cell| cell.ch).collect();
                let text = text.replace('\0', "");
                if cell.net.is_some() {
                    self.text(x(column as f32), axis + 4.5, &text, &Font::NOTE);
                } else {
                    let symbol = symbol_below(below, column..end);
                    let (from, to) = symbol.map_or((column, end), |(_, columns)| columns);
                    let middle = x((from + to) as f32 / 2.0);
                    // It stands at its symbol, however high the rows between are: others may have wires there.
                    let wire = symbol.and_then(|(row, _)| Some((row, axes.get(row + 1)?)));
                    let y = wire.map_or(axis + 4.5, |(row, wire)| {
                        wire - AXIS - 4.0 - row as f32 * TEXT_ROW
                    });
                    self.text(middle, y, &text, &Font::NAME);
                }
            }
            column = end;
        }
    }
}

/// The symbol that a name in these columns is of: its row, the next or, of a box with pins, the one after; and its columns.
fn symbol_below(rows: &[Vec<Cell>], name: Range<usize>) -> Option<(usize, (usize, usize))> {
    let mut rows = rows.iter().take(2).enumerate();
    rows.find_map(|(index, row)| {
        let element = |column: usize| row.get(column).and_then(|cell| cell.element);
        let within = name.clone().find(|&column| element(column).is_some())?;
        let is_same = |column: &usize| element(*column) == element(within);
        let from = (0..=within).rev().take_while(is_same).last()?;
        let to = (within..row.len()).take_while(is_same).last()? + 1;
        Some((index, (from, to)))
    })
}

/// The class of what a net lights: `wire n7`.
pub(super) fn of_net(class: &str, net: u32) -> String {
    let mut class = [class, " n"].concat();
    digits(net, &mut class);
    class
}

/// What a drawing is called, for who cannot see it.
pub(super) fn titled(about: &str) -> Node {
    Node::title(&printable(about))
}

/// A text without control characters, which XML does not have.
fn printable(text: &str) -> Cow<'_, str> {
    match text.contains(char::is_control) {
        true => text.chars().filter(|ch| !ch.is_control()).collect(),
        false => text.into(),
    }
}
