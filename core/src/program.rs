//! A checked program.

use crate::{Instruction, Linking};
use core::slice;

/// A program that has passed every check (NC-10), in the run memory that it was loaded into.
///
/// Only a [`Loader`](crate::Loader) makes one, so it holds these for everyone after it:
/// **every stored byte begins or continues an instruction of the table; every point exists on the
/// board; every branch is closed in its rung, at most 8 deep; every recalled branch point was
/// stored before in its rung; behind the code there is memory for the data of every timer.**
#[derive(Debug)]
pub struct Program<'m> {
    /// The code, then room for the timers' data.
    pub(crate) memory: &'m mut [u8],
    pub(crate) code_bytes: usize,
    pub(crate) timers: usize,
    pub(crate) codes: u16,
}

impl<'m> Program<'m> {
    /// Begins to turn the program into the form that an engine runs.
    pub fn link(self) -> Linking<'m> {
        Linking::new(self)
    }

    /// How many codes the file holds, program start and timer blocks each as one.
    pub fn codes(&self) -> u16 {
        self.codes
    }

    /// Bytes of the stored form.
    pub fn stored_bytes(&self) -> usize {
        self.code_bytes
    }

    /// How many timers the program has.
    pub fn timers(&self) -> usize {
        self.timers
    }

    /// Bytes of run memory taken: the code and the data of the timers.
    pub fn linked_bytes(&self) -> usize {
        crate::Profile::linked_size(self.code_bytes, self.timers)
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
    code: slice::Iter<'c, u8>,
}

impl<'c> Steps<'c> {
    pub(crate) fn new(code: &'c [u8]) -> Steps<'c> {
        Steps { code: code.iter() }
    }
}

impl Iterator for Steps<'_> {
    type Item = Instruction;

    #[inline]
    fn next(&mut self) -> Option<Instruction> {
        let byte = *self.code.next()?;
        Instruction::from_stored(byte, &mut self.code)
    }
}
