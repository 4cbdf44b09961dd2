//! A rung of instructions as lines of Instruction List.

use unoclp_core::isa::{Opcode, Operand, Value};
use unoclp_core::{Instruction, Target};

/// The lines of a rung; none where Instruction List has no words for it. Timers are named in file order, so
/// those before it are counted.
pub(crate) fn rung(steps: &[Instruction<'_>], timers: &mut u8) -> Option<Vec<String>> {
    let own = steps.iter().filter(|step| step.timer().is_some()).count() as u8;
    let steps = match steps {
        [first, rest @ ..] if first.opcode == Opcode::NewRung => rest,
        steps => steps,
    };
    let mut speller = Speller {
        steps,
        at: 0,
        timers: *timers,
        lines: Vec::new(),
    };
    *timers = timers.saturating_add(own);
    speller.series(true)?;
    (speller.at == steps.len() && !speller.lines.is_empty()).then_some(speller.lines)
}

struct Speller<'s, 'c> {
    steps: &'s [Instruction<'c>],
    at: usize,
    timers: u8,
    lines: Vec<String>,
}

impl<'c> Speller<'_, 'c> {
    fn line(&mut self, operator: &str, operand: &str) {
        self.lines.push(format!("{operator:<5} {operand}"));
    }

    fn next(&mut self) -> Option<Instruction<'c>> {
        let step = self.steps.get(self.at).copied();
        self.at += usize::from(step.is_some());
        step
    }

    /// To the end of the rung or branch. Where the accumulator is 1 at first, the first contact is loaded.
    fn series(&mut self, mut first: bool) -> Option<()> {
        while let Some(step) = self.steps.get(self.at).copied() {
            let opcode = step.opcode;
            if opcode == Opcode::CloseBranch {
                return Some(());
            }
            if let Some((name, negated)) = contact(step) {
                self.at += 1;
                let operator = match (first, negated) {
                    (true, false) => "LD",
                    (true, true) => "LDN",
                    (false, false) => "AND",
                    (false, true) => "ANDN",
                };
                self.line(operator, &name);
                first = false;
                continue;
            }
            if opcode.opens() {
                if first {
                    return None;
                }
                self.at += 1;
                self.branch(opcode)?;
                continue;
            }
            if let Some(name) = load(step) {
                self.number(first, name)?;
                first = first && !self.compared();
                continue;
            }
            self.at += 1;
            self.other(step, &mut first)?;
        }
        Some(())
    }

    /// Whether the last number became a comparison, and not a store.
    fn compared(&self) -> bool {
        let before = self.at.checked_sub(1).and_then(|at| self.steps.get(at));
        before.is_some_and(|step| comparison(step.opcode))
    }

    /// From behind an opening code to its `41`.
    fn branch(&mut self, opening: Opcode) -> Option<()> {
        let operator = match opening {
            Opcode::OpenBranch => "OR",
            Opcode::OpenAnd => "AND",
            _ => "XOR",
        };
        let head = self.next()?;
        let closes =
            |step: Option<&Instruction<'_>>| step.is_some_and(|s| s.opcode == Opcode::CloseBranch);
        let single = closes(self.steps.get(self.at));
        if let Some((name, negated)) = contact(head) {
            if single {
                self.at += 1;
                let operator = if negated {
                    format!("{operator}N")
                } else {
                    operator.to_owned()
                };
                self.line(&operator, &name);
                return Some(());
            }
            let open = if negated { "(N" } else { "(" };
            self.line(&format!("{operator}{open}"), &name);
            self.series(false)?;
        } else {
            let name = load(head)?;
            self.line(&format!("{operator}("), &name);
            self.operations()?;
            self.series(false)?;
        }
        self.next()?;
        self.line(")", "");
        Some(())
    }

    /// A number that is loaded, worked on, and compared; or stored, where nothing stands before.
    fn number(&mut self, first: bool, name: String) -> Option<()> {
        self.at += 1;
        if first {
            self.line("LD", &name);
            return self.operations_or_store();
        }
        self.line("AND(", &name);
        self.operations()?;
        self.line(")", "");
        Some(())
    }

    /// Operations up to a comparison.
    fn operations(&mut self) -> Option<()> {
        loop {
            let step = self.next()?;
            let (operator, operand) = operation(step)?;
            self.line(operator, &operand);
            if comparison(step.opcode) {
                return Some(());
            }
        }
    }

    /// Operations up to a comparison or the last of the stores.
    fn operations_or_store(&mut self) -> Option<()> {
        let mut stored = false;
        loop {
            let step = *self.steps.get(self.at)?;
            if let Some(name) = number_target(step) {
                self.line("ST", &name);
                stored = true;
            } else if stored && (load(step).is_some() || contact(step).is_some()) {
                return Some(());
            } else {
                let (operator, operand) = operation(step)?;
                self.line(operator, &operand);
                stored = false;
                if comparison(step.opcode) {
                    self.at += 1;
                    return Some(());
                }
            }
            self.at += 1;
            if stored && self.at == self.steps.len() {
                return Some(());
            }
        }
    }

    /// What is neither contact nor branch nor number.
    fn other(&mut self, step: Instruction<'_>, first: &mut bool) -> Option<()> {
        let number = step.number().unwrap_or(0);
        let opcode = step.opcode;
        if let (Opcode::Label, true) = (opcode, *first) {
            self.lines.push(format!("L{number:02}:"));
            return Some(());
        }
        if let Some(block) = step.timer() {
            if *first {
                self.line("LD", "TRUE");
                *first = false;
            }
            let operator = match opcode {
                Opcode::RetentiveOnDelay => "TONR",
                opcode => opcode.row().letters,
            };
            self.timers += 1;
            self.line(operator, &format!("T{}, {}", self.timers, block.preset));
            self.line("ST", &target(block.target));
            return Some(());
        }
        if *first {
            match opcode {
                Opcode::Jump => {
                    self.line("JMP", &format!("L{number:02}"));
                    return Some(());
                }
                Opcode::Return => {
                    self.line("RET", "");
                    return Some(());
                }
                _ => {}
            }
            self.line("LD", "TRUE");
            *first = false;
        }
        let (operator, operand) = match opcode {
            Opcode::Not => ("NOT", String::new()),
            Opcode::RisingEdge => ("EU", String::new()),
            Opcode::FallingEdge => ("ED", String::new()),
            Opcode::Coil => ("ST", format!("Q{number}")),
            Opcode::NegatedCoil => ("STN", format!("Q{number}")),
            Opcode::SetCoil => ("S", format!("Q{number}")),
            Opcode::ResetCoil => ("R", format!("Q{number}")),
            Opcode::MarkerCoil => ("ST", format!("M{number}")),
            Opcode::NegatedMarkerCoil => ("STN", format!("M{number}")),
            Opcode::SetMarker => ("S", format!("M{number}")),
            Opcode::ResetMarker => ("R", format!("M{number}")),
            Opcode::XorInput => ("XOR", format!("I{number}")),
            Opcode::XorInputNot => ("XORN", format!("I{number}")),
            Opcode::XorOutput => ("XOR", format!("Q{number}")),
            Opcode::XorOutputNot => ("XORN", format!("Q{number}")),
            Opcode::XorMarker => ("XOR", format!("M{number}")),
            Opcode::XorMarkerNot => ("XORN", format!("M{number}")),
            Opcode::ResetTimer => ("R", format!("T{number}")),
            Opcode::ResetCounter => ("R", format!("C{number}")),
            Opcode::LoadCounter => ("S", format!("C{number}")),
            Opcode::Jump => ("JMPC", format!("L{number:02}")),
            Opcode::JumpNot => ("JMPCN", format!("L{number:02}")),
            Opcode::Return => ("RETC", String::new()),
            Opcode::ReturnNot => ("RETCN", String::new()),
            Opcode::CountUp | Opcode::CountDown => {
                let Operand::Count { preset, .. } = step.operand else {
                    return None;
                };
                (opcode.row().letters, format!("C{number}, {preset}"))
            }
            _ => return None,
        };
        self.line(operator, &operand);
        Some(())
    }
}

