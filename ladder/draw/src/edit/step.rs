//! An instruction that may still lack its address or its operands.

use unoclp_core::isa::{Class, Kind, Line, Opcode, POPPED};
use unoclp_core::{Instruction, Target, isa};

/// An instruction as it stands in a document: its code, and what follows the code, each of which may be missing.
///
/// It always has as many lines as its kind and its number ask for, and a number below 100; whether the numbers are
/// those of points that exist, the loader says.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Step {
    opcode: Opcode,
    number: Option<u8>,
    lines: Vec<Option<i32>>,
}

impl Step {
    /// An instruction of which nothing is known but what it does.
    pub fn new(opcode: Opcode) -> Step {
        let (number, lines) = (None, Vec::new());
        Step {
            opcode,
            number,
            lines,
        }
        .fitted()
    }

    /// It with this XX, 0 to 99; of an operation 0 is a constant, and 99 what was pushed.
    #[must_use]
    pub fn with_number(mut self, number: impl Into<Option<u8>>) -> Step {
        self.number = number.into();
        self.fitted()
    }

    /// It with these operand lines, as a program file has them; those that are missing stay so.
    #[must_use]
    pub fn with_lines(mut self, lines: impl IntoIterator<Item = Option<i32>>) -> Step {
        self.lines = lines.into_iter().collect();
        self.fitted()
    }

    /// It as another instruction, whose number and lines are the same as far as that has them.
    #[must_use]
    pub fn with_opcode(mut self, opcode: Opcode) -> Step {
        self.opcode = opcode;
        self.fitted()
    }

    /// An instruction that lacks nothing.
    pub fn of(instruction: Instruction<'_>) -> Step {
        let lines = instruction.codes().skip(1).map(Some);
        Step::new(instruction.opcode)
            .with_number(instruction.number())
            .with_lines(lines)
    }

    /// What it does.
    pub fn opcode(&self) -> Opcode {
        self.opcode
    }

    /// The part that it plays in a rung.
    pub fn class(&self) -> Class {
        self.opcode.class()
    }

    /// XX of its code; none where it has none, or where that is missing.
    pub fn number(&self) -> Option<u8> {
        self.number
    }

    /// What a timer drives, or which one it calls again; none where that is missing, and of what is no timer.
    pub fn target(&self) -> Option<Target> {
        let line = self.lines.get(1).copied().flatten();
        line.filter(|_| self.kind() == Kind::Timer).and_then(target)
    }

    /// Whether it is a timer of its own, which has a number.
    pub fn is_own_timer(&self) -> bool {
        self.kind() == Kind::Timer && !matches!(self.target(), Some(Target::Timer(_)))
    }

    /// Its operand lines, as a program file has them.
    pub fn lines(&self) -> &[Option<i32>] {
        &self.lines
    }

    /// Whether nothing is missing.
    pub fn is_complete(&self) -> bool {
        self.has_its_number() && self.lines.iter().all(Option::is_some)
    }

    /// The lines of a program file that say it; none where something is missing.
    pub fn codes(&self) -> Option<impl Iterator<Item = i32> + '_> {
        let row = self.opcode.row();
        let code = row.code + row.code.signum() * i32::from(self.number.unwrap_or(0));
        let lines = self.lines.iter().flatten().copied();
        self.is_complete()
            .then(|| std::iter::once(code).chain(lines))
    }

    fn has_its_number(&self) -> bool {
        self.number.is_some() || !self.kind().has_number()
    }

    fn kind(&self) -> Kind {
        self.opcode.row().kind
    }

    /// It with as many lines as it has to have.
    fn fitted(mut self) -> Step {
        self.number = self
            .number
            .filter(|&number| number <= POPPED && self.kind().has_number());
        let lines = match self.kind().first_line(self.number.unwrap_or(POPPED)) {
            None => 0,
            Some(Line::TimerPreset | Line::MoveTo) => 2,
            Some(Line::FromLow) => 4,
            Some(Line::Steps) => match self.lines.first() {
                Some(&Some(steps)) => 1 + steps.clamp(0, DRUM_STEPS) as usize,
                _ => 1,
            },
            Some(_) => 1,
        };
        self.lines.resize(lines, None);
        self
    }
}

/// The most steps of a drum that a document holds lines for (NC-17).
const DRUM_STEPS: i32 = 32;

/// What stands on the operand line of a timer that drives this.
pub(crate) fn target_line(target: Target) -> i32 {
    target.code()
}

/// What a timer with this operand line drives.
pub(crate) fn target(line: i32) -> Option<Target> {
    let number = |base: i32| {
        u8::try_from(line - base)
            .ok()
            .filter(|&number| number <= POPPED)
    };
    match line {
        isa::MARKER_OPERAND..isa::OUTPUT_OPERAND => number(isa::MARKER_OPERAND).map(Target::Marker),
        isa::OUTPUT_OPERAND..isa::TIMER_OPERAND => number(isa::OUTPUT_OPERAND).map(Target::Output),
        isa::TIMER_OPERAND.. => number(isa::TIMER_OPERAND).map(Target::Timer),
        _ => None,
    }
}
