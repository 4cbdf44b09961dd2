//! The power flow through a network: from the left rail to each output.

use crate::allot::Allotted;
use crate::circuit::{Circuit, Item, Leaf, followed, size};
use crate::found::{Found, span};
use crate::network::{Network, Wire, edge};
use crate::scope::Scope;
use crate::symbol::{Meaning, Symbol};
use crate::ways::{Walk, Ways};
use crate::xml::says;
use std::collections::{HashMap, HashSet};
use unoclp_core::isa::Opcode;
use unoclp_draw::edit::Step;
use unoclp_lang::{Code, Word};
use unoclp_point::Address;

/// How far a call of a block has come.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Call {
    Begun,
    Done,
    /// Something is wrong with it, which has been told.
    Failed,
}

/// Finds circuits.
pub(crate) struct Flow<'f, 'a, 'x> {
    pub network: &'f Network<'a, 'x>,
    pub scope: &'f mut Scope,
    pub all: &'f mut Allotted,
    pub found: &'f mut Found,
    /// Which of the project's programs it is.
    pub pou: usize,
    /// What has to be before the circuit that asks for it.
    pub before: Vec<(usize, Circuit)>,
    /// Which element calls the instance of a block.
    pub called: HashMap<String, usize>,
    /// Blocks that are called in rungs of their own.
    pub calls: HashMap<usize, Call>,
    /// The numbers of the labels of this network, by their names.
    pub labels: HashMap<String, u8>,
    /// The label after the program, where others follow.
    pub end: Option<u8>,
    /// Coils that lead on, but run in their own turn.
    pub apart: HashSet<usize>,
    pub walk: Walk<'a>,
}

