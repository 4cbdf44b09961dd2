//! What the command line says, in the two languages that it speaks: one table, in which no text is without its twin.
//!
//! - `spoken`: the language of this process
//! - `table`: the texts
//! - `board`: what a board tells, and what can go wrong with one, as `client::words` has it
//!
//! Owns the words, and which language this process speaks. Must not know who says them, nor where.

mod board;
mod spoken;
mod table;

pub use board::{
    behind, failure, foreign, journal_failure, left_forced, lock, no_board_there, parity, pass,
    record_failure, settings, settings_kept, spoken_line, stage, start, store_failure, to_unlock,
    trouble, undone, unsettled, volts,
};
#[cfg(test)]
pub(crate) use spoken::SPOKEN_HERE;
pub use spoken::{speak, spoken};
pub use table::*;

use std::io;
use unoclp_core::Cause;
use unoclp_program::{Size, WrittenIn, diagnosis};
use unoclp_words::system;

/// What a program may be written in.
pub fn languages() -> String {
    programs_are(WrittenIn::programs(spoken()))
}

/// A fault without its place: `fault 75: too many backward jumps in one scan (NC-19)`.
pub fn fault(cause: Cause) -> String {
    fault_of(cause.number(), diagnosis::cause(cause, spoken()))
}

/// How much of the board a program takes.
pub fn size(size: &Size) -> String {
    size.text(spoken())
}

/// An error of the system.
pub fn io(error: &io::Error) -> String {
    system(spoken(), error.kind(), &error.to_string())
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_message_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }
}
