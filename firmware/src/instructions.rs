//! The core's instruction table, in program memory: whoever loads a program reads it there, and so does the
//! engine's linker.

use crate::board::flash::Table;
use unoclp_core::isa::{PACKED, Rows};
use unoclp_core::{Board, Facts};

/// The name is for the engine's assembly.
#[unsafe(link_section = ".progmem.data")]
#[unsafe(export_name = "ENGINE_ROWS")]
static ROWS: Table<u8, PACKED> = Table::new(Board::UNO.packed());

/// What the board has.
pub const BOARD: Board = match cfg!(nano) {
    true => Board::NANO,
    false => Board::UNO,
};

/// The board, as the loader knows it.
pub struct Uno;

impl Facts for Uno {
    #[inline(always)]
    fn board(&self) -> Board {
        BOARD
    }
}

impl Rows for Uno {
    #[inline(always)]
    fn read(&self, at: usize, bytes: &mut [u8]) {
        // SAFETY: the static stands in that section.
        unsafe { ROWS.read(at, bytes) }
    }
}
