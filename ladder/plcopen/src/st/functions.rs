//! Results of functions.

use super::Body;
use super::sentences::{Piece, inverted, piece};
use super::what::What;
use crate::circuit::Circuit;
use crate::found::span;
use crate::network::{Reader, Wire};
use crate::ways::Ways;
use unoclp_lang::Code;
use unoclp_lang::typed::usual;

impl<'a, 'x: 'a> Body<'_, 'a, 'x> {
    /// What a function gives at an output.
    pub(super) fn function(&mut self, wire: Wire<'a>) -> Option<Circuit> {
        let at = wire.from;
        let mut circuit = self.enabled(at)?;
        if wire.output.eq_ignore_ascii_case("ENO") {
            // What it stores is stored before the power goes on.
            self.store(at)?;
            return Some(circuit);
        }
        let element = &self.network.elements[at];
        let place = span(element.node);
        let negated = element.is_negated(wire.output);
        let mut said = if self.is_kept(at) {
            circuit = Circuit::new();
            vec![piece(&self.kept(at)?, place)]
        } else {
            self.applied(at)?
        };
        if negated {
            said = inverted(said, place);
        }
        circuit.push(self.leaf((at, 1), said));
        Some(circuit)
    }

    /// Whether a variable takes the result of a function right where that is computed.
    pub(super) fn is_stored_by(&mut self, at: usize, output: &str) -> bool {
        self.own[at].is_function() && !output.eq_ignore_ascii_case("ENO") && self.stores_result(at)
    }

    /// Whether variables take a result where it is computed: numbers, and what they keep while EN has no power.
    fn stores_result(&mut self, at: usize) -> bool {
        !self.is_truth(at) || !self.network.elements[at].wires("EN").is_empty()
    }

    /// The variables that take the result right there, and how often it is taken elsewhere.
    fn takers(&mut self, at: usize) -> (Vec<usize>, usize) {
        let network = self.network;
        let is_stored = self.stores_result(at);
        let (mut variables, mut others) = (Vec::new(), 0);
        let readers = network.readers[at].iter();
        let is_result = |reader: &&Reader<'_>| !reader.output.eq_ignore_ascii_case("ENO");
        for reader in readers.filter(is_result) {
            let by = &network.elements[reader.at];
            let stores = matches!(by.kind, "outVariable" | "inOutVariable");
            match stores && is_stored && by.wires("").len() == 1 {
                true => variables.push(reader.at),
                false if network.is_end(reader.at) => {}
                false => others += 1,
            }
        }
        (variables, others)
    }

    /// Whether a variable keeps the result: it is taken more than once, or beyond the condition under which it is computed.
    fn is_kept(&mut self, at: usize) -> bool {
        let (variables, others) = self.takers(at);
        let has_condition = self.has_condition(at);
        let goes_through = self.is_truth(at) && self.own[at] != What::Own;
        self.circles[at]
            || others > 1
            || variables.len() > 1
            || others > 0 && (!variables.is_empty() || has_condition && !goes_through)
    }

    fn has_condition(&self, at: usize) -> bool {
        let known = self.enabled.get(&at).and_then(|known| known.as_ref());
        known.is_some_and(|circuit| !circuit.is_empty())
    }

    /// The variable that keeps the result, which is computed once.
    fn kept(&mut self, at: usize) -> Option<String> {
        if let Some(name) = self.names.get(&at) {
            return self
                .begun
                .get(&at)
                .copied()
                .unwrap_or(true)
                .then(|| name.clone());
        }
        let kind = self.kind(at);
        let what = self.network.elements[at].block();
        let name = self.add(&what, &kind, at);
        self.names.insert(at, name.clone());
        self.begun.insert(at, true);
        let computed = self.compute(at, &name);
        self.begun.insert(at, computed.is_some());
        computed.map(|()| name)
    }

    fn compute(&mut self, at: usize, name: &str) -> Option<()> {
        let place = span(self.network.elements[at].node);
        let enabled = self.enabled(at)?;
        let value = self.applied(at)?;
        let mut does = vec![piece(&format!("{name} := "), place)];
        let is_truth = self.is_truth(at);
        if is_truth && self.own[at] != What::Own {
            if !enabled.is_empty() {
                does.extend(self.said(&enabled, false));
                does.push(piece(" AND ", place));
            }
            does.extend(value);
            self.sentences.add(does);
            return Some(());
        }
        does.extend(value);
        let otherwise = is_truth.then(|| vec![piece(&format!("{name} := FALSE"), place)]);
        self.when(at, &enabled, does, otherwise);
        Some(())
    }

