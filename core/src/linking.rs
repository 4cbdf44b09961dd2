//! The way from the stored form of a program to the form that an engine runs, in the same memory.

use crate::Program;

/// A program on its way to its linked form.
///
/// As an iterator it gives the bytes of the stored form in order (see [`isa`](crate::isa));
/// [`put`](Linking::put) takes what stands for them. The linked form takes the place of the stored
/// form from the front, so at no moment may it be longer than what has been read; behind the last
/// byte it may go on into the memory that is left.
#[derive(Debug)]
pub struct Linking<'m> {
    memory: &'m mut [u8],
    code_bytes: usize,
    read: usize,
    written: usize,
    fits: bool,
}

impl<'m> Linking<'m> {
    pub(crate) fn new(program: Program<'m>) -> Linking<'m> {
        Linking {
            memory: program.memory,
            code_bytes: program.code_bytes,
            read: 0,
            written: 0,
            fits: true,
        }
    }

    /// Takes the next byte of the linked form.
    pub fn put(&mut self, byte: u8) {
        let all_read = self.read >= self.code_bytes;
        match self.memory.get_mut(self.written) {
            Some(place) if all_read || self.written < self.read => *place = byte,
            _ => self.fits = false,
        }
        self.written += 1;
    }

    /// The linked form, and the memory behind it; none where the linked form did not fit.
    pub fn finish(self) -> Option<(&'m mut [u8], &'m mut [u8])> {
        let parts = self.memory.split_at_mut_checked(self.written);
        parts.filter(|_| self.fits)
    }
}

impl Iterator for Linking<'_> {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        let byte = *self.memory.get(..self.code_bytes)?.get(self.read)?;
        self.read += 1;
        Some(byte)
    }
}