/// The name of a contact's point, and whether it is inverted.
fn contact(step: Instruction<'_>) -> Option<(String, bool)> {
    let n = step.number()?;
    Some(match step.opcode {
        Opcode::InputContact => (format!("I{n}"), false),
        Opcode::InputContactNot => (format!("I{n}"), true),
        Opcode::OutputContact => (format!("Q{n}"), false),
        Opcode::OutputContactNot => (format!("Q{n}"), true),
        Opcode::MarkerContact => (format!("M{n}"), false),
        Opcode::MarkerContactNot => (format!("M{n}"), true),
        Opcode::SystemContact => (format!("S{n}"), false),
        Opcode::SystemContactNot => (format!("S{n}"), true),
        Opcode::TimerContact => (format!("T{n}.Q"), false),
        Opcode::TimerContactNot => (format!("T{n}.Q"), true),
        Opcode::CounterContact => (format!("C{n}.QU"), false),
        Opcode::CounterContactNot => (format!("C{n}.QU"), true),
        Opcode::ZeroContact => (format!("C{n}.QD"), false),
        Opcode::ZeroContactNot => (format!("C{n}.QD"), true),
        _ => return None,
    })
}

/// The name of a number that is loaded.
fn load(step: Instruction<'_>) -> Option<String> {
    let n = step.number().unwrap_or(0);
    Some(match step.opcode {
        Opcode::Load => operand(step)?,
        Opcode::LoadAnalogue => format!("IW{n}"),
        Opcode::LoadTimer => format!("T{n}.ET"),
        Opcode::LoadCount => format!("C{n}.CV"),
        Opcode::LoadMarkers => format!("MB{n}"),
        Opcode::LoadInputs => "IB0".to_owned(),
        Opcode::LoadOutputs => "QB0".to_owned(),
        _ => return None,
    })
}