    /// Stores the result of a function in a variable after it, at the variable's turn; in all of them where power goes on.
    pub(super) fn store_in(&mut self, at: usize, variable: usize) -> Option<()> {
        let mut readers = self.network.readers[at].iter();
        match readers.any(|reader| reader.output.eq_ignore_ascii_case("ENO")) {
            true => self.store(at),
            false => self.stores_within(at, &[variable]),
        }
    }

    /// Stores the result of a function in the variables after it, once.
    pub(super) fn store(&mut self, at: usize) -> Option<()> {
        if !self.stored.insert(at) {
            return Some(());
        }
        let (variables, _) = self.takers(at);
        self.stores_within(at, &variables)
    }

    fn stores_within(&mut self, at: usize, variables: &[usize]) -> Option<()> {
        let is_open = self.is_at(at);
        if !is_open {
            self.descend(at)?;
        }
        let stored = self.stores(at, variables);
        if !is_open {
            self.ascend();
        }
        stored
    }

    fn stores(&mut self, at: usize, variables: &[usize]) -> Option<()> {
        let network = self.network;
        let enabled = self.enabled(at)?;
        if variables.is_empty() {
            return Some(());
        }
        let place = span(network.elements[at].node);
        let value = match self.is_kept(at) {
            true => vec![piece(&self.kept(at)?, place)],
            false => self.applied(at)?,
        };
        for variable in variables {
            let to = &network.elements[*variable];
            let output = to.wires("").first().map_or("", |wire| wire.output);
            let mut value = value.clone();
            if to.negated() != network.elements[at].is_negated(output) {
                value = inverted(value, place);
            }
            let mut does = vec![piece(&format!("{} := ", to.written), span(to.node))];
            does.extend(value);
            self.when(at, &enabled, does, None);
        }
        Some(())
    }

    /// A function of what leads to its inputs.
    fn applied(&mut self, at: usize) -> Option<Vec<Piece>> {
        let network = self.network;
        let element = &network.elements[at];
        let place = span(element.node);
        let name = element.node.attribute("typeName").unwrap_or_default();
        let is_own = self.own[at] == What::Own;
        let pins = element.inputs.iter().map(|pin| pin.name);
        let mut pins: Vec<&str> = pins.filter(|pin| !pin.eq_ignore_ascii_case("EN")).collect();
        if !is_own {
            pins.sort_by_key(|pin| place_of(pin));
        }
        let mut values = Vec::new();
        for pin in pins {
            if is_own && element.wires(pin).is_empty() {
                continue;
            }
            let mut value = self.given(at, pin)?;
            if is_own {
                value.insert(0, piece(&format!("{pin} := "), place));
            }
            values.push(value);
        }
        if values.is_empty() && !is_own {
            self.tell(Code::XmlPin, at, ["IN".into()]);
            return None;
        }
        let sign = sign(usual(&element.block()), values.len());
        let mut said = match sign {
            Some("NOT") => return Some(inverted(values.concat(), place)),
            Some(_) => vec![piece("(", place)],
            None => vec![piece(&format!("{name}("), place)],
        };
        for (index, value) in values.into_iter().enumerate() {
            if index > 0 {
                let between = sign.map_or(", ".to_owned(), |sign| format!(" {sign} "));
                said.push(piece(&between, place));
            }
            match sign.is_some() && value.len() > 1 {
                true => {
                    said.push(piece("(", place));
                    said.extend(value);
                    said.push(piece(")", place));
                }
                false => said.extend(value),
            }
        }
        said.push(piece(")", place));
        Some(said)
    }
}

/// The sign of an operation of so many operands; none where it is written as a function.
pub(super) fn sign(name: &str, operands: usize) -> Option<&'static str> {
    Some(match (name, operands) {
        ("NOT", 1) => "NOT",
        ("MOVE", 1) => "",
        ("AND", 2..) => "AND",
        ("OR", 2..) => "OR",
        ("XOR", 2..) => "XOR",
        ("ADD", 2..) => "+",
        ("MUL", 2..) => "*",
        ("SUB", 2) => "-",
        ("DIV", 2) => "/",
        ("MOD", 2) => "MOD",
        ("GT", 2) => ">",
        ("GE", 2) => ">=",
        ("EQ", 2) => "=",
        ("NE", 2) => "<>",
        ("LE", 2) => "<=",
        ("LT", 2) => "<",
        _ => return None,
    })
}

/// The place of an input among those of its function: `SEL(G, IN0, IN1)`.
pub(super) fn place_of(pin: &str) -> u8 {
    match pin.to_uppercase().as_str() {
        "G" | "K" | "MN" => 0,
        "N" | "L" | "MX" => 2,
        "P" => 3,
        _ => 1,
    }
}
