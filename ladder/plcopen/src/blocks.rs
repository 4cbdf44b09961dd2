//! What blocks become where power flows through them.

use crate::circuit::{Circuit, Item, Leaf, Part, followed, together};
use crate::flow::Flow;
use crate::pins::is_numbered;
use crate::symbol::{Meaning, Symbol};
use crate::ways::Ways;
use unoclp_core::isa::{Class, Opcode};
use unoclp_draw::edit::{Gate, Step};
use unoclp_lang::Code;

impl<'a, 'x: 'a> Flow<'_, 'a, 'x> {
    /// The circuit to an output of a block that is 0 or 1.
    pub(crate) fn result(&mut self, at: usize, output: &str) -> Option<Circuit> {
        let network = self.network;
        let block = &network.elements[at];
        let name = block.block();
        let output = output.to_uppercase();
        let is_negated = block.is_negated(&output);
        let mut circuit = match name.split('_').next().unwrap_or_default() {
            "TON" | "TOF" | "TP" | "CTU" | "CTD" | "CTUD" | "SR" | "RS" | "R" | "F"
                if output == "ENO" =>
            {
                self.unconditional(at)?;
                if block.remembers() && self.is_apart(at) {
                    self.call(at)?;
                }
                Circuit::new()
            }
            "TON" | "TOF" | "TP" => self.timer(at, &output)?,
            "CTU" | "CTD" | "CTUD" => self.counter(at, &output)?,
            "SR" | "RS" => self.latch(at)?,
            "R" | "F" if name.ends_with("_TRIG") => self.edge_block(at, &name)?,
            "GT" | "GE" | "EQ" | "NE" | "LE" | "LT" => match output.as_str() {
                "ENO" => self.enabled(at)?,
                _ => {
                    let circuit = self.enabled(at)?;
                    let parts = self.comparison(at, &name)?;
                    followed(circuit, self.computed_once(Leaf::of((at, 500), parts)))
                }
            },
            "MOVE" | "ADD" | "SUB" | "MUL" | "DIV" | "MOD" | "SHL" | "SHR" if output == "ENO" => {
                let circuit = self.enabled(at)?;
                match self.stores(at)? {
                    parts if parts.is_empty() => circuit,
                    parts => followed(circuit, self.computed_once(Leaf::of((at, 500), parts))),
                }
            }
            "AND" | "OR" | "XOR" if output != "ENO" => self.gate(at, &name)?,
            "NOT" if output != "ENO" => {
                self.unconditional(at)?;
                let circuit = self.power(at, "IN")?;
                let leaf = Leaf::plain((at, 0), Step::new(Opcode::Not));
                followed(circuit, self.computed_once(leaf))
            }
            "MOVE" | "ADD" | "SUB" | "MUL" | "DIV" | "MOD" | "SHL" | "SHR" => {
                self.wants(at, &name, "INT", "BOOL");
                return None;
            }
            _ => {
                let written = block.node.attribute("typeName").unwrap_or_default();
                self.tell(Code::XmlBlock, at, [written.into()]);
                return None;
            }
        };
        if is_negated {
            circuit.push(Item::Leaf(Leaf::plain((at, 300), Step::new(Opcode::Not))));
        }
        Some(circuit)
    }

    /// The circuit of a block whose outputs lead nowhere.
    pub(crate) fn called_block(&mut self, at: usize) -> Option<Circuit> {
        let block = &self.network.elements[at];
        let output = match block.block().split('_').next().unwrap_or_default() {
            "MOVE" | "ADD" | "SUB" | "MUL" | "DIV" | "MOD" | "SHL" | "SHR" => "ENO",
            "CTUD" => "QU",
            "GT" | "GE" | "EQ" | "NE" | "LE" | "LT" | "AND" | "OR" | "XOR" | "NOT" => "OUT",
            "SR" | "RS" => "Q1",
            _ => "Q",
        };
        let circuit = self.result(at, output)?;
        // What has been written before needs no contact that leads nowhere.
        match self.calls.contains_key(&at) {
            true => Some(Circuit::new()),
            false => Some(circuit),
        }
    }

    /// The circuit of a variable after an output.
    pub(crate) fn assigned(&mut self, at: usize) -> Option<Circuit> {
        let network = self.network;
        let element = &network.elements[at];
        let wires = element.wires("");
        let [wire] = wires else {
            let circuit = self.power(at, "")?;
            return self.coil(at, circuit, "");
        };
        let from = &network.elements[wire.from];
        let is_number = from.kind == "block" && self.gives_number(wire.from, wire.output);
        if !is_number {
            if from.kind == "block" && !from.remembers() && !wire.output.eq_ignore_ascii_case("ENO")
            {
                // A variable after a function keeps its value where EN has no power.
                self.unconditional(wire.from)?;
            }
            let circuit = self.power(at, "")?;
            return self.coil(at, circuit, "");
        }
        let elapsed = matches!(wire.output.to_uppercase().as_str(), "ET" | "CV");
        if !elapsed {
            return self.result(wire.from, "ENO");
        }
        let mut parts: Vec<Part> = self.value(at, "")?.into_iter().map(Part::from).collect();
        parts.push(self.store(at)?.into());
        Some(followed(Circuit::new(), Leaf::of((at, 500), parts)))
    }

