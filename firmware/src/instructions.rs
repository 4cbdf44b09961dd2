//! The core's instruction table, in program memory: whoever loads a program reads it there, and so does the
//! engine's linker.

use crate::board::flash::Table;
use unoclp_core::isa::{PACKED, Rows};
use unoclp_core::{Board, Facts};

/// The name is for the engine's assembly.
#[unsafe(link_section = ".progmem.data")]
#[unsafe(export_name = "ENGINE_ROWS")]
static ROWS: Table<u8, PACKED> = Table::new(ENGINE.packed());

/// What the board has.
#[cfg(not(mega))]
pub const BOARD: Board = match cfg!(nano) {
    true => Board::NANO,
    false => Board::UNO,
};
#[cfg(mega)]
pub const BOARD: Board = Board::MEGA;

/// Whose instructions it has: the loader of a Nano refuses some of the UNO's.
const ENGINE: Board = {
    #[cfg(not(mega))]
    const ENGINE: Board = Board::UNO;
    #[cfg(mega)]
    const ENGINE: Board = Board::MEGA;
    ENGINE
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
