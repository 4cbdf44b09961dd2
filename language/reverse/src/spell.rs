//! A rung of instructions as lines of Instruction List.

use unoclp_core::isa::{Class, Opcode, Operand, Value};
use unoclp_core::{Instruction, Target};
use unoclp_il::words::{named, operator, words};

/// The lines of a rung; none where Instruction List has no words for it. Timers are named in file order, so
/// those before it are counted.
pub(crate) fn rung(steps: &[Instruction<'_>], timers: &mut u8) -> Option<Vec<String>> {
    let own = steps.iter().filter(|step| step.is_own_timer()).count() as u8;
    let steps = match steps {
        [first, rest @ ..] if first.opcode == Opcode::NewRung => rest,
        steps => steps,
    };
    let mut speller = Speller {
        steps,
        at: 0,
        timers: *timers,
        pushed: 0,
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
    /// How many values are pushed.
    pushed: u8,
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
        before.is_some_and(|step| comparison(*step))
    }

    /// From after an opening code to its `41`.
    fn branch(&mut self, opening: Opcode) -> Option<()> {
        let operator = operator(opening);
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
            let (operator, operand) = match load(step) {
                Some(name) if self.pushed > 0 => ("LD", name),
                _ => operation(step)?,
            };
            self.line(operator, &operand);
            self.count_pushed(step)?;
            if comparison(step) {
                return Some(());
            }
        }
    }

    /// Counts what an operation pushes or takes.
    fn count_pushed(&mut self, step: Instruction<'_>) -> Option<()> {
        let takes = step.operand == Operand::Value(Value::Popped);
        match step.opcode {
            Opcode::Push => self.pushed += 1,
            opcode if takes || opcode == Opcode::StoreTable => {
                self.pushed = self.pushed.checked_sub(1)?;
            }
            _ => {}
        }
        Some(())
    }

    /// Operations up to a comparison or the last of the stores.
    fn operations_or_store(&mut self) -> Option<()> {
        let mut stored = false;
        self.pushed = 0;
        loop {
            let step = *self.steps.get(self.at)?;
            if let Some(name) = number_target(step) {
                self.line("ST", &name);
                stored = true;
            } else if self.pushed > 0 && load(step).is_some() {
                self.line("LD", &load(step)?);
            } else if stored && (load(step).is_some() || contact(step).is_some()) {
                return Some(());
            } else {
                let (operator, operand) = operation(step)?;
                self.line(operator, &operand);
                self.count_pushed(step)?;
                stored = step.opcode == Opcode::StoreTable;
                if comparison(step) {
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
        let class = step.opcode.class();
        if class == Class::Part {
            self.line(words(step)?.0, "");
            return first.then_some(());
        }
        if class == Class::Label {
            let number = step.number().filter(|_| *first)?;
            self.lines.push(format!("L{number:02}:"));
            return Some(());
        }
        let (operator, operand) = match class {
            Class::Logic | Class::Xor | Class::Coil | Class::Leave | Class::Count => words(step)?,
            Class::If => words(step)?,
            Class::Timer => (operator(step.opcode), String::new()),
            Class::Rung | Class::Label | Class::OpenOr | Class::OpenAnd | Class::OpenXor => {
                return None;
            }
            Class::Close | Class::StorePoint | Class::RecallPoint | Class::Part => {
                return None;
            }
            Class::Contact | Class::Condition | Class::ValueContact | Class::Comparison => {
                return None;
            }
            Class::Load | Class::LoadResult | Class::Operation | Class::Store | Class::Setting => {
                return None;
            }
        };
        // At the head of a rung the scan goes on elsewhere for certain: the operator is that without C.
        if let (Class::Leave, true, Some(always)) = (class, *first, operator.strip_suffix('C')) {
            self.line(always, &operand);
            return Some(());
        }
        if *first {
            self.line("LD", "TRUE");
            *first = false;
        }
        match step.timer() {
            Some(block) => {
                self.timers += 1;
                // A line of Instruction List is a timer of its own.
                let driven = target(block.target)?;
                self.line(operator, &format!("T{}, {}", self.timers, block.preset));
                self.line("ST", &driven);
            }
            None => self.line(operator, &operand),
        }
        Some(())
    }
}

/// The name of a contact's point, and whether it is inverted.
fn contact(step: Instruction<'_>) -> Option<(String, bool)> {
    let contact = matches!(step.opcode.class(), Class::Contact | Class::Condition);
    Some((named(step).filter(|_| contact)?, step.opcode.is_inverted()))
}

/// The name of a number that is loaded.
fn load(step: Instruction<'_>) -> Option<String> {
    named(step).filter(|_| step.opcode.class() == Class::Load)
}

/// Where a number is stored.
fn number_target(step: Instruction<'_>) -> Option<String> {
    let place = step.opcode.class() == Class::Store && step.opcode != Opcode::StoreTable;
    named(step).filter(|_| place)
}

/// An operation on a number, and its operand.
fn operation(step: Instruction<'_>) -> Option<(&'static str, String)> {
    let works = matches!(step.opcode.class(), Class::Operation | Class::Comparison)
        || step.opcode == Opcode::StoreTable;
    words(step).filter(|_| works)
}

fn comparison(step: Instruction<'_>) -> bool {
    step.opcode.class() == Class::Comparison
}

/// What a timer drives; none where it calls another again.
fn target(target: Target) -> Option<String> {
    match target {
        Target::Output(n) => Some(format!("Q{n}")),
        Target::Marker(n) => Some(format!("M{n}")),
        Target::Timer(_) => None,
    }
}
