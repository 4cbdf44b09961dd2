//! The way of the power to an element, as an expression.

use super::Body;
use super::sentences::{Piece, inverted, piece};
use super::what::What;
use crate::circuit::{Circuit, Item, Key, Leaf, leaves, together};
use crate::found::span;
use crate::network::{DEEPEST, Wire, edge};
use crate::xml::says;
use unoclp_lang::{Code, Span};

/// An expression has no more parts.
const LARGEST: usize = 2_000;

/// All expressions of a body have no more.
const MOST_WORK: usize = 1_000_000;

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// The way to an input of an element; none where something is wrong, which is told.
    pub(super) fn input(&mut self, at: usize, name: &str) -> Option<Circuit> {
        let network = self.network;
        let pin = network.elements[at].input(name);
        let Some(pin) = pin.filter(|pin| !pin.wires.is_empty()) else {
            let what = match name {
                "" => ("it", "ele").into(),
                name => name.into(),
            };
            self.tell(Code::XmlPin, at, [what]);
            return None;
        };
        let mut ways = Vec::with_capacity(pin.wires.len());
        for &wire in &pin.wires {
            let way = self.source(wire)?;
            self.spend(at, &way)?;
            ways.push(way);
        }
        let circuit = match ways.len() {
            1 => ways.remove(0),
            _ => together(ways),
        };
        Some(circuit)
    }

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

    /// The way to the beginning of a wire.
    pub(super) fn source(&mut self, wire: Wire<'a>) -> Option<Circuit> {
        if let Some(known) = self.known.get(&wire) {
            return known.clone();
        }
        let at = wire.from;
        // Wires that lead back to a block bring what it gave before.
        if self.own[at] == What::Block && self.begun.contains_key(&at) {
            return self.gives(wire);
        }
        if let Some(name) = self.names.get(&at)
            && self.open.contains(&at)
            && !wire.output.eq_ignore_ascii_case("ENO")
        {
            let said = vec![piece(&name.clone(), span(self.network.elements[at].node))];
            return Some(vec![self.leaf((at, 1), said)]);
        }
        if self.open.contains(&at) {
            self.tell(Code::XmlLoop, at, []);
            return None;
        }
        if self.open.len() >= DEEPEST {
            self.too_large(at);
            return None;
        }
        self.open.push(at);
        let circuit = self.begin(wire);
        self.open.pop();
        self.known.insert(wire, circuit.clone());
        circuit
    }

    fn begin(&mut self, wire: Wire<'a>) -> Option<Circuit> {
        let network = self.network;
        let at = wire.from;
        let element = &network.elements[at];
        match element.kind {
            "leftPowerRail" => Some(Circuit::new()),
            "contact" => self.contact(at),
            "coil" => self.input(at, ""),
            "inVariable" | "inOutVariable" => {
                let place = span(element.node);
                let mut said = vec![piece(&operand(&element.written), place)];
                if element.negated() {
                    said = inverted(said, place);
                }
                Some(vec![self.leaf((at, 0), said)])
            }
            "continuation" => {
                let connector = network.continued_from(at, self.found)?;
                self.input(connector, "")
            }
            "block" if self.own[at] == What::Block => {
                self.block(at)?;
                self.gives(wire)
            }
            "block" if self.own[at].is_function() => self.function(wire),
            "block" => self.unknown(at),
            kind => {
                self.tell(Code::XmlElement, at, [kind.into()]);
                None
            }
        }
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

    /// Whether something declares the variable of a contact or a coil, which is told otherwise.
    pub(super) fn declared(&mut self, at: usize) -> Option<()> {
        let written = &self.network.elements[at].written;
        let name = written.split(['.', '[']).next().unwrap_or_default();
        let name = name.trim().to_uppercase();
        if name.is_empty() {
            self.tell(Code::XmlPin, at, [("a variable", "uma variável").into()]);
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

    /// Counts the parts of a circuit; none where they are too many, which is told.
    fn spend(&mut self, at: usize, circuit: &[Item]) -> Option<()> {
        let mut parts = 1;
        leaves(circuit, &mut |leaf| {
            parts += self.words.get(&leaf.key).map_or(1, Vec::len);
        });
        if parts > LARGEST {
            self.too_large(at);
            return None;
        }
        self.look(at, parts)
    }

    /// Counts what is looked at for an element; none where it is too much, which is told.
    pub(super) fn look(&mut self, at: usize, parts: usize) -> Option<()> {
        self.work += parts;
        if self.work > MOST_WORK {
            self.too_large(at);
            return None;
        }
        Some(())
    }

    pub(super) fn too_large(&mut self, at: usize) {
        self.network.too_large(at, self.found);
    }
}

/// What is written, so that it may stand beside an operator.
fn operand(written: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_.#%[]:".contains(c);
    match written.chars().all(is_plain) {
        true => written.to_owned(),
        false => format!("({written})"),
    }
}
