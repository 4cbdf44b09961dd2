//! The same as a block diagram: what is in series are inputs of an AND, what is in parallel those of an OR.
//!
//! Nothing is drawn for the left rail: where only that leads, TRUE does, or nothing.

use super::counters::input;
use super::draw::{COLUMN, Draw, ROW, Wire};
use super::xml::{At, Source};
use unoclp_core::isa::Class;
use unoclp_draw::edit::{Block, Element, Gate, Node};

/// The left rail.
const RAIL: Source = (0, "");

impl Draw {
    /// The beginning of a way.
    pub(super) fn first_of_blocks(&self) -> Wire {
        let at = At { x: 20, y: self.row };
        let from = vec![RAIL];
        Wire { from, at }
    }

    /// Draws what is in series; contacts right after each other are inputs of one AND. `last`: after so many pieces at the
    /// end nothing more asks for the power.
    pub(super) fn series_of_blocks(
        &mut self,
        series: &[Node],
        (wire, rail): (&mut Wire, &Wire),
        last: usize,
    ) {
        let mut rest = series;
        while let Some((first, after)) = rest.split_first() {
            self.meet(wire);
            let contacts = rest.iter().map_while(contact).collect::<Vec<_>>();
            if !contacts.is_empty() {
                rest = &rest[contacts.len()..];
                self.contacts(&contacts, rest.len() <= last, wire);
                continue;
            }
            rest = after;
            self.node(first, wire, rail);
        }
    }

    /// Leads several wires to an OR, which goes on as one.
    fn meet(&mut self, wire: &mut Wire) {
        if wire.from.len() < 2 {
            return;
        }
        let from = std::mem::take(&mut wire.from);
        let pins: Vec<(Source, bool)> = from.into_iter().map(|from| (from, false)).collect();
        self.gate_block("OR", &pins, wire);
    }

    /// What leads to an element: one wire, and where that is the left rail, TRUE.
    pub(super) fn lead(&mut self, wire: &mut Wire) {
        self.meet(wire);
        if wire.from == [RAIL] {
            wire.from = vec![self.value_of("TRUE", wire.at)];
        }
    }

    /// What leads to EN: in a block diagram nothing, where it is the left rail.
    pub(super) fn enables(&self, wire: &Wire) -> Vec<Source> {
        match self.is_blocks && wire.from == [RAIL] {
            true => Vec::new(),
            false => wire.from.clone(),
        }
    }

    /// Draws contacts in series. `is_asked_once`: a variable needs no block that reads it once for several.
    fn contacts(&mut self, contacts: &[&Element], is_asked_once: bool, wire: &mut Wire) {
        let is_first = wire.from == [RAIL];
        if let ([contact], true, true) = (contacts, is_first, is_asked_once) {
            let negated = contact.step.opcode().is_inverted();
            let counter = self.counter_read(contact).filter(|_| !negated);
            if let Some(counter) = counter {
                wire.from = vec![counter];
            } else if let Some(variable) = self.read(contact) {
                let at = wire.at;
                wire.from = vec![self.body.value(&variable, negated, at)];
            }
            wire.at.x += COLUMN;
            return;
        }
        let mut pins: Vec<(Source, bool)> = match is_first && contacts.len() > 1 {
            true => Vec::new(),
            false => wire.from.iter().map(|from| (*from, false)).collect(),
        };
        for contact in contacts {
            let source = match self.counter_read(contact) {
                Some(counter) => Some(counter),
                None => {
                    let variable = self.read(contact);
                    variable.map(|variable| self.value_of(&variable, wire.at))
                }
            };
            let negated = contact.step.opcode().is_inverted();
            pins.extend(source.map(|source| (source, negated)));
        }
        self.gate_block("AND", &pins, wire);
    }

    /// The output of a counter's block that a contact reads, where the block stands before it.
    fn counter_read(&self, contact: &Element) -> Option<Source> {
        let number = contact.step.number()?;
        let output = self.output_read(contact)?;
        self.drawn.get(&number).map(|block| (*block, output))
    }

    /// AND, OR and XOR of two ways.
    pub(super) fn gate_of_blocks(&mut self, block: &Block, wire: &mut Wire, rail: &Wire) {
        self.lead(wire);
        let before = wire.from.clone();
        self.row += ROW;
        let mut way = rail.clone();
        way.at.y = self.row;
        let values = self.values.clone();
        self.series_of_blocks(&block.path.series, (&mut way, rail), 0);
        if self.values != values {
            self.values = Default::default();
        }
        self.lead(&mut way);
        // A variable right at the input would stand in series.
        if let [only] = &block.path.series[..]
            && contact(only).is_some()
        {
            let truth = self.value_of("TRUE", way.at);
            let from = way.from.iter().map(|from| (*from, false));
            let pins: Vec<_> = std::iter::once((truth, false)).chain(from).collect();
            self.gate_block("AND", &pins, &mut way);
        }
        let kind = match block.gate {
            Gate::And => "AND",
            Gate::Or => "OR",
            Gate::Xor => "XOR",
        };
        let pins: Vec<_> = [before, way.from].concat();
        let pins: Vec<_> = pins.into_iter().map(|from| (from, false)).collect();
        wire.at.x = wire.at.x.max(way.at.x);
        self.gate_block(kind, &pins, wire);
    }

    /// A gate, after which the wire goes on; a pin may be negated.
    fn gate_block(&mut self, kind: &str, pins: &[(Source, bool)], wire: &mut Wire) {
        let names: Vec<String> = pins
            .iter()
            .enumerate()
            .map(|(at, (_, negated))| {
                let sign = if *negated { "!" } else { "" };
                format!("{sign}IN{}", at + 1)
            })
            .collect();
        let mut inputs: Vec<(&str, [Source; 1])> = Vec::new();
        for (name, (from, _)) in names.iter().zip(pins) {
            let from = match *from == RAIL {
                true => self.value_of("TRUE", wire.at),
                false => *from,
            };
            inputs.push((name, [from]));
        }
        let inputs: Vec<(&str, &[Source])> = inputs
            .iter()
            .map(|(name, from)| (*name, &from[..]))
            .collect();
        let id = self.body.block(kind, None, &inputs, &["OUT"], wire.at);
        wire.from = vec![(id, "OUT")];
        wire.at.x += COLUMN;
    }
}

/// The contact that this is.
fn contact(node: &Node) -> Option<&Element> {
    match node {
        Node::Element(element) => {
            let class = element.step.class();
            let is_contact = matches!(class, Class::Contact | Class::Condition);
            (is_contact && input(&element.step).is_none()).then_some(element)
        }
        _ => None,
    }
}
