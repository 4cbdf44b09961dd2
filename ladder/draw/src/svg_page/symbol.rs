//! The symbols of elements.

use super::area::Area;
use super::node::data;
use super::page::{Font, Page};
use super::{COLUMN, HALF, screen, x};
use crate::{Element, Net, Symbol};

impl Page<'_> {
    /// An element between two columns; `text` is what it is in characters, `before` the net before it.
    pub(super) fn element(
        &mut self,
        index: usize,
        text: &str,
        columns: (usize, usize),
        y: f32,
        before: Option<Net>,
    ) {
        let ladder = self.ladder;
        let Some(element) = ladder.elements.get(index) else {
            return;
        };
        let Some(rung) = self.screen else {
            return self.symbol(element, text, columns, y, before);
        };
        let outer = std::mem::take(&mut self.group);
        self.symbol(element, text, columns, y, before);
        let inner = std::mem::replace(&mut self.group, outer);
        let mut named = screen::of_symbol(element, rung, inner, columns, y);
        if let Some(ids) = self.ids {
            named = named.set("data-id", ids(index));
            self.areas.push((index, Area::of_symbol(columns, y)));
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
                self.line(bars(a, b, above, below), 1.8);
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
                    self.wire(format!("M{behind} {y}H{}", start - 2.0), Some(element.net));
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
        self.line(bars(a, b, above, below), 1.8);
        self.text(middle, y + 4.5, text, &Font::LETTER);
    }
}

/// Two lines from above to below.
fn bars(a: f32, b: f32, above: f32, below: f32) -> String {
    data(&[
        ('M', &[a, above]),
        ('V', &[below]),
        ('M', &[b, above]),
        ('V', &[below]),
    ])
}
