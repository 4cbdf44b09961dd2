//! A rung of instructions as lines of Instruction List.

mod words;

use unoclp_core::Instruction;
use unoclp_core::isa::{Opcode, Operand};
use words::{comparison, contact, load, number_target, operation, target};

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
