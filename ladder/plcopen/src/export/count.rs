//! The block of a counter.

use super::counters::input;
use super::draw::{Draw, ROW};
use super::xml::{At, Source};
use unoclp_draw::edit::{Element, Node, Rung};
use unoclp_point::Address;

impl Draw {
    /// Draws the rungs that are the inputs of one counter.
    pub(crate) fn counter(&mut self, rungs: &[&Rung]) {
        let mut inputs = Vec::new();
        let mut at: Option<At> = None;
        let mut block = None;
        for rung in rungs {
            let Some((Node::Element(last), series)) = rung.series.split_last() else {
                continue;
            };
            if block.is_some() {
                self.rung += 1;
                self.row += ROW;
            }
            let block = block.get_or_insert(last);
            let alike = last.step.lines().is_empty() || last.step.lines() == block.step.lines();
            if !alike {
                self.lose(last.id, last.step.opcode().row().letters);
            }
            let mut wire = self.way(series);
            if self.is_blocks {
                self.lead(&mut wire);
            }
            let (x, y) = at.map_or((0, wire.at.y), |at| (at.x, at.y));
            at = Some(At {
                x: x.max(wire.at.x),
                y,
            });
            self.row = self.row.max(wire.at.y);
            inputs.extend(input(&last.step).map(|(_, name)| (name, wire.from)));
        }
        if let (Some(block), Some(at)) = (block, at) {
            self.count(block, &inputs, at);
        }
        self.row += 2 * ROW;
    }

    /// The instance of a counter; none where it is no block.
    pub(crate) fn counted(&mut self, number: u8) -> Option<String> {
        let kind = self.counters.kind(number)?;
        Some(self.variables.of(Address::Counter(number), kind))
    }

    /// The output that says whether a counter has reached its preset, or is at 0.
    pub(crate) fn reached(&self, number: u8, zero: bool) -> Option<&'static str> {
        Some(match (self.counters.kind(number)?, zero) {
            ("CTU", false) | ("CTD", true) => "Q",
            ("CTUD", false) => "QU",
            ("CTUD", true) => "QD",
            _ => return None,
        })
    }

    /// Draws the block of the counter that this instruction counts, with these inputs.
    pub(crate) fn count(&mut self, count: &Element, from: &[(&str, Vec<Source>)], at: At) -> u32 {
        let number = count.step.number().unwrap_or(0);
        let preset = count.step.lines().first().copied().flatten();
        let kind = self.counters.kind(number);
        let (Some(kind), Some(instance)) = (kind, self.counted(number)) else {
            self.lose(count.id, count.step.opcode().row().letters);
            return 0;
        };
        let preset = [self.value_of(&preset.unwrap_or(0).to_string(), at)];
        let mut inputs: Vec<(&str, &[Source])> =
            from.iter().map(|(name, from)| (*name, &from[..])).collect();
        inputs.push(("PV", &preset));
        let outputs: &[&str] = match kind {
            "CTUD" => &["QU", "QD", "CV"],
            _ => &["Q", "CV"],
        };
        let block = self.body.block(kind, Some(&instance), &inputs, outputs, at);
        if self.is_blocks {
            self.drawn.insert(number, block);
        }
        block
    }
}
