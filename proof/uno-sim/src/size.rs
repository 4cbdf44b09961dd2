//! What a program takes of the flash.

use crate::Program;

impl Program {
    /// Bytes of flash that the program fills, counted from address 0: code, constants, and the start values of its
    /// variables.
    pub fn flash_bytes(&self) -> usize {
        self.flash.len()
    }
}
