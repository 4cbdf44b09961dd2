//! Contacts and coils.

use crate::circuit::{Circuit, Item, Leaf, Part, followed};
use crate::flow::{Flow, edge_of};
use crate::network::edge;
use crate::symbol::{Counts, Meaning, Symbol, point};
use crate::ways::Ways;
use crate::xml::says;
use unoclp_core::isa::Opcode;
use unoclp_draw::edit::{Coil, Draft, Gate, Step};
use unoclp_lang::Code;
use unoclp_point::Address;

impl<'a, 'x: 'a> Flow<'_, 'a, 'x> {
    /// The circuit with the contact of this element.
    pub(crate) fn contact(&mut self, at: usize, mut circuit: Circuit) -> Option<Circuit> {
        let element = &self.network.elements[at];
        let Some(part) = self.looked_at(at, says(element.node, "negated"))? else {
            return Some(circuit);
        };
        let contact = Leaf::of((at, 0), vec![part]);
        match edge_of(edge(element.node)) {
            None => circuit.push(Item::Leaf(contact)),
            Some(opcode) => {
                let own = vec![
                    Item::Leaf(contact),
                    Item::Leaf(Leaf::plain((at, 1), Step::new(opcode)).once()),
                ];
                match circuit.is_empty() {
                    true => circuit = own,
                    false => circuit.push(Item::Gate((at, 2), Gate::And, own)),
                }
            }
        }
        Some(circuit)
    }

    /// What a contact of what is written at this element looks at; nothing where it is always closed.
    pub(crate) fn looked_at(&mut self, at: usize, negated: bool) -> Option<Option<Part>> {
        let written = &self.network.elements[at].written;
        let meaning = self.meaning(at, written)?;
        let zero = match negated {
            true => Opcode::ZeroContactNot,
            false => Opcode::ZeroContact,
        };
        Some(match meaning {
            Meaning::Truth(truth) => never(truth == negated),
            Meaning::Symbol(Symbol::Constant(number)) => never((number != 0) == negated),
            Meaning::Symbol(
                Symbol::At(Address::AtZero(counter)) | Symbol::Counter(counter, Counts::Down),
            ) => Some(Step::new(zero).with_number(counter).into()),
            Meaning::Symbol(symbol) => {
                let draft =
                    point(symbol).and_then(|point| Draft::contact(Some(point), negated).ok());
                let Some(draft) = draft else {
                    self.wants(at, written, "INT", "BOOL");
                    return None;
                };
                Some(draft.step.into())
            }
        })
    }

    /// The circuit with a coil of what is written at this element, after an edge.
    pub(crate) fn coil(&mut self, at: usize, mut circuit: Circuit, edge: &str) -> Option<Circuit> {
        let element = &self.network.elements[at];
        let written = &element.written;
        let meaning = self.meaning(at, written)?;
        let Meaning::Symbol(symbol) = meaning else {
            self.tell(Code::XmlWritten, at, [written.as_str().into()]);
            return None;
        };
        let mut negated = says(element.node, "negated");
        let coil = match element.node.attribute("storage") {
            Some("set") => Coil::Set,
            Some("reset") => Coil::Reset,
            _ if std::mem::take(&mut negated) => Coil::Negated,
            _ => Coil::Normal,
        };
        let step = match symbol {
            Symbol::At(point @ (Address::Output(_) | Address::Marker(_))) => {
                Draft::coil(Some(point), coil).ok().map(|draft| draft.step)
            }
            Symbol::At(Address::Register(_) | Address::Analogue(_) | Address::Pwm(_)) => {
                self.wants(at, written, "INT", "BOOL");
                return None;
            }
            _ => None,
        };
        let Some(step) = step else {
            self.tell(Code::XmlWritten, at, [written.as_str().into()]);
            return None;
        };
        if let Some(opcode) = edge_of(edge) {
            circuit.push(Item::Leaf(Leaf::plain((at, 1), Step::new(opcode)).once()));
        }
        if negated {
            circuit.push(Item::Leaf(Leaf::plain((at, 2), Step::new(Opcode::Not))));
        }
        Some(followed(circuit, Leaf::plain((at, 0), step).output()))
    }
}

/// A circuit that is always, where `is_not`, never closed; none needs a contact.
fn never(is_not: bool) -> Option<Part> {
    let constant = |opcode| Step::new(opcode).with_number(0).with_lines([Some(0)]);
    is_not.then(|| Part {
        load: Some(constant(Opcode::Load)),
        step: constant(Opcode::NotEqual),
    })
}
