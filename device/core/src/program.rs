//! A checked program.

use crate::held::Held;
use crate::isa::{Operand, Value};
use crate::{Board, Instruction, Needs};

/// An operation with a constant of four bytes.
const CONSTANT_COST: usize = 6;

/// A program that has passed every check (NC-10), in the run memory that it was loaded into.
///
/// Only a [`Loader`](crate::Loader) makes one, so it holds these for everyone after it:
/// **every stored byte begins or continues an instruction of the table; every point exists on the
/// board; every branch is closed in its rung and
/// every pushed value taken in it, at most 8 deep; every IF has its END; every recalled branch point was
/// stored before in its rung; every jump leads to the head of a rung; every timer that is named
/// exists; the linked form and all data fit run memory.**
#[derive(Debug)]
pub struct Program<'m> {
    pub(crate) held: Held,
    /// The stored form, then what is left of run memory.
    pub(crate) memory: &'m mut [u8],
    pub(crate) code_bytes: usize,
    pub(crate) run_bytes: usize,
    pub(crate) timers: u8,
    pub(crate) counters: u8,
    pub(crate) registers: u8,
    pub(crate) kept: u8,
    pub(crate) codes: u16,
    pub(crate) needs: Needs,
}

impl<'m> Program<'m> {
    /// The board that it has been checked for.
    pub fn board(&self) -> Board {
        self.held.board()
    }

    /// How many codes the file holds, program start and each code with its operand lines as one.
    pub fn codes(&self) -> u16 {
        self.codes
    }

    /// Bytes of the stored form.
    pub fn stored_bytes(&self) -> usize {
        self.code_bytes
    }

    /// How many timers the program has.
    pub fn timers(&self) -> usize {
        self.timers.into()
    }

    /// The highest counter that the program names; 0 where it names none.
    pub fn counters(&self) -> usize {
        self.counters.into()
    }

    /// The highest register that there is: that of the highest that the program names, and at least
    /// [`Engine::near_registers`](crate::Engine::near_registers).
    pub fn registers(&self) -> usize {
        self.registers.into()
    }

    /// Bytes of run memory that are set aside for the linked form and all data.
    pub fn linked_bytes(&self) -> usize {
        self.run_bytes
    }

    /// What it asks of the board's pins.
    pub fn needs(&self) -> Needs {
        self.needs
    }

    /// Lends the program together with its memory, to run it there. Once it has run, run memory holds its
    /// data and no longer what is after the stored form.
    pub fn lend(&mut self) -> Program<'_> {
        Program {
            memory: self.memory,
            ..*self
        }
    }

    /// The instructions in order.
    pub fn steps(&self) -> Steps<'_> {
        Steps::new(self.stored())
    }

    /// The stored form: what to keep, and to give to [`Loader::restore`](crate::Loader::restore).
    #[inline(never)]
    pub fn stored(&self) -> &[u8] {
        self.memory.get(..self.code_bytes).unwrap_or_default()
    }
}

/// The instructions of a checked program, in order.
#[derive(Clone, Debug)]
pub struct Steps<'c> {
    code: &'c [u8],
    at: usize,
    cost: usize,
}

impl<'c> Steps<'c> {
    pub(crate) fn new(code: &'c [u8]) -> Steps<'c> {
        Steps {
            code,
            at: 0,
            cost: 0,
        }
    }

    /// The same, from the instruction on that begins at this stored byte, behind others that cost so much.
    pub(crate) fn behind(self, at: usize, cost: usize) -> Steps<'c> {
        Steps { at, cost, ..self }
    }

    /// The stored byte that the next instruction begins at.
    pub fn at(&self) -> usize {
        self.at
    }

    /// What jumping back over the instructions so far costs (NC-19): their stored bytes, each constant counted as 4,
    /// as it was before shorter ones took less.
    pub(crate) fn cost(&self) -> usize {
        self.cost
    }
}

impl<'c> Iterator for Steps<'c> {
    type Item = Instruction<'c>;

    #[inline]
    fn next(&mut self) -> Option<Instruction<'c>> {
        let (instruction, size) = Instruction::from_stored(self.code.get(self.at..)?)?;
        self.at += size;
        self.cost += match instruction.operand {
            Operand::Value(Value::Constant(_)) => CONSTANT_COST,
            _ => size,
        };
        Some(instruction)
    }
}
