//! Blocks that remember something: timers, counters, latches, edges.

use crate::circuit::{Circuit, Item, Leaf, Part, followed};
use crate::flow::{Call, Flow};
use crate::symbol::{Counts, Meaning, Symbol};
use crate::ways::Ways;
use unoclp_core::isa::Opcode;
use unoclp_draw::edit::{Coil, Draft, Step};
use unoclp_lang::Code;
use unoclp_point::Address;

impl<'a, 'x: 'a> Flow<'_, 'a, 'x> {
    /// The instance that a block is called with, which no other block may be.
    fn instance(&mut self, at: usize) -> Option<Symbol> {
        let element = &self.network.elements[at];
        let name = element.node.attribute("instanceName").unwrap_or_default();
        let meaning = self.meaning(at, name)?;
        if *self.called.entry(name.to_uppercase()).or_insert(at) != at {
            self.tell(Code::XmlTangle, at, []);
            return None;
        }
        let block = element.block();
        let fits = match meaning {
            Meaning::Symbol(Symbol::At(Address::Timer(_))) => {
                matches!(block.as_str(), "TON" | "TOF" | "TP")
            }
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

    /// Whether a block is called by now.
    pub(crate) fn is_called(&self, at: usize) -> bool {
        let name = self.network.elements[at].node.attribute("instanceName");
        let name = name.unwrap_or_default().to_uppercase();
        self.called.get(&name) == Some(&at)
    }

    /// Whether a block is called in rungs of its own, before what takes its results: it gives a number, something
    /// waits for its ENO alone, the file says when it runs, or it takes more than one rung.
    pub(crate) fn is_apart(&self, at: usize) -> bool {
        let network = self.network;
        let block = &network.elements[at];
        let name = block.block();
        let is_plain = match name.split('_').next().unwrap_or_default() {
            "CTU" => !self.is_driven(at, "R"),
            "CTD" => !self.is_driven(at, "LD"),
            "CTUD" | "SR" | "RS" => false,
            _ => true,
        };
        if !is_plain || block.order.is_some() {
            return true;
        }
        let is = |output: &str, name: &str| output.eq_ignore_ascii_case(name);
        let takes_q = |by: usize| {
            let mut wires = network.elements[by]
                .inputs
                .iter()
                .flat_map(|pin| &pin.wires);
            wires.any(|wire| wire.from == at && is(wire.output, "Q"))
        };
        let readers = network.readers[at].iter();
        let mut others = readers.filter(|reader| !network.is_end(reader.at));
        others.any(|reader| match reader.output {
            output if is(output, "ENO") => !takes_q(reader.at),
            output => !is(output, "Q") && !output.is_empty(),
        })
    }

    /// Calls a block in rungs of its own, before what takes its results; once. None where something is wrong, which is
    /// told.
    pub(crate) fn call(&mut self, at: usize) -> Option<()> {
        match self.calls.get(&at) {
            Some(Call::Done) => return Some(()),
            Some(Call::Failed) => return None,
            Some(Call::Begun) => {
                self.tell(Code::XmlLoop, at, []);
                return None;
            }
            None => {}
        }
        // A wire from its Q has come here already.
        let is_open = self.is_at(at);
        if !is_open {
            self.descend(at)?;
        }
        self.calls.insert(at, Call::Begun);
        let called = self.called_apart(at);
        if !is_open {
            self.ascend();
        }
        let call = called.map_or(Call::Failed, |()| Call::Done);
        self.calls.insert(at, call);
        called
    }

    /// The rungs that call a block.
    fn called_apart(&mut self, at: usize) -> Option<()> {
        let block = self.network.elements[at].block();
        match block.split('_').next().unwrap_or_default() {
            "TON" | "TOF" | "TP" => {
                let circuit = self.timed(at)?;
                self.before.push((at, circuit));
                Some(())
            }
            "CTU" | "CTD" | "CTUD" => self.counted(at),
            "SR" | "RS" => self.latched(at),
            _ => {
                self.tell(Code::XmlBlock, at, [block.into()]);
                None
            }
        }
    }

    pub(crate) fn timer(&mut self, at: usize, output: &str) -> Option<Circuit> {
        if !matches!(output, "Q" | "") {
            self.wants(at, output, "TIME", "BOOL");
            return None;
        }
        if !self.is_apart(at) {
            return self.timed(at);
        }
        self.call(at)?;
        let timer = *self.all.timers.get(&(self.pou, at))?;
        let contact = Draft::contact(Some(Address::Timer(timer)), false).ok()?;
        Some(vec![Item::Leaf(Leaf::plain((at, 1), contact.step))])
    }

    /// The circuit that calls a timer; its power is Q.
    fn timed(&mut self, at: usize) -> Option<Circuit> {
        self.unconditional(at)?;
        let Some(Symbol::At(Address::Timer(timer))) = self.instance(at) else {
            return None;
        };
        let circuit = self.power(at, "IN")?;
        let preset = self.preset(at, "PT", Step::new(Opcode::PresetTimer).with_number(timer))?;
        let opcode = match self.network.elements[at].block().as_str() {
            "TON" => Opcode::OnDelay,
            "TOF" => Opcode::OffDelay,
            _ => Opcode::Pulse,
        };
        let step = Step::new(opcode).with_lines([Some(preset), None]);
        self.all.timers.insert((self.pou, at), timer);
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
        if self.network.is_blocks {
            self.tell(Code::XmlTangle, at, []);
            return None;
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
        let reached = Draft::contact(Some(Address::Counter(counter)), false)
            .ok()?
            .step;
        let zero = Step::new(Opcode::ZeroContact).with_number(counter);
        let (part, result) = match (counts, output) {
            (Counts::Up, "Q" | "") | (Counts::Both, "QU") => (10, reached),
            (Counts::Down, "Q" | "") | (Counts::Both, "QD") => (11, zero),
            _ => {
                self.wants(at, output, "INT", "BOOL");
                return None;
            }
        };
        if !self.is_apart(at) {
            let input = if counts == Counts::Down { "CD" } else { "CU" };
            self.unconditional(at)?;
            let preset = self.preset_of(at, counter)?;
            return self.counting(at, input, counter, preset);
        }
        self.call(at)?;
        Some(vec![Item::Leaf(Leaf::plain((at, part), result))])
    }

    /// The rungs that count, load and reset.
    fn counted(&mut self, at: usize) -> Option<()> {
        let Some(Symbol::Counter(counter, counts)) = self.instance(at) else {
            return None;
        };
        self.unconditional(at)?;
        let preset = self.preset_of(at, counter)?;
        for (input, other) in [("CU", Counts::Down), ("CD", Counts::Up)] {
            let counts_so =
                counts != other && (counts != Counts::Both || self.is_driven(at, input));
            if counts_so {
                let circuit = self.counting(at, input, counter, preset)?;
                self.before.push((at, circuit));
            }
        }
        // R is stronger than LD: it comes last.
        for (input, other, kind, part) in [
            ("LD", Counts::Up, Opcode::LoadCounter, 2),
            ("R", Counts::Down, Opcode::ResetCounter, 3),
        ] {
            if counts != other && self.is_driven(at, input) {
                let circuit = self.power(at, input)?;
                let step = Step::new(kind).with_number(counter);
                let leaf = Leaf::plain((at, part), step).output();
                self.before.push((at, followed(circuit, leaf)));
            }
        }
        Some(())
    }

    /// The circuit that counts by this input; its power is whether the counter has reached its preset, or 0.
    fn counting(&mut self, at: usize, input: &str, counter: u8, preset: i32) -> Option<Circuit> {
        let circuit = self.power(at, input)?;
        let is_down = input == "CD";
        let step = Draft::counter(is_down, Some(counter), Some(preset)).step;
        let leaf = Leaf::plain((at, usize::from(is_down)), step);
        Some(followed(circuit, leaf.once()))
    }

    fn preset_of(&mut self, at: usize, counter: u8) -> Option<i32> {
        let by = Step::new(Opcode::PresetCounter).with_number(counter);
        self.preset(at, "PV", by)
    }

    /// Whether something else than FALSE leads to this input.
    fn is_driven(&self, at: usize, input: &str) -> bool {
        let network = self.network;
        let wires = network.elements[at].wires(input);
        let is_false = |wire: &crate::network::Wire<'_>| {
            let from = &network.elements[wire.from];
            from.kind == "inVariable"
                && matches!(from.written.to_uppercase().as_str(), "FALSE" | "0")
        };
        !wires.is_empty() && !wires.iter().all(is_false)
    }

    pub(crate) fn latch(&mut self, at: usize) -> Option<Circuit> {
        let Some(Symbol::Latch(marker)) = self.instance(at) else {
            return None;
        };
        self.call(at)?;
        let contact = Draft::contact(Some(Address::Marker(marker)), false).ok()?;
        Some(vec![Item::Leaf(Leaf::plain((at, 10), contact.step))])
    }

    /// The rungs that set and reset a latch.
    fn latched(&mut self, at: usize) -> Option<()> {
        let Some(Symbol::Latch(marker)) = self.instance(at) else {
            return None;
        };
        self.unconditional(at)?;
        // What is stronger comes last.
        let pins = match self.network.elements[at].block().as_str() {
            "SR" => [("R", Coil::Reset), ("S1", Coil::Set)],
            _ => [("S", Coil::Set), ("R1", Coil::Reset)],
        };
        for (part, (input, coil)) in pins.into_iter().enumerate() {
            let circuit = self.power(at, input)?;
            let step = Draft::coil(Some(Address::Marker(marker)), coil).ok()?.step;
            let leaf = Leaf::plain((at, part), step).output();
            self.before.push((at, followed(circuit, leaf)));
        }
        Some(())
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
