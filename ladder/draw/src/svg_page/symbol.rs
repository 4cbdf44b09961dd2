//! The symbols of elements.

use super::area::Area;
use super::named::named;
use super::node::data;
use super::page::{Font, Page};
use super::{AXIS, COLUMN, HALF, SYMBOL, WIRE, x};
use crate::pins::Pins;
use crate::{Element, Net, Symbol};

impl Page<'_> {
    /// An element between two columns; `text` is what it is in characters, `before` the net before it, `axes` the heights of
    /// its wire and of the rows below.
    pub(super) fn element(
        &mut self,
        index: usize,
        text: &str,
        columns: (usize, usize),
        axes: &[f32],
        before: Option<Net>,
    ) {
        let ladder = self.ladder;
        let (Some(element), Some(&y)) = (ladder.elements.get(index), axes.first()) else {
            return;
        };
        // In a drawing of characters its box has none.
        let pins = element.pins.as_ref();
        let pins = pins.filter(|_| text == Pins::text());
        let outer = self.screen.map(|_| std::mem::take(&mut self.group));
        let area = match (pins, axes.get(1)) {
            (Some(pins), Some(&last)) => {
                self.pins(element, pins, columns, (y, last));
                Area::of_box(columns, y, last)
            }
            _ => {
                self.symbol(element, text, columns, y, before);
                Area::of_symbol(columns, y)
            }
        };
        let (Some(rung), Some(outer)) = (self.screen, outer) else {
            return;
        };
        let inner = std::mem::replace(&mut self.group, outer);
        let value = pins.is_none().then_some(area.y + 11.0);
        let target = Area {
            height: area.height - 1.0,
            ..area
        };
        let mut named = named(element, rung, inner, target, value);
        if let Some(ids) = self.ids {
            named = named.set("data-id", ids(index));
            self.areas.push((index, area));
        }
        self.add(named);
    }

    /// A box with pins: those on the wire, and those of the row below it.
    fn pins(
        &mut self,
        element: &Element,
        pins: &Pins,
        (from, to): (usize, usize),
        (y, last): (f32, f32),
    ) {
        let (left, right) = (x(from as f32), x(to as f32));
        let middle = (left + right) / 2.0;
        self.frame((left, right), (y - AXIS, last + HALF - 2.0));
        let address = element.point.map(|point| point.to_string());
        self.text(
            middle,
            y - AXIS - 4.0,
            &address.unwrap_or_default(),
            &Font::POINT,
        );
        self.text(middle, y - 12.0, pins.title, &Font::LETTER);
        let sides = pins.inputs.into_iter().zip(pins.outputs);
        for (row, (input, output)) in [y, last].into_iter().zip(sides) {
            self.text(left + 5.0, row + 4.0, input, &Font::INPUT);
            self.text(right - 5.0, row + 4.0, output, &Font::OUTPUT);
        }
        let stub = |at: f32| format!("M{at} {last}H{}", at + STUB);
        self.line(stub(left - STUB) + &stub(right), SYMBOL);
        let (before, behind) = (left - STUB - 3.0, right + STUB + 3.0);
        self.text(before, last + 4.5, &pins.preset, &Font::PRESET);
        if self.screen.is_some() {
            self.text(behind, last + 4.5, "", &Font::COUNT);
        }
    }

    /// A box between these edges.
    fn frame(&mut self, (left, right): (f32, f32), (above, below): (f32, f32)) {
        let edge = self
            .edge()
            .set("stroke-width", SYMBOL)
            .set("x", left)
            .set("y", above)
            .set("width", right - left)
            .set("height", below - above);
        self.add(edge);
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
                self.leads(nets, (left, a - BAR), (b + BAR, right), y);
                self.line(bars(a, b, above, below), SYMBOL);
                if *closed {
                    let (a, b) = (a - 1.0, b + 1.0);
                    self.line(format!("M{a} {below}L{b} {above}"), WIRE);
                }
                self.text(middle, above - 4.0, text, &Font::POINT);
            }
            Symbol::Inline(text) => self.inline(text, (left, right), y, nets),
            Symbol::Coil { letter, text } => {
                let (a, b) = (middle - 8.0, middle + 8.0);
                self.leads(nets, (left, a - BAR), (b + BAR, right), y);
                let (c, d) = (middle - 4.0, middle + 4.0);
                let arcs = format!(
                    "M{c} {above}A11 11 0 0 0 {c} {below}M{d} {above}A11 11 0 0 1 {d} {below}"
                );
                self.line(arcs, SYMBOL);
                match letter {
                    ' ' => {}
                    '/' => self.line(format!("M{c} {below}L{d} {above}"), WIRE),
                    letter => self.text(middle, y + 4.5, &letter.to_string(), &Font::LETTER),
                }
                self.text(middle, above - 4.0, text, &Font::POINT);
            }
            Symbol::Box { .. } => {
                let inside = text.trim_start_matches("[ ").trim_end_matches(" ]");
                self.frame((left, right), (above - 2.0, below + 2.0));
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
        self.leads(nets, (left, a - BAR), (b + BAR, right), y);
        self.line(bars(a, b, above, below), SYMBOL);
        self.text(middle, y + 4.5, text, &Font::LETTER);
    }
}

/// Half the width of the lines that wires end at: their ends are round.
const BAR: f32 = 1.0;
/// The line of a pin that no wire leads to.
const STUB: f32 = 5.0;

/// Two lines from above to below.
fn bars(a: f32, b: f32, above: f32, below: f32) -> String {
    data(&[
        ('M', &[a, above]),
        ('V', &[below]),
        ('M', &[b, above]),
        ('V', &[below]),
    ])
}