/// Where a number is stored.
fn number_target(step: Instruction<'_>) -> Option<String> {
    let n = step.number().unwrap_or(0);
    Some(match step.opcode {
        Opcode::Store => format!("D{n}"),
        Opcode::StoreCount => format!("C{n}.CV"),
        Opcode::StorePwm => format!("QW{n}"),
        Opcode::StoreMarkers => format!("MB{n}"),
        Opcode::StoreOutputs => "QB0".to_owned(),
        Opcode::PresetCounter => format!("C{n}.PV"),
        Opcode::PresetTimer => format!("T{n}.PT"),
        _ => return None,
    })
}

/// The register or constant of an operation.
fn operand(step: Instruction<'_>) -> Option<String> {
    match step.operand {
        Operand::Value(Value::Register(register)) => Some(format!("D{register}")),
        Operand::Value(Value::Constant(number)) => Some(number.to_string()),
        _ => None,
    }
}

/// An operation on a number, and its operand.
fn operation(step: Instruction<'_>) -> Option<(&'static str, String)> {
    Some(match step.opcode {
        Opcode::Negate => ("NEG", String::new()),
        Opcode::SquareRoot => ("SQRT", String::new()),
        Opcode::ShiftLeft | Opcode::ShiftRight => {
            (step.opcode.row().letters, step.number()?.to_string())
        }
        Opcode::Load => return None,
        opcode => (opcode.row().letters, operand(step)?),
    })
}

fn comparison(opcode: Opcode) -> bool {
    matches!(
        opcode,
        Opcode::Greater
            | Opcode::GreaterOrEqual
            | Opcode::Equal
            | Opcode::NotEqual
            | Opcode::LessOrEqual
            | Opcode::Less
    )
}

fn target(target: Target) -> String {
    match target {
        Target::Output(n) => format!("Q{n}"),
        Target::Marker(n) => format!("M{n}"),
    }
}