impl<'f, 'a, 'x: 'a> Flow<'f, 'a, 'x> {
    pub(crate) fn new(
        pou: usize,
        network: &'f Network<'a, 'x>,
        scope: &'f mut Scope,
        all: &'f mut Allotted,
        found: &'f mut Found,
    ) -> Flow<'f, 'a, 'x> {
        Flow {
            pou,
            network,
            scope,
            all,
            found,
            before: Vec::new(),
            called: HashMap::new(),
            calls: HashMap::new(),
            labels: HashMap::new(),
            end: None,
            apart: HashSet::new(),
            walk: Walk::default(),
        }
    }

    /// The circuit that ends in this output; none, with a message, where something is wrong.
    pub(crate) fn output(&mut self, element: usize) -> Option<Circuit> {
        let drawn = &self.network.elements[element];
        match drawn.kind {
            "coil" if self.apart.contains(&element) => self.ending(element),
            "coil" | "contact" => self.source(Wire {
                from: element,
                output: "",
            }),
            "outVariable" | "inOutVariable" => self.assigned(element),
            "jump" | "return" => {
                let circuit = self.power(element, "")?;
                let step = self.leave(element)?;
                Some(followed(circuit, Leaf::plain((element, 0), step).output()))
            }
            _ => self.called_block(element),
        }
    }

    /// The circuit that ends in this coil.
    fn ending(&mut self, at: usize) -> Option<Circuit> {
        let circuit = self.power(at, "")?;
        self.coil(at, circuit, edge(self.network.elements[at].node))
    }

    /// The jump or the return of this element; after a program that others follow, a return is a jump.
    fn leave(&mut self, at: usize) -> Option<Step> {
        let drawn = &self.network.elements[at];
        let negated = says(drawn.node, "negated");
        let label = match drawn.kind {
            "jump" => {
                let name = drawn.node.attribute("label").unwrap_or_default();
                let Some(&label) = self.labels.get(name) else {
                    self.tell(Code::XmlLabel, at, [name.into()]);
                    return None;
                };
                Some(label)
            }
            _ => self.end,
        };
        Some(match (label, negated) {
            (Some(label), false) => Step::new(Opcode::Jump).with_number(label),
            (Some(label), true) => Step::new(Opcode::JumpNot).with_number(label),
            (None, false) => Step::new(Opcode::Return),
            (None, true) => Step::new(Opcode::ReturnNot),
        })
    }

    /// The circuit to an input of an element.
    pub(crate) fn power(&mut self, element: usize, input: &str) -> Option<Circuit> {
        let mut circuit = self.input(element, input)?;
        let network = self.network;
        let pin = network.elements[element].input(input)?;
        let index = network.elements[element].inputs.iter();
        let index = index.take_while(|other| other.name != pin.name).count();
        if let Some(opcode) = edge_of(pin.edge) {
            if network.is_blocks {
                // There an edge is one of what has been negated.
                self.tell(Code::XmlTangle, element, []);
                return None;
            }
            let leaf = Leaf::plain((element, 100 + index), Step::new(opcode));
            circuit.push(Item::Leaf(leaf.once()));
        }
        if pin.negated {
            let leaf = Leaf::plain((element, 200 + index), Step::new(Opcode::Not));
            circuit.push(Item::Leaf(leaf));
        }
        Some(circuit)
    }

    /// What is written at an element, or at the value that leads to it.
    pub(crate) fn meaning(&mut self, at: usize, written: &str) -> Option<Meaning> {
        let who = Word::from(self.network.name(at));
        let place = span(self.network.elements[at].node);
        let meaning = self
            .scope
            .meaning(written, &who, place, self.all, self.found)?;
        let reads_block = match meaning {
            Meaning::Symbol(symbol) => {
                let of_block = |point| {
                    use Address::{AtZero, Count, Elapsed, Timer};
                    matches!(point, Timer(_) | Elapsed(_) | Count(_) | AtZero(_))
                };
                match symbol {
                    Symbol::At(point) => of_block(point),
                    Symbol::Counter(..) | Symbol::Latch(_) => true,
                    Symbol::Constant(_) | Symbol::Edge => false,
                }
            }
            Meaning::Truth(_) => false,
        };
        let name = written.split('.').next().unwrap_or_default().trim();
        if reads_block && !self.all.called.contains(&name.to_uppercase()) {
            self.tell(Code::XmlNotCalled, at, [name.into()]);
            return None;
        }
        Some(meaning)
    }

    /// Tells that this is of one type where another is wanted.
    pub(crate) fn wants(&mut self, at: usize, written: &str, is: &str, wanted: &str) {
        self.tell(
            Code::XmlType,
            at,
            [written.into(), is.into(), wanted.into()],
        );
    }
}

impl<'f, 'a, 'x: 'a> Ways<'f, 'a, 'x> for Flow<'f, 'a, 'x> {
    // For one project. The largest that fits a board takes a tenth of it.
    const MOST_WORK: usize = 20_000_000;
    const COPIED: usize = 50;

    fn network(&self) -> &'f Network<'a, 'x> {
        self.network
    }

    fn found(&mut self) -> &mut Found {
        self.found
    }

    fn walk(&mut self) -> &mut Walk<'a> {
        &mut self.walk
    }

    fn parts(&self, circuit: &Circuit) -> usize {
        size(circuit)
    }

    fn at_contact(&mut self, at: usize) -> Option<Circuit> {
        let circuit = self.power(at, "")?;
        self.contact(at, circuit)
    }

    fn at_coil(&mut self, at: usize) -> Option<Circuit> {
        match self.apart.contains(&at) {
            true => self.power(at, ""),
            false => self.ending(at),
        }
    }

    fn at_value(&mut self, at: usize) -> Option<Circuit> {
        self.contact(at, Circuit::new())
    }

    fn at_block(&mut self, wire: Wire<'a>) -> Option<Circuit> {
        self.result(wire.from, wire.output)
    }
}

/// The instruction of an edge.
pub(crate) fn edge_of(edge: &str) -> Option<Opcode> {
    match edge {
        "rising" => Some(Opcode::RisingEdge),
        "falling" => Some(Opcode::FallingEdge),
        _ => None,
    }
}
