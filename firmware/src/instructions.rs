//! The core's instruction table, in program memory: whoever loads a program reads it there, and so does the
//! engine's linker.

use crate::board::flash::Table;
use unoclp_core::{Board, Profile, isa};

/// The name is for the engine's assembly.
#[unsafe(link_section = ".progmem.data")]
#[unsafe(export_name = "ENGINE_ROWS")]
static ROWS: Table<u8, { isa::PACKED.len() }> = Table::new(isa::PACKED);

/// What fits on the board.
pub const PROFILE: Profile = match cfg!(nano) {
    true => Profile::NANO,
    false => Profile::UNO,
};

/// The board, as the loader knows it.
pub struct Uno;

impl Board for Uno {
    #[inline(always)]
    fn profile(&self) -> Profile {
        PROFILE
    }

    #[inline(always)]
    fn read(&self, at: usize, bytes: &mut [u8]) {
        // SAFETY: the static stands in that section.
        unsafe { ROWS.read(at, bytes) }
    }
}
