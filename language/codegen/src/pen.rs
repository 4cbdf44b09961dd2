//! The instructions as far as they are written.
//!
//! Owns what acc and value hold at each moment, where a rung begins and a label may stand. Must not know the program.

use super::seats::Seat;
use unoclp_core::isa::{Opcode, Operand, Value};
use unoclp_core::{Instruction, Target};
use unoclp_text::diagnostics::Span;

/// An instruction, with what is decided at the end.
#[derive(Clone, Debug)]
pub(super) enum Written {
    Is(Instruction<'static>),
    Label(u32),
    /// A jump; one back belongs to a loop.
    Jump(Opcode, u32, Option<usize>),
    /// A timer's block, by the timer's index, with its preset and what it drives.
    Timer(Opcode, usize, i32, Option<Target>),
    /// Another call of it, with its preset.
    Again(Opcode, usize, i32),
    /// What names a timer.
    OfTimer(Opcode, usize),
    /// A line of the program file that the text says.
    Code(i32),
}

/// An instruction, where it comes from, and the cell that it names.
#[derive(Clone, Debug)]
pub(super) struct Line {
    pub written: Written,
    pub at: Span,
    pub cell: Option<u32>,
}

impl Line {
    /// Whether it stores to this register.
    pub(super) fn is_store(&self, register: u8) -> bool {
        matches!(&self.written, Written::Is(is) if is.opcode == Opcode::Store && is.number() == Some(register))
    }

    /// Whether it names this register, in a table or a move as well.
    pub(super) fn names(&self, register: u8) -> bool {
        let Written::Is(Instruction { opcode, operand }) = &self.written else {
            return false;
        };
        let among =
            |first: u8, length: u8| (first..first.saturating_add(length)).contains(&register);
        match operand {
            Operand::Value(Value::Register(of)) => *of == register,
            Operand::Number(of) => *opcode == Opcode::Store && *of == register,
            Operand::Table { first, length } => among(*first, *length),
            Operand::Move { from, to, count } => among(*from, *count) || among(*to, *count),
            _ => false,
        }
    }

    /// Names another register, which this cell has.
    pub(super) fn rename(&mut self, from: u8, to: u8, cell: u32) {
        let Written::Is(Instruction { opcode, operand }) = &mut self.written else {
            return;
        };
        let held = match operand {
            Operand::Value(Value::Register(of)) => of,
            Operand::Number(of) if *opcode == Opcode::Store => of,
            _ => return,
        };
        if *held == from {
            *held = to;
            self.cell = Some(cell);
        }
    }
}

/// What acc holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Acc {
    One,
    /// What this bit holds.
    Bit(Seat),
    Other,
}

#[derive(Debug)]
pub(super) struct Pen {
    pub lines: Vec<Line>,
    pub acc: Acc,
    /// Where the coil or contact stands that has made it hold a bit.
    pub held: Option<(Seat, Span)>,
    /// Whether a label may stand here.
    pub head: bool,
    /// The register or analogue input that value equals.
    pub holds: Option<Seat>,
    pub at: Span,
}

impl Pen {
    pub(super) fn new() -> Pen {
        Pen {
            lines: Vec::new(),
            acc: Acc::One,
            held: None,
            head: true,
            holds: None,
            at: Span::default(),
        }
    }

    fn line(&mut self, written: Written, cell: Option<u32>) {
        self.head = false;
        self.lines.push(Line {
            written,
            at: self.at,
            cell,
        });
    }

    pub(super) fn plain(&mut self, opcode: Opcode) {
        self.line(Written::Is(Instruction::plain(opcode)), None);
    }

    /// The instruction with this index names this cell.
    pub(super) fn names(&mut self, line: usize, cell: u32) {
        if let Some(line) = self.lines.get_mut(line) {
            line.cell = Some(cell);
        }
    }

    pub(super) fn numbered(&mut self, opcode: Opcode, number: u8, cell: Option<u32>) {
        self.line(Written::Is(Instruction::numbered(opcode, number)), cell);
    }

    pub(super) fn with(&mut self, opcode: Opcode, operand: Operand<'static>, cell: Option<u32>) {
        self.line(Written::Is(Instruction { opcode, operand }), cell);
    }

    pub(super) fn of_timer(&mut self, opcode: Opcode, timer: usize, cell: Option<u32>) {
        self.line(Written::OfTimer(opcode, timer), cell);
    }

    pub(super) fn timer(
        &mut self,
        opcode: Opcode,
        timer: usize,
        preset: i32,
        target: Option<Target>,
        cell: u32,
    ) {
        self.line(Written::Timer(opcode, timer, preset, target), Some(cell));
        self.acc = Acc::Other;
    }

    /// Another call of a timer whose block stands before it.
    pub(super) fn timer_again(&mut self, opcode: Opcode, timer: usize, preset: i32, cell: u32) {
        self.line(Written::Again(opcode, timer, preset), Some(cell));
        self.acc = Acc::Other;
    }

    /// Whether the block of this timer has been written.
    pub(super) fn has_timer(&self, timer: usize) -> bool {
        let is_own =
            |line: &Line| matches!(line.written, Written::Timer(_, own, ..) if own == timer);
        self.lines.iter().any(is_own)
    }

    /// An instruction that the text says, after which acc is 1 and a rung begins, or neither is known.
    pub(super) fn codes(&mut self, codes: &[(i32, Span)], begins: bool) {
        let around = self.at;
        for (code, at) in codes {
            self.at = *at;
            self.line(Written::Code(*code), None);
        }
        self.at = around;
        self.head = begins;
        self.holds = None;
        self.acc = if begins { Acc::One } else { Acc::Other };
    }

    /// An operation, after which value is something else.
    pub(super) fn operation(&mut self, opcode: Opcode, value: Value, cell: Option<u32>) {
        self.with(opcode, Operand::Value(value), cell);
        self.holds = None;
    }

    pub(super) fn changes_value(&mut self, opcode: Opcode) {
        self.plain(opcode);
        self.holds = None;
    }

    /// acc := 1, in a new rung where it is not so.
    pub(super) fn fresh(&mut self) {
        if self.acc != Acc::One {
            self.new_rung();
        }
    }

    pub(super) fn new_rung(&mut self) {
        self.plain(Opcode::NewRung);
        self.acc = Acc::One;
        self.head = true;
    }

    /// IF, ELS, END.
    pub(super) fn border(&mut self, opcode: Opcode) {
        self.plain(opcode);
        self.acc = Acc::One;
        self.head = true;
    }

    pub(super) fn label(&mut self, label: u32) {
        if !self.head {
            self.new_rung();
        }
        self.line(Written::Label(label), None);
        self.head = true;
        self.acc = Acc::One;
        self.holds = None;
    }

    /// A jump where acc is 1, or 0.
    pub(super) fn jump(&mut self, opcode: Opcode, label: u32, back: Option<usize>) {
        self.line(Written::Jump(opcode, label, back), None);
        // After a jump that is always made nothing is reached but by a label.
        if self.acc != Acc::One {
            self.acc = Acc::Other;
        }
    }
}
