//! Blocks that remember something: timers, counters, latches, edges.

use crate::circuit::{Circuit, Item, Leaf, Part, followed};
use crate::flow::Flow;
use crate::symbol::{Counts, Meaning, Symbol};
use unoclp_core::isa::Opcode;
use unoclp_ladder::Address;
use unoclp_ladder::edit::{Coil, Draft, Step};
use unoclp_lang::Code;

impl<'a, 'x: 'a> Flow<'_, 'a, 'x> {
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

    pub(crate) fn timer(&mut self, at: usize, name: &str, output: &str) -> Option<Circuit> {
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
        let circuit = vec![Item::Leaf(Leaf::of((at, 400), parts))];
        if !self
            .before
            .iter()
            .any(|(of, known)| *of == at && same(known, &circuit))
        {
            self.before.push((at, circuit));
        }
        Some(0)
    }

    pub(crate) fn counter(&mut self, at: usize, output: &str) -> Option<Circuit> {
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

    pub(crate) fn latch(&mut self, at: usize, name: &str) -> Option<Circuit> {
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

    pub(crate) fn edge_block(&mut self, at: usize, name: &str) -> Option<Circuit> {
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
}

fn same(one: &Circuit, other: &Circuit) -> bool {
    let key = |circuit: &Circuit| match circuit.last() {
        Some(Item::Leaf(leaf)) => Some(leaf.key),
        _ => None,
    };
    key(one) == key(other)
}
