//! What leads to an input of a block diagram.

use super::super::Body;
use super::super::power::operand;
use super::super::sentences::{Piece, inverted, piece};
use super::super::what::What;
use super::grouped;
use crate::found::span;
use crate::network::{DEEPEST, Wire};
use crate::ways::Ways;
use unoclp_lang::Code;

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// What leads to an input, as it is written there.
    pub(super) fn led(&mut self, at: usize, name: &str) -> Option<Vec<Piece>> {
        let network = self.network;
        let element = &network.elements[at];
        let place = span(element.node);
        let pin = element.input(name).filter(|pin| !pin.wires.is_empty());
        let Some(pin) = pin else {
            let what = match name {
                "" => ("it", "ele").into(),
                name => name.into(),
            };
            self.tell(Code::XmlPin, at, [what]);
            return None;
        };
        let waits = element.kind == "block" && element.order.is_some();
        let mut value = self.joined(&pin.wires, waits)?;
        if pin.negated {
            value = inverted(value, place);
        }
        if !pin.edge.is_empty() {
            value = self.after_edge(at, pin.edge, value);
        }
        self.spend(at, value.len())?;
        Some(value)
    }

    /// What several wires bring: a truth where one of them does.
    fn joined(&mut self, wires: &[Wire<'a>], waits: bool) -> Option<Vec<Piece>> {
        let mut joined: Vec<Piece> = Vec::new();
        for wire in wires {
            let value = self.brought(*wire, waits)?;
            if let Some((_, place)) = joined.last() {
                joined.push(piece(" OR ", *place));
            }
            joined.extend(grouped(value, wires.len() > 1));
        }
        Some(joined)
    }

    /// What a wire brings; one that waits asks for nothing.
    fn brought(&mut self, wire: Wire<'a>, waits: bool) -> Option<Vec<Piece>> {
        let network = self.network;
        let at = wire.from;
        let element = &network.elements[at];
        let place = span(element.node);
        match element.kind {
            "inVariable" | "inOutVariable" => {
                let said = vec![piece(&operand(&element.written), place)];
                Some(if element.negated() {
                    inverted(said, place)
                } else {
                    said
                })
            }
            "continuation" => {
                let connector = network.continued_from(at, self.found)?;
                self.entered(at)?;
                let wires = network.elements[connector].wires("");
                let value = match wires.is_empty() {
                    true => self.led(connector, ""),
                    false => self.joined(wires, waits),
                };
                self.walk.open.pop();
                value
            }
            "block" if self.own[at] == What::Unknown => self.unknown(at),
            "block" => {
                let is_inline = self.own[at].is_function() && !self.kept[at];
                let said = if is_inline {
                    self.entered(at)?;
                    let said = self.inline(at);
                    self.walk.open.pop();
                    said?
                } else {
                    if !waits {
                        self.computed(at)?;
                    }
                    self.given_by(wire)?
                };
                Some(if element.is_negated(wire.output) {
                    inverted(said, place)
                } else {
                    said
                })
            }
            kind => {
                self.tell(Code::XmlElement, at, [kind.into()]);
                None
            }
        }
    }

    /// Goes into an element; none where wires alone have led back to it, or too deep, which is reported.
    pub(super) fn entered(&mut self, at: usize) -> Option<()> {
        let after_block = self.walk.open.get(self.since..).unwrap_or_default();
        if after_block.contains(&at) {
            self.tell(Code::XmlLoop, at, []);
            return None;
        }
        if self.walk.open.len() >= DEEPEST {
            self.too_large(at);
            return None;
        }
        self.walk.open.push(at);
        Some(())
    }
}
