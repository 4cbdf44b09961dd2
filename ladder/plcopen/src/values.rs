//! What numbers become: loads, operations and stores.

use crate::circuit::Part;
use crate::flow::Flow;
use crate::symbol::{Meaning, Symbol};
use crate::ways::Ways;
use unoclp_core::isa::{Class, Opcode, POPPED};
use unoclp_draw::edit::Step;
use unoclp_lang::Code;
use unoclp_point::Address;

impl<'a, 'x: 'a> Flow<'_, 'a, 'x> {
    /// Whether an output of a block is a number.
    pub(crate) fn gives_number(&self, at: usize, output: &str) -> bool {
        let block = self.network.elements[at].block();
        match block.as_str() {
            "MOVE" | "ADD" | "SUB" | "MUL" | "DIV" | "MOD" | "SHL" | "SHR" => {
                !output.eq_ignore_ascii_case("ENO")
            }
            // Of bits where all of its inputs are.
            "AND" | "OR" | "XOR" => false,
            _ => matches!(output.to_uppercase().as_str(), "ET" | "CV"),
        }
    }

    /// The instructions that load what the wire to this input brings.
    pub(crate) fn value(&mut self, at: usize, input: &str) -> Option<Vec<Step>> {
        let network = self.network;
        let pin = network.elements[at].input(input);
        let Some((pin, [wire])) = pin.map(|pin| (pin, &pin.wires[..])) else {
            self.tell(Code::XmlPin, at, [input.into()]);
            return None;
        };
        let from = &network.elements[wire.from];
        if pin.negated || !pin.edge.is_empty() {
            self.inverts(at, pin.name);
            return None;
        }
        if from.negated() || from.is_negated(wire.output) {
            self.inverts(wire.from, wire.output);
            return None;
        }
        let written = match from.kind {
            "inVariable" | "inOutVariable" => from.written.clone(),
            "block" => match wire.output.to_uppercase().as_str() {
                member @ ("ET" | "CV") => {
                    self.call(wire.from)?;
                    let instance = from.node.attribute("instanceName");
                    format!("{}.{member}", instance.unwrap_or_default())
                }
                _ if self.gives_number(wire.from, wire.output) => {
                    return self.computed(wire.from, at);
                }
                output => {
                    self.wants(at, &format!("{}.{output}", from.block()), "BOOL", "INT");
                    return None;
                }
            },
            kind => {
                self.wants(at, kind, "BOOL", "INT");
                return None;
            }
        };
        let constant = |number| {
            Step::new(Opcode::Load)
                .with_number(0)
                .with_lines([Some(number)])
        };
        let step = match self.meaning(wire.from, &written)? {
            Meaning::Symbol(Symbol::At(point)) => load(point),
            Meaning::Symbol(Symbol::Constant(number)) => Some(constant(number)),
            Meaning::Truth(truth) => Some(constant(i32::from(truth))),
            Meaning::Symbol(_) => None,
        };
        if step.is_none() {
            self.wants(at, &written, "BOOL", "INT");
        }
        step.map(|step| vec![step])
    }

    /// Tells that a number is taken for a truth, which could be negated or have an edge.
    fn inverts(&mut self, at: usize, what: &str) {
        let what = match what {
            "" => self.network.elements[at].written.clone(),
            name => name.to_owned(),
        };
        self.wants(at, &format!("NOT {what}"), "INT", "BOOL");
    }

    /// The instructions that compute what a block gives to another.
    fn computed(&mut self, at: usize, by: usize) -> Option<Vec<Step>> {
        if self.network.is_blocks && self.network.readers[at].len() > 1 {
            // It would be computed again.
            self.tell(Code::XmlTangle, at, []);
            return None;
        }
        self.descend(at)?;
        let steps = self.operation(at, Some(by));
        self.ascend();
        steps
    }

    /// The same; `by` is the block that takes it, where one does.
    fn operation(&mut self, at: usize, by: Option<usize>) -> Option<Vec<Step>> {
        let network = self.network;
        let block = &network.elements[at];
        if let Some(by) = by {
            // What a block takes is computed where it is itself.
            let own = block.wires("EN");
            let others = network.elements[by].wires("EN");
            let follows = others.iter().any(|wire| wire.from == at);
            if !follows && own != others {
                self.unconditional(at)?;
            }
        }
        let opcode = match block.block().as_str() {
            "MOVE" => return self.value(at, "IN"),
            "ADD" => Opcode::Add,
            "SUB" => Opcode::Subtract,
            "MUL" => Opcode::Multiply,
            "DIV" => Opcode::Divide,
            "MOD" => Opcode::Modulo,
            "SHL" | "SHR" => return self.shifted(at),
            other => {
                self.tell(Code::XmlBlock, at, [other.into()]);
                return None;
            }
        };
        let mut inputs = self.numbered(at).into_iter();
        let first = inputs.next().unwrap_or_else(|| "IN1".to_owned());
        let mut steps = self.value(at, &first)?;
        for input in inputs {
            let right = self.value(at, &input)?;
            self.apply(&mut steps, opcode, right);
        }
        (steps.len() <= 200).then_some(steps).or_else(|| {
            self.too_large(at);
            None
        })
    }