    /// Whether EN hangs on nothing, which is reported otherwise.
    pub(crate) fn unconditional(&mut self, at: usize) -> Option<()> {
        if self.enabled(at)?.is_empty() {
            return Some(());
        }
        self.tell(Code::XmlTangle, at, []);
        None
    }

    /// The circuit to EN; the left rail where nothing leads to it.
    pub(crate) fn enabled(&mut self, at: usize) -> Option<Circuit> {
        match self.network.elements[at].wires("EN").is_empty() {
            true => Some(Circuit::new()),
            false => self.power(at, "EN"),
        }
    }

    fn gate(&mut self, at: usize, name: &str) -> Option<Circuit> {
        self.unconditional(at)?;
        let gate = match name {
            "AND" => Gate::And,
            "OR" => Gate::Or,
            _ => Gate::Xor,
        };
        if self.network.is_blocks && gate != Gate::Xor {
            return self.gate_of_blocks(at, gate);
        }
        let mut circuit = self.power(at, "IN1")?;
        for input in self.numbered(at).into_iter().skip(1) {
            if gate == Gate::Xor
                && let Some(step) = self.exclusive(at, &input)
            {
                let leaf = Leaf::plain((at, 20 + circuit.len()), step);
                circuit.push(Item::Leaf(self.computed_once(leaf)));
                continue;
            }
            let other = self.power(at, &input)?;
            let part = 20 + circuit.len();
            circuit.push(Item::Gate((at, part), gate, other));
        }
        Some(circuit)
    }

    /// AND and OR of a block diagram: in series and in parallel. A variable right at an input is read when the gate is
    /// computed, which is once.
    fn gate_of_blocks(&mut self, at: usize, gate: Gate) -> Option<Circuit> {
        let mut ways: Vec<Circuit> = Vec::new();
        for (index, input) in self.numbered(at).into_iter().enumerate() {
            let Some((variable, negated)) = self.variable(at, &input) else {
                let way = self.power(at, &input)?;
                match ways.first_mut() {
                    Some(circuit) if gate == Gate::And && is_contact(&way) => circuit.extend(way),
                    Some(circuit) if gate == Gate::And && !way.is_empty() => {
                        circuit.push(Item::Gate((at, 20 + index), gate, way));
                    }
                    Some(_) if gate == Gate::And => {}
                    _ => ways.push(way),
                }
                continue;
            };
            let part = self.looked_at(variable, negated)?;
            let leaf = part.map(|part| Item::Leaf(Leaf::of((at, 20 + index), vec![part]).once()));
            match ways.first_mut() {
                Some(circuit) if gate == Gate::And => circuit.extend(leaf),
                _ => ways.push(leaf.into_iter().collect()),
            }
        }
        Some(match ways.len() {
            0 | 1 => ways.pop().unwrap_or_default(),
            _ => together(ways),
        })
    }

    /// The variable right at an input, and whether it is negated there.
    fn variable(&self, at: usize, input: &str) -> Option<(usize, bool)> {
        let pin = self.network.elements[at].input(input)?;
        let &[wire] = &pin.wires[..] else {
            return None;
        };
        let from = &self.network.elements[wire.from];
        let is_plain = from.kind == "inVariable" && pin.edge.is_empty();
        is_plain.then(|| (wire.from, pin.negated != from.negated()))
    }

    /// What a block of a block diagram computes is computed once, however many ask for it.
    fn computed_once(&self, leaf: Leaf) -> Leaf {
        match self.network.is_blocks {
            true => leaf.once(),
            false => leaf,
        }
    }

    /// The exclusive OR with a point that is written right at the input.
    fn exclusive(&mut self, at: usize, input: &str) -> Option<Step> {
        let network = self.network;
        let pin = network.elements[at].input(input)?;
        let [wire] = &pin.wires[..] else {
            return None;
        };
        let from = &network.elements[wire.from];
        if from.kind != "inVariable" || !pin.edge.is_empty() || from.negated() {
            return None;
        }
        let Meaning::Symbol(Symbol::At(point)) = self.meaning(wire.from, &from.written)? else {
            return None;
        };
        let opcode = point.xor(pin.negated)?;
        Some(Step::new(opcode).with_number(point.number()))
    }

    /// The inputs IN1, IN2 … of a block.
    pub(crate) fn numbered(&self, at: usize) -> Vec<String> {
        let pins = self.network.elements[at].inputs.iter();
        let names = pins.map(|pin| pin.name.to_uppercase());
        names.filter(|name| is_numbered(name)).collect()
    }
}

/// Whether a way is a contact of what a block remembers.
fn is_contact(way: &Circuit) -> bool {
    match &way[..] {
        [Item::Leaf(leaf)] => {
            let mut parts = leaf.parts.iter();
            let is_contact =
                |part: &Part| matches!(part.step.class(), Class::Contact | Class::Condition);
            !leaf.is_once && parts.all(is_contact)
        }
        _ => false,
    }
}
