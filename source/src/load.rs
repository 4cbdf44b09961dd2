//! From numeric code to a checked program.

use crate::BOARD;
use unoclp_core::{Fault, Loader, Program};

/// Loads a program file into this run memory; gives its first fault where it has one.
pub fn load<'m>(file: &[u8], memory: &'m mut [u8]) -> Result<Program<'m>, Fault> {
    let mut loader = Loader::new(memory, BOARD);
    for &byte in file {
        loader.push(byte)?;
    }
    loader.finish()
}
