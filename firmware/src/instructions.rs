//! The core's instruction table, in program memory: whoever loads a program reads it there, and so does the
//! engine's linker.

use crate::board::flash::Table;
use unoclp_core::isa;

/// The name is for the engine's assembly.
#[unsafe(link_section = ".progmem.data")]
#[unsafe(export_name = "ENGINE_ROWS")]
static ROWS: Table<u8, { isa::PACKED.len() }> = Table::new(isa::PACKED);

/// Reads the instruction table from this index on.
pub fn read(at: usize, bytes: &mut [u8]) {
    // SAFETY: the static stands in that section.
    unsafe { ROWS.read(at, bytes) }
}
