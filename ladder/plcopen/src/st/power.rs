//! The power flow to an element, as an expression.

use super::Body;
use super::sentences::{Piece, inverted, piece};
use super::what::What;
use crate::circuit::{Circuit, Item, Key, Leaf, leaves};
use crate::found::{Found, span};
use crate::network::{Network, Wire, edge};
use crate::ways::{Walk, Ways};
use crate::xml::says;
use unoclp_lang::{Code, Span};

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// What leads to an input, as it is written there.
    pub(super) fn given(&mut self, at: usize, name: &str) -> Option<Vec<Piece>> {
        let circuit = self.input(at, name)?;
        let (negated, edge) = {
            let pin = self.network.elements[at].input(name)?;
            (pin.negated, pin.edge)
        };
        let value = self.said(&circuit, negated);
        Some(match edge {
            "" => value,
            edge => self.after_edge(at, edge, value),
        })
    }

    fn contact(&mut self, at: usize) -> Option<Circuit> {
        let network = self.network;
        let element = &network.elements[at];
        let place = span(element.node);
        self.declared(at)?;
        let mut circuit = self.input(at, "")?;
        let text = operand(&element.written);
        let mut said = match says(element.node, "negated") {
            true => vec![piece(&format!("NOT {text}"), place)],
            false => vec![piece(&text, place)],
        };
        let edge = edge(element.node);
        if !edge.is_empty() {
            said = self.after_edge(at, edge, said);
        }
        let leaf = self.leaf((at, 0), said);
        circuit.push(leaf);
        Some(circuit)
    }

    /// Whether something declares the variable of a contact or a coil, which is reported otherwise.
    pub(super) fn declared(&mut self, at: usize) -> Option<()> {
        let written = &self.network.elements[at].written;
        let name = written.split(['.', '[']).next().unwrap_or_default();
        let name = name.trim().to_uppercase();
        if name.is_empty() {
            self.tell(Code::XmlNoVariable, at, []);
            return None;
        }
        let is_name = name.chars().all(|c| c.is_alphanumeric() || c == '_')
            && !matches!(&*name, "TRUE" | "FALSE" | "0" | "1");
        let is_result = self.result.as_ref().is_some_and(|(own, _)| *own == name);
        if is_name && !is_result && !self.variables.contains_key(&name) {
            self.tell(Code::XmlUndeclared, at, [written.as_str().into()]);
            return None;
        }
        Some(())
    }

    /// The same power, in a variable.
    pub(super) fn keep(&mut self, at: usize, circuit: &Circuit) -> Circuit {
        let name = self.add("power", "BOOL", at);
        let place = span(self.network.elements[at].node);
        let mut does = vec![piece(&format!("{name} := "), place)];
        does.extend(self.said(circuit, false));
        self.sentences.add(does);
        vec![self.leaf((at, 9), vec![piece(&name, place)])]
    }

    /// Whether a value has risen or fallen.
    pub(super) fn after_edge(&mut self, at: usize, edge: &str, value: Vec<Piece>) -> Vec<Piece> {
        let kind = if edge == "rising" { "R_TRIG" } else { "F_TRIG" };
        let name = self.add("edge", kind, at);
        let place = span(self.network.elements[at].node);
        let mut call = vec![piece(&format!("{name}(CLK := "), place)];
        call.extend(value);
        call.push(piece(")", place));
        self.sentences.add(call);
        vec![piece(&format!("{name}.Q"), place)]
    }

    pub(super) fn leaf(&mut self, key: Key, said: Vec<Piece>) -> Item {
        self.words.insert(key, said);
        Item::Leaf(Leaf::of(key, Vec::new()))
    }

    /// A circuit as an expression.
    pub(super) fn said(&self, circuit: &[Item], negated: bool) -> Vec<Piece> {
        let mut pieces = Vec::new();
        self.series(circuit, &mut pieces);
        match pieces.first() {
            Some((_, at)) if negated => inverted(pieces.clone(), *at),
            _ => pieces,
        }
    }

    fn series(&self, circuit: &[Item], pieces: &mut Vec<Piece>) {
        let at = pieces.last().map_or(Span::default(), |(_, at)| *at);
        if circuit.is_empty() {
            pieces.push(piece("TRUE", at));
        }
        for (index, item) in circuit.iter().enumerate() {
            if index > 0 {
                let at = pieces.last().map_or(at, |(_, at)| *at);
                pieces.push(piece(" AND ", at));
            }
            match item {
                Item::Leaf(leaf) => {
                    pieces.extend(self.words.get(&leaf.key).into_iter().flatten().cloned());
                }
                Item::Parallel { ways, .. } => {
                    pieces.push(piece("(", at));
                    for (index, way) in ways.iter().enumerate() {
                        if index > 0 {
                            pieces.push(piece(" OR ", at));
                        }
                        self.series(way, pieces);
                    }
                    pieces.push(piece(")", at));
                }
                Item::Gate(_, _, circuit) => self.series(circuit, pieces),
            }
        }
    }
}

impl<'n, 'a, 'x: 'a> Ways<'n, 'a, 'x> for Body<'n, 'a, 'x> {
    const MOST_WORK: usize = 1_000_000;
    const COPIED: usize = 1;

    fn network(&self) -> &'n Network<'a, 'x> {
        self.network
    }

    fn found(&mut self) -> &mut Found {
        self.found
    }

    fn walk(&mut self) -> &mut Walk<'a> {
        &mut self.walk
    }

    fn parts(&self, circuit: &Circuit) -> usize {
        let mut parts = 0;
        leaves(circuit, &mut |leaf| {
            parts += self.words.get(&leaf.key).map_or(1, Vec::len);
        });
        parts
    }

    /// Wires that lead back to a block bring what it gave before.
    fn back(&mut self, wire: Wire<'a>) -> Option<Option<Circuit>> {
        let at = wire.from;
        if self.own[at] == What::Block && self.begun.contains_key(&at) {
            return Some(self.gives(wire));
        }
        let name = self.names.get(&at)?;
        if !self.walk.open.contains(&at) || wire.output.eq_ignore_ascii_case("ENO") {
            return None;
        }
        let said = vec![piece(&name.clone(), span(self.network.elements[at].node))];
        Some(Some(vec![self.leaf((at, 1), said)]))
    }

    fn at_contact(&mut self, at: usize) -> Option<Circuit> {
        self.contact(at)
    }

    fn at_coil(&mut self, at: usize) -> Option<Circuit> {
        self.input(at, "")
    }

    fn at_value(&mut self, at: usize) -> Option<Circuit> {
        let element = &self.network.elements[at];
        let place = span(element.node);
        let mut said = vec![piece(&operand(&element.written), place)];
        if element.negated() {
            said = inverted(said, place);
        }
        Some(vec![self.leaf((at, 0), said)])
    }

    fn at_block(&mut self, wire: Wire<'a>) -> Option<Circuit> {
        match self.own[wire.from] {
            What::Block => {
                self.block(wire.from)?;
                self.gives(wire)
            }
            own if own.is_function() => self.function(wire),
            _ => self.unknown(wire.from),
        }
    }
}

/// What is written, so that it may be beside an operator.
pub(super) fn operand(written: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_.#%[]:".contains(c);
    match written.chars().all(is_plain) {
        true => written.to_owned(),
        false => format!("({written})"),
    }
}
