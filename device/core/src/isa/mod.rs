//! What an instruction is: its code, its letters, its stored form and its effect.
//!
//! The rows of [`instructions!`](crate::instructions) say it once. Decoding, encoding, listings, the engine's
//! list of handlers, the words of Instruction List, the symbols of a ladder and the constants of the assembly
//! come from them.
//!
//! ARCHITECTURE.md, "To add an instruction", lists the places that one takes, and who asks for each. A new kind or class is one
//! more variant of its enum, and the compiler then asks for it everywhere.
//!
//! # Stored form
//!
//! An instruction is stored as the byte of its row. Of the rows from 0x10 to 0x9F the low four bits
//! of that byte hold the index of the point; a point above 16 has a byte of its own row and one with XX (`far`). Of the
//! others that have an XX, a byte with XX follows;
//! then the [operand lines](Line), each in as many bytes as [`Line::bytes`] says, the low one first.

mod class;
mod far;
mod instruction;
mod kind;
mod packed;
mod table;

pub use class::Class;
pub use far::holds_point;
#[cfg(any(not(target_arch = "avr"), mega))]
pub(crate) use far::is_far;
#[cfg(not(target_arch = "avr"))]
pub(crate) use far::{far_output, stored_target};
pub(crate) use far::{far_row, first_of, holds_number, near_row};
pub use instruction::{Instruction, Operand, Value};
pub use kind::{Kind, Line};
pub(crate) use packed::{
    By, Entry, KIND, KINDS, find, packed_kind, packed_rows, packed_run_bytes, stored_size,
};
pub use packed::{KIND_IN_ROW, PACKED, ROW, ROW_BEHIND_POINTS, ROW_OF_FIRST_POINT, Rows};
pub use table::{Opcode, TABLE};

/// One row of the instruction table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The code; where it has an XX, with XX = 00.
    pub code: i32,
    /// What each pair of digits spells in ASCII.
    pub letters: &'static str,
    /// What the instruction works on.
    pub kind: Kind,
    /// The part it plays in a rung.
    pub class: Class,
    /// The byte that stores it.
    pub stored: u8,
    /// Bytes of run memory that are data of its own, apart from those of timers and counters: of an edge
    /// acc as it was; of a filter whether it has begun, a time stamp, and the smoothed value times 256; of an
    /// integration whether it goes on, a time stamp, and the thousandths that are left; of a number that is kept
    /// its snapshot, 4 bytes, and for a board's engine where the number stands, 2.
    pub own: u8,
    /// The effect in one line.
    pub effect: &'static str,
}

/// A stored target of a timer from this byte on is a marker, below it an output.
pub const MARKER_TARGET: u8 = 0x40;
/// From this byte on it is the timer that the block calls again, T 01 first. Those before are the outputs above 64.
pub const TIMER_TARGET: u8 = 0xE3;
/// Timers T 01 to this number can be called again (NC-30).
pub const CALLED_AGAIN: u8 = 22;

/// The first stored byte of the rows whose bytes hold a point, and the first after them.
pub const FIRST_POINT: u8 = 0x10;
/// See [`FIRST_POINT`].
pub const BEHIND_POINTS: u8 = 0xA0;
/// Points 01 to this number are held by such a byte.
pub const POINTS: u8 = 16;

/// The branch points of a rung are 01 to this number (NC-8).
pub const BRANCH_POINTS: u8 = 8;
/// The deepest nesting of branches and blocks (NC-8).
pub const DEEPEST: u8 = 8;
/// The first of the eight retentive markers (NC-12).
pub const RETENTIVE: u8 = 57;
/// System markers S 01 to this number (NC-12).
pub const SYSTEM_MARKERS: u8 = 4;
/// Registers D 01 to this number, at most: of an operation, 99 is [`POPPED`] (NC-16).
pub const REGISTERS: u8 = 98;
/// XX of an operation whose left operand is what was pushed (NC-22).
pub const POPPED: u8 = 99;
/// As XX is stored: of a constant of one byte, and of two; of one of four it is 0.
pub const BYTE_CONSTANT: u8 = 100;
/// See [`BYTE_CONSTANT`].
pub const WORD_CONSTANT: u8 = 101;

/// Program start, the first code of a file. It is checked and not stored.
pub const START: i32 = 0;
/// The code of an output as an operand line: `79XX` with XX = 00.
pub const OUTPUT_OPERAND: i32 = 7900;
/// The code of a marker as an operand line: `77XX` with XX = 00.
pub const MARKER_OPERAND: i32 = 7700;
/// The code of a timer as an operand line: `84XX` with XX = 00.
pub const TIMER_OPERAND: i32 = 8400;
/// The code of a register as an operand line: `68XX` with XX = 00.
pub const REGISTER_OPERAND: i32 = 6800;

/// Bytes of a timer's data in run memory: its state, a time stamp, its preset.
pub const TIMER_DATA: usize = 9;
/// Bytes of a counter's data in run memory: its value, its preset, its inputs as they were.
pub const COUNTER_DATA: usize = 9;

/// Bytes of a register in run memory.
pub const REGISTER_BYTES: usize = 4;

/// How many bytes store a constant whose XX is stored so; 0 where XX is no constant's.
pub const fn constant_bytes(xx: u8) -> u8 {
    if xx == 0 {
        4
    } else {
        xx.saturating_sub(BYTE_CONSTANT - 1)
    }
}

/// How XX of this constant is stored.
pub const fn stored_constant(number: i32) -> u8 {
    let (high, low) = ((number >> 16) as i16, number as i16);
    if high != low >> 15 {
        0
    } else if low as i8 as i16 == low {
        BYTE_CONSTANT
    } else {
        WORD_CONSTANT
    }
}

/// What a jump back may cost in all in one scan: each costs the stored bytes from its label to itself
/// (NC-19).
pub const JUMP_BUDGET: u16 = 2_000;

/// The last two digits of a code, where all before them are those of `base`.
///
/// By subtraction: a division of 32 bits would take 1.5 KB of the firmware.
#[inline(never)]
pub(crate) fn xx(code: i32, base: i32) -> Option<u8> {
    let xx = if base < 0 {
        base.wrapping_sub(code)
    } else {
        code.wrapping_sub(base)
    };
    (0..100).contains(&xx).then_some(xx as u8)
}

/// Whether an instruction that is stored so is one of REAL numbers (NC-23).
pub const fn is_real(stored: u8) -> bool {
    stored >= Opcode::RealAdd as u8 && stored <= Opcode::RealComparable as u8
}
