//! Self-diagnosis beside the scans, at a bounded cost.
//!
//! Owns what is looked at and how often; must not know what a fault leads to.

use crate::board::Board;
use crate::board::watchdog;
use core::{mem, slice};
use unoclp_core::{Cause, Crc16};

/// So many bytes of the program are gone through in a step: the largest in a quarter of a second.
const BYTES: u8 = 4;

/// What the diagnosis keeps from step to step.
pub struct Diagnosis<'m> {
    /// The linked program, and what of it is still to be checked.
    program: &'m [u8],
    rest: slice::Iter<'m, u8>,
    /// The check sum so far, and what it was when the program was taken into run memory.
    sum: Crc16,
    expected: Crc16,
}

impl<'m> Diagnosis<'m> {
    /// Of a program that has just been taken into run memory.
    pub fn new(program: &'m [u8]) -> Diagnosis<'m> {
        Diagnosis {
            program,
            rest: program.iter(),
            sum: Crc16::default(),
            expected: Crc16::of(program),
        }
    }

    /// Looks at the stack, the supply, and some bytes of the program.
    ///
    /// # Errors
    /// The anomaly that it found.
    #[inline(never)]
    pub fn step(&mut self, board: &Board) -> Result<(), Cause> {
        if !watchdog::guard_is_whole() {
            return Err(Cause::StackOverflow);
        }
        if board.analogue.is_low() {
            return Err(Cause::SupplyLow);
        }
        for _ in 0..BYTES {
            let Some(&byte) = self.rest.next() else {
                return self.end();
            };
            self.sum.push(byte);
        }
        Ok(())
    }

    /// All of the program has been gone through: its check sum is what it was.
    fn end(&mut self) -> Result<(), Cause> {
        self.rest = self.program.iter();
        if mem::take(&mut self.sum) == self.expected {
            Ok(())
        } else {
            Err(Cause::ProgramDamaged)
        }
    }
}
