//! Self-diagnosis beside the scans, at a bounded cost.
//!
//! Owns what is looked at and how often; must not know what a fault leads to.

use crate::board::Board;
use crate::board::watchdog;
use core::mem;
use unoclp_core::{Cause, Crc16};

/// So many bytes of the program are gone through in a step: the largest in a quarter of a second.
const BYTES: u8 = if cfg!(mega) { 16 } else { 4 };

/// What the diagnosis keeps from step to step.
pub struct Diagnosis {
    /// How many bytes of the linked program have been gone through.
    at: u16,
    /// The checksum so far, and what it was when the program was taken into run memory.
    sum: Crc16,
    expected: Crc16,
}

impl Diagnosis {
    /// Of a program that has just been taken into run memory.
    pub fn new(program: &[u8]) -> Diagnosis {
        Diagnosis {
            at: 0,
            sum: Crc16::default(),
            expected: Crc16::of(program),
        }
    }

    /// Looks at the stack, the supply, and some bytes of that program.
    ///
    /// # Errors
    /// The anomaly that it found.
    #[inline(never)]
    pub fn step(&mut self, board: &Board, program: &[u8]) -> Result<(), Cause> {
        if !watchdog::guard_is_whole() {
            return Err(Cause::StackOverflow);
        }
        if board.analogue.is_low() {
            return Err(Cause::SupplyLow);
        }
        let rest = program.get(self.at.into()..).unwrap_or_default();
        let next = rest.get(..BYTES.into()).unwrap_or(rest);
        self.sum.extend(next);
        self.at += u16::from(BYTES);
        if next.len() < BYTES.into() {
            self.end()
        } else {
            Ok(())
        }
    }

    /// All of the program has been gone through: its checksum is what it was.
    fn end(&mut self) -> Result<(), Cause> {
        self.at = 0;
        if mem::take(&mut self.sum) == self.expected {
            Ok(())
        } else {
            Err(Cause::ProgramDamaged)
        }
    }
}