    /// Puts an operation with this right operand after what computes the left one.
    fn apply(&self, steps: &mut Vec<Step>, opcode: Opcode, right: Vec<Step>) {
        match &right[..] {
            [load] if load.opcode() == Opcode::Load => {
                let lines = load.lines().to_vec();
                let step = Step::new(opcode).with_number(load.number());
                steps.push(step.with_lines(lines));
            }
            _ => {
                steps.push(Step::new(Opcode::Push));
                steps.extend(right);
                steps.push(Step::new(opcode).with_number(POPPED));
            }
        }
    }

    fn shifted(&mut self, at: usize) -> Option<Vec<Step>> {
        let block = &self.network.elements[at];
        let mut steps = self.value(at, "IN")?;
        let by = self.value(at, "N")?;
        let opcode = match block.block().as_str() {
            "SHL" => Opcode::ShiftLeft,
            _ => Opcode::ShiftRight,
        };
        let number = match &by[..] {
            [load] if load.number() == Some(0) => load.lines().first().copied().flatten(),
            _ => None,
        };
        let Some(number) = number
            .and_then(|n| u8::try_from(n).ok())
            .filter(|n| *n < 32)
        else {
            let what = ("constant from 0 to 31", "uma constante de 0 a 31");
            self.tell(Code::XmlValue, at, ["N".into(), what.into()]);
            return None;
        };
        steps.push(Step::new(opcode).with_number(number));
        Some(steps)
    }

    /// The parts of a comparison: each input with the next.
    pub(crate) fn comparison(&mut self, at: usize, name: &str) -> Option<Vec<Part>> {
        let opcode = match name {
            "GT" => Opcode::Greater,
            "GE" => Opcode::GreaterOrEqual,
            "EQ" => Opcode::Equal,
            "NE" => Opcode::NotEqual,
            "LE" => Opcode::LessOrEqual,
            _ => Opcode::Less,
        };
        let inputs = self.numbered(at);
        if inputs.len() < 2 {
            self.tell(Code::XmlPin, at, ["IN2".into()]);
            return None;
        }
        let mut parts = Vec::new();
        for pair in inputs.windows(2) {
            let mut steps = self.value(at, &pair[0])?;
            let right = self.value(at, &pair[1])?;
            self.apply(&mut steps, opcode, right);
            let step = steps.pop()?;
            let load = steps.pop_if(|last| last.class() == Class::Load);
            parts.extend(steps.into_iter().map(Part::from));
            parts.push(Part { load, step });
        }
        Some(parts)
    }

    /// The instructions that compute what a block gives and store it in the variables after it.
    pub(crate) fn stores(&mut self, at: usize) -> Option<Vec<Part>> {
        let network = self.network;
        let mut parts: Vec<Part> = Vec::new();
        for reader in &network.readers[at] {
            let kind = network.elements[reader.at].kind;
            let behind = matches!(kind, "outVariable" | "inOutVariable");
            if behind && self.gives_number(at, reader.output) {
                if network.elements[at].is_negated(reader.output) {
                    self.inverts(at, reader.output);
                    return None;
                }
                if parts.is_empty() {
                    parts = self
                        .operation(at, None)?
                        .into_iter()
                        .map(Part::from)
                        .collect();
                }
                parts.push(self.store(reader.at)?.into());
            }
        }
        Some(parts)
    }

    /// The store to the variable of an element.
    pub(crate) fn store(&mut self, at: usize) -> Option<Step> {
        let element = &self.network.elements[at];
        let written = &element.written;
        if element.negated() {
            self.inverts(at, written);
            return None;
        }
        match self.meaning(at, written)? {
            Meaning::Symbol(Symbol::At(Address::Register(register))) => {
                Some(Step::new(Opcode::Store).with_number(register))
            }
            Meaning::Symbol(Symbol::At(Address::Pwm(output))) => {
                Some(Step::new(Opcode::StorePwm).with_number(output))
            }
            Meaning::Symbol(Symbol::At(
                Address::Input(_) | Address::Output(_) | Address::Marker(_) | Address::System(_),
            )) => {
                self.wants(at, written, "BOOL", "INT");
                None
            }
            _ => {
                self.tell(Code::XmlWritten, at, [written.as_str().into()]);
                None
            }
        }
    }
}

/// The instruction that loads this number; none of a bit.
fn load(point: Address) -> Option<Step> {
    let opcode = match point {
        Address::Register(_) => Opcode::Load,
        Address::Analogue(_) => Opcode::LoadAnalogue,
        Address::Elapsed(_) => Opcode::LoadTimer,
        Address::Count(_) => Opcode::LoadCount,
        _ => return None,
    };
    Some(Step::new(opcode).with_number(point.number()))
}
