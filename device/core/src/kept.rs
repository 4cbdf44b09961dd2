//! Numbers that outlast a power cut (NC-21).
//!
//! Owns which a program keeps, what that takes of program memory, and how old a kept number may be; must not
//! know in what form a board keeps them.

use crate::Program;
use crate::isa::Opcode;

/// A program keeps so many numbers at most.
pub const KEPT: u8 = 16;
/// Bytes of a number.
pub const NUMBER_BYTES: u8 = 4;
/// Bytes of a record beside its numbers: a sequence number and a checksum.
pub const RECORD_BYTES: u8 = 3;
/// So many minutes after it was last written, a place of a board's memory may be written again: 3,156 s make
/// 100,000 writings in ten years.
pub const RECORDED: u8 = 53;

/// A program leaves room for so many records: a power cut while one is written leaves the others.
const RECORDS: usize = 2;

/// A number that a program keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// A register, from 1.
    Register(u8),
    /// The number of a counter, from 1.
    Counter(u8),
}

/// Whether an instruction that is stored as this names a number to be kept.
pub(crate) const fn declares(stored: u8) -> bool {
    stored == Opcode::KeepRegister as u8 || stored == Opcode::KeepCounter as u8
}

/// Bytes of program memory that another number to be kept leaves free for records.
pub(crate) fn ring_bytes(first: bool) -> u8 {
    let more = if first { RECORD_BYTES } else { 0 };
    RECORDS as u8 * (NUMBER_BYTES + more)
}

/// What a program in its stored form keeps, in its order.
pub(crate) fn numbers(stored: &[u8]) -> impl Iterator<Item = Number> {
    stored.as_chunks().0.iter().map_while(|&[code, number]| {
        if code == Opcode::KeepRegister as u8 {
            Some(Number::Register(number))
        } else if code == Opcode::KeepCounter as u8 {
            Some(Number::Counter(number))
        } else {
            None
        }
    })
}

impl Program<'_> {
    /// The numbers that it keeps over a power cut, in its order.
    pub fn kept(&self) -> impl Iterator<Item = Number> {
        numbers(self.stored())
    }

    /// How many there are.
    pub fn kept_count(&self) -> u8 {
        self.kept
    }

    /// How old a kept number may be after a power cut, minutes: as often as the board's memory stands. None
    /// where nothing is kept.
    pub fn kept_within(&self) -> Option<u16> {
        let numbers = usize::from(self.kept_count());
        let room = usize::from(self.board().stored_bytes).saturating_sub(self.stored_bytes());
        let record = numbers * usize::from(NUMBER_BYTES) + usize::from(RECORD_BYTES);
        let records = (room / record).max(1);
        (numbers > 0).then(|| usize::from(RECORDED).div_ceil(records) as u16)
    }
}
