//! Function block diagrams: each block is computed once, when something asks for it first.
//!
//! The order is that of OpenPLC Editor and Beremiz: what has an execution order, by its number; then variables, then the
//! blocks that nothing has asked for. A block with an execution order asks for nothing: it takes what the blocks at its
//! inputs gave last. A result is written where it is taken, or kept in a variable where something could tell the
//! difference.
//!
//! - `wires`: what leads to an input; `blocks`: calls, and the variables that keep results; `results`: functions

mod blocks;
mod results;
mod wires;

use super::Body;
use super::sentences::{Piece, inverted, piece};
use super::what::What;
use crate::found::span;
use crate::network::{Element, Network};
use crate::xml::says;

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// Writes a whole diagram.
    pub(in crate::st) fn diagram(&mut self) {
        self.kept = (0..self.own.len())
            .map(|at| self.is_result_kept(at))
            .collect();
        for at in turns(self.network) {
            self.pass_labels(Some(at));
            let _ = self.act(at);
        }
        self.pass_labels(None);
    }

    /// What an element does when its turn comes.
    fn act(&mut self, at: usize) -> Option<()> {
        let network = self.network;
        let element = &network.elements[at];
        let place = span(element.node);
        match element.kind {
            "outVariable" | "inOutVariable" => self.takes(at),
            "return" => {
                let condition = self.condition(at, says(element.node, "negated"))?;
                self.sentences.only(condition, vec![piece("RETURN", place)]);
                Some(())
            }
            "jump" => self.jump(at),
            "block" => match self.own[at] {
                What::Unknown => self.unknown(at),
                _ if self.own[at].is_function() && !self.kept[at] => Some(()),
                _ => self.computed(at),
            },
            _ => Some(()),
        }
    }

    /// A variable takes what leads to it.
    fn takes(&mut self, at: usize) -> Option<()> {
        let network = self.network;
        let element = &network.elements[at];
        let place = span(element.node);
        let mut value = self.led(at, "")?;
        if element.negated() {
            value = inverted(value, place);
        }
        let to = piece(&format!("{} := ", element.written), place);
        let enables = self.enables(at);
        if let Some(truth) = stored(element) {
            let condition = match enables {
                Some(enables) => {
                    let mut condition = grouped(enables, true);
                    condition.push(piece(" AND ", place));
                    condition.extend(grouped(value, true));
                    condition
                }
                None => value,
            };
            self.sentences
                .only(condition, vec![to, piece(truth, place)]);
            return Some(());
        }
        let mut does = vec![to];
        does.extend(value);
        match enables {
            Some(condition) => self.sentences.only(condition, does),
            None => self.sentences.add(does),
        }
        Some(())
    }

    /// The condition under which a variable takes the only value that leads to it: EN of the block that gives it.
    fn enables(&mut self, at: usize) -> Option<Vec<Piece>> {
        let network = self.network;
        let &[wire] = network.elements[at].wires("") else {
            return None;
        };
        if network.elements[wire.from].kind != "block" || wire.output.eq_ignore_ascii_case("ENO") {
            return None;
        }
        self.eno(wire.from)
    }

    /// What leads to the only input of a jump or a return.
    pub(in crate::st) fn asked(&mut self, at: usize, negated: bool) -> Option<Vec<Piece>> {
        let value = self.led(at, "")?;
        let place = span(self.network.elements[at].node);
        Some(if negated {
            inverted(value, place)
        } else {
            value
        })
    }
}

/// What a variable is set or reset to where its value is TRUE; none of one that takes the value.
fn stored(element: &Element<'_, '_>) -> Option<&'static str> {
    match element.node.attribute("storage") {
        Some("set") => Some("TRUE"),
        Some("reset") => Some("FALSE"),
        _ => None,
    }
}

/// A value that may be beside an operator.
fn grouped(value: Vec<Piece>, is_beside: bool) -> Vec<Piece> {
    let (Some((_, first)), true) = (value.first(), is_beside && value.len() > 1) else {
        return value;
    };
    let at = *first;
    let mut grouped = vec![piece("(", at)];
    grouped.extend(value);
    grouped.push(piece(")", at));
    grouped
}

/// The elements that do something by themselves, in the order in which they do; labels, jumps and returns part them.
fn turns(network: &Network<'_, '_>) -> Vec<usize> {
    let elements = network.elements.iter().enumerate();
    let acts = elements.filter(|(_, element)| match element.kind {
        "inOutVariable" => !element.wires("").is_empty(),
        _ if element.is_loose() => false,
        kind => matches!(kind, "outVariable" | "jump" | "return" | "block"),
    });
    let mut turns: Vec<usize> = acts.map(|(at, _)| at).collect();
    let parts = |at: &usize| matches!(network.elements[*at].kind, "label" | "jump" | "return");
    let mut parting: Vec<_> = (0..network.elements.len())
        .filter(parts)
        .map(|at| network.turn(at))
        .collect();
    parting.sort_unstable();
    turns.sort_by_cached_key(|&at| {
        let element = &network.elements[at];
        let part = parting.partition_point(|parting| *parting < network.turn(at));
        let order = element.order.unwrap_or(u32::MAX);
        let is_block = element.kind == "block" && element.order.is_none();
        (part, parts(&at), order, is_block, network.turn(at))
    });
    turns
}
