//! What blocks become where power flows through them.

use crate::circuit::{Circuit, Item, Leaf, Part};
use crate::flow::{Flow, followed};
use crate::scope::{Counts, Meaning, Symbol};
use unoclp_core::isa::Opcode;
use unoclp_ladder::Address;
use unoclp_ladder::edit::{Coil, Draft, Gate, Step};
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
                Circuit::new()
            }
            "TON" | "TOF" | "TP" => self.timer(at, &name, &output)?,
            "CTU" | "CTD" | "CTUD" => self.counter(at, &output)?,
            "SR" | "RS" => self.latch(at, &name)?,
            "R" | "F" if name.ends_with("_TRIG") => self.edge_block(at, &name)?,
            "GT" | "GE" | "EQ" | "NE" | "LE" | "LT" => match output.as_str() {
                "ENO" => self.enabled(at)?,
                _ => {
                    let circuit = self.enabled(at)?;
                    let parts = self.comparison(at, &name)?;
                    followed(circuit, leaf(at, parts))
                }
            },
            "MOVE" | "ADD" | "SUB" | "MUL" | "DIV" | "MOD" | "SHL" | "SHR" if output == "ENO" => {
                let circuit = self.enabled(at)?;
                match self.stores(at)? {
                    parts if parts.is_empty() => circuit,
                    parts => followed(circuit, leaf(at, parts)),
                }
            }
            "AND" | "OR" | "XOR" if output != "ENO" => self.gate(at, &name)?,
            "NOT" if output != "ENO" => {
                self.unconditional(at)?;
                let circuit = self.power(at, "IN")?;
                followed(circuit, Leaf::plain((at, 0), Step::new(Opcode::Not)))
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
        match self.written.contains_key(&at) {
            true => Some(Circuit::new()),
            false => Some(circuit),
        }
    }

    /// The circuit of a variable behind an output.
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
            let circuit = self.power(at, "")?;
            return self.coil(at, circuit, "");
        }
        let elapsed = matches!(wire.output.to_uppercase().as_str(), "ET" | "CV");
        if !elapsed {
            return self.result(wire.from, "ENO");
        }
        // The block itself is called before.
        let call = self.called_block(wire.from)?;
        if !call.is_empty() {
            self.before.push((wire.from, call));
            self.written.insert(wire.from, true);
        }
        let mut parts: Vec<Part> = self.value(at, "")?.into_iter().map(Part::from).collect();
        parts.push(self.store(at)?.into());
        Some(followed(Circuit::new(), leaf(at, parts)))
    }

    /// Whether EN hangs on nothing, which is told otherwise.
    pub(crate) fn unconditional(&mut self, at: usize) -> Option<()> {
        if self.enabled(at)?.is_empty() {
            return Some(());
        }
        self.tell(Code::XmlEnable, at, []);
        None
    }

    /// The circuit to EN; the left rail where nothing leads to it.
    pub(crate) fn enabled(&mut self, at: usize) -> Option<Circuit> {
        match self.network.elements[at].wires("EN").is_empty() {
            true => Some(Circuit::new()),
            false => self.power(at, "EN"),
        }
    }

    /// The instance that a block is called with, which no other block may be.
    fn instance(&mut self, at: usize) -> Option<Symbol> {
        let element = &self.network.elements[at];
        let name = element.node.attribute("instanceName").unwrap_or_default();
        let meaning = self.meaning(at, name)?;
        if *self.called.entry(name.to_uppercase()).or_insert(at) != at {
            self.tell(Code::XmlTwice, at, [name.into()]);
            return None;
        }
        let block = element.block();
        let fits = match meaning {
            Meaning::Symbol(Symbol::Timer(_)) => matches!(block.as_str(), "TON" | "TOF" | "TP"),
            Meaning::Symbol(Symbol::Counter(_, counts)) => match counts {
                Counts::Up => block == "CTU" || block.starts_with("CTU_"),
                Counts::Down => block == "CTD" || block.starts_with("CTD_"),
                Counts::Both => block == "CTUD" || block.starts_with("CTUD_"),
            },
            Meaning::Symbol(Symbol::Latch(_)) => matches!(block.as_str(), "SR" | "RS"),
            Meaning::Symbol(Symbol::Edge) => block.ends_with("_TRIG"),
            _ => false,
        };
        match meaning {
            Meaning::Symbol(symbol) if fits => Some(symbol),
            _ => {
                self.wants(at, name, "?", &block);
                None
            }
        }
    }

    fn timer(&mut self, at: usize, name: &str, output: &str) -> Option<Circuit> {
        if !matches!(output, "Q" | "") {
            self.wants(at, output, "TIME", "BOOL");
            return None;
        }
        self.unconditional(at)?;
        let symbol = self.instance(at)?;
        let Symbol::Timer(timer) = symbol else {
            return None;
        };
        let circuit = self.power(at, "IN")?;
        let preset = self.preset(at, "PT", Step::new(Opcode::PresetTimer).with_number(timer))?;
        let opcode = match name {
            "TON" => Opcode::OnDelay,
            "TOF" => Opcode::OffDelay,
            _ => Opcode::Pulse,
        };
        let step = Step::new(opcode).with_lines([Some(preset), None]);
        self.all.timers.insert((self.pou, at), timer);
        if self.written.contains_key(&at) {
            let contact = Draft::contact(Some(Address::Timer(timer)), false).ok()?;
            return Some(vec![Item::Leaf(Leaf::plain((at, 1), contact.step))]);
        }
        Some(followed(circuit, Leaf::plain((at, 0), step).once()))
    }

    /// The number at an input that presets a block; one that changes is loaded before, by this instruction.
    fn preset(&mut self, at: usize, input: &str, by: Step) -> Option<i32> {
        if self.network.elements[at].wires(input).is_empty() {
            self.tell(Code::XmlPin, at, [input.into()]);
            return None;
        }
        let value = self.value(at, input)?;
        if let [load] = &value[..]
            && load.opcode() == Opcode::Load
            && load.number() == Some(0)
            && let [Some(constant)] = load.lines()
        {
            return Some(*constant);
        }
        let mut parts: Vec<Part> = value.into_iter().map(Part::from).collect();
        parts.push(by.into());
        let circuit = vec![Item::Leaf(Leaf {
            key: (at, 400),
            ..leaf(at, parts)
        })];
        if !self
            .before
            .iter()
            .any(|(of, known)| *of == at && same(known, &circuit))
        {
            self.before.push((at, circuit));
        }
        Some(0)
    }

    fn counter(&mut self, at: usize, output: &str) -> Option<Circuit> {
        let Some(Symbol::Counter(counter, counts)) = self.instance(at) else {
            return None;
        };
        self.unconditional(at)?;
        let reached = Draft::contact(Some(Address::Counter(counter)), false)
            .ok()?
            .step;
        let zero = Step::new(Opcode::ZeroContact).with_number(counter);
        let result = match (counts, output) {
            (Counts::Up, "Q" | "") | (Counts::Both, "QU") => reached,
            (Counts::Down, "Q" | "") | (Counts::Both, "QD") => zero,
            _ => {
                self.wants(at, output, "INT", "BOOL");
                return None;
            }
        };
        let preset = Step::new(Opcode::PresetCounter).with_number(counter);
        let preset = self.preset(at, "PV", preset)?;
        let count = |down| Draft::counter(down, Some(counter), Some(preset)).step;
        let coil = |opcode| Step::new(opcode).with_number(counter);
        let (up, down) = (counts != Counts::Down, counts != Counts::Up);
        let is_reset = up && self.is_driven(at, "R");
        let is_loaded = down && self.is_driven(at, "LD");
        if up != down && !is_reset && !is_loaded {
            let circuit = self.power(at, if up { "CU" } else { "CD" })?;
            return Some(followed(circuit, Leaf::plain((at, 0), count(down)).once()));
        }
        let contact = Leaf::plain((at, 10), result.clone());
        let contact = Leaf {
            key: (at, 10 + usize::from(result.opcode() == Opcode::ZeroContact)),
            ..contact
        };
        if self.written.insert(at, true).is_some() {
            return Some(vec![Item::Leaf(contact)]);
        }
        if up && (!down || self.is_driven(at, "CU")) {
            let circuit = self.power(at, "CU")?;
            let leaf = Leaf::plain((at, 0), count(false)).once();
            self.before.push((at, followed(circuit, leaf)));
        }
        if down && (!up || self.is_driven(at, "CD")) {
            let circuit = self.power(at, "CD")?;
            let leaf = Leaf::plain((at, 1), count(true)).once();
            self.before.push((at, followed(circuit, leaf)));
        }
        // R is stronger than LD: it comes last.
        for (is_there, input, kind, part) in [
            (is_loaded, "LD", Opcode::LoadCounter, 2),
            (is_reset, "R", Opcode::ResetCounter, 3),
        ] {
            if is_there {
                let circuit = self.power(at, input)?;
                let leaf = Leaf::plain((at, part), coil(kind)).output();
                self.before.push((at, followed(circuit, leaf)));
            }
        }
        Some(vec![Item::Leaf(contact)])
    }

    /// Whether something else than FALSE leads to this input.
    fn is_driven(&self, at: usize, input: &str) -> bool {
        let network = self.network;
        let wires = network.elements[at].wires(input);
        let is_false = |wire: &crate::network::Wire<'_>| {
            let from = &network.elements[wire.from];
            from.kind == "inVariable"
                && matches!(from.written().to_uppercase().as_str(), "FALSE" | "0")
        };
        !wires.is_empty() && !wires.iter().all(is_false)
    }

    fn latch(&mut self, at: usize, name: &str) -> Option<Circuit> {
        let Some(Symbol::Latch(marker)) = self.instance(at) else {
            return None;
        };
        self.unconditional(at)?;
        let point = Some(Address::Marker(marker));
        let contact = Draft::contact(point, false).ok()?.step;
        let contact = vec![Item::Leaf(Leaf::plain((at, 10), contact))];
        if self.written.insert(at, true).is_some() {
            return Some(contact);
        }
        // What is stronger comes last.
        let pins = match name {
            "SR" => [("R", Coil::Reset), ("S1", Coil::Set)],
            _ => [("S", Coil::Set), ("R1", Coil::Reset)],
        };
        for (part, (input, coil)) in pins.into_iter().enumerate() {
            let circuit = self.power(at, input)?;
            let step = Draft::coil(point, coil).ok()?.step;
            let leaf = Leaf::plain((at, part), step).output();
            self.before.push((at, followed(circuit, leaf)));
        }
        Some(contact)
    }

    fn edge_block(&mut self, at: usize, name: &str) -> Option<Circuit> {
        self.instance(at)?;
        self.unconditional(at)?;
        let circuit = self.power(at, "CLK")?;
        let opcode = match name {
            "R_TRIG" => Opcode::RisingEdge,
            _ => Opcode::FallingEdge,
        };
        Some(followed(
            circuit,
            Leaf::plain((at, 0), Step::new(opcode)).once(),
        ))
    }

    fn gate(&mut self, at: usize, name: &str) -> Option<Circuit> {
        self.unconditional(at)?;
        let gate = match name {
            "AND" => Gate::And,
            "OR" => Gate::Or,
            _ => Gate::Xor,
        };
        let mut circuit = self.power(at, "IN1")?;
        for input in self.numbered(at).into_iter().skip(1) {
            if gate == Gate::Xor
                && let Some(step) = self.exclusive(at, &input)
            {
                circuit.push(Item::Leaf(Leaf::plain((at, 20 + circuit.len()), step)));
                continue;
            }
            let other = self.power(at, &input)?;
            let part = 20 + circuit.len();
            circuit.push(Item::Gate((at, part), gate, other));
        }
        Some(circuit)
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
        let Meaning::Symbol(Symbol::Bit(point)) = self.meaning(wire.from, &from.written())? else {
            return None;
        };
        let opcode = match (point, pin.negated) {
            (Address::Input(_), false) => Opcode::XorInput,
            (Address::Input(_), true) => Opcode::XorInputNot,
            (Address::Output(_), false) => Opcode::XorOutput,
            (Address::Output(_), true) => Opcode::XorOutputNot,
            (Address::Marker(_), false) => Opcode::XorMarker,
            (Address::Marker(_), true) => Opcode::XorMarkerNot,
            _ => return None,
        };
        Some(Step::new(opcode).with_number(point.number()))
    }

    /// The inputs IN1, IN2 … of a block.
    pub(crate) fn numbered(&self, at: usize) -> Vec<String> {
        let pins = self.network.elements[at].inputs.iter();
        let names = pins.map(|pin| pin.name.to_uppercase());
        let is_numbered = |name: &String| {
            let number = name.strip_prefix("IN").unwrap_or_default();
            number.parse::<u8>().is_ok()
        };
        names.filter(is_numbered).collect()
    }
}

/// A leaf of these instructions.
fn leaf(at: usize, parts: Vec<Part>) -> Leaf {
    Leaf {
        key: (at, 500),
        parts,
        is_output: false,
        is_once: false,
    }
}

fn same(one: &Circuit, other: &Circuit) -> bool {
    let key = |circuit: &Circuit| match circuit.last() {
        Some(Item::Leaf(leaf)) => Some(leaf.key),
        _ => None,
    };
    key(one) == key(other)
}
