//! A board as the loader knows it.

use crate::Profile;

/// What the loader asks of a board.
pub trait Board {
    /// What fits on it.
    fn profile(&self) -> Profile;

    /// Fills bytes with those of the packed instruction table (`isa::PACKED`) from an index on, from where this board
    /// keeps it; with anything beyond its end.
    fn read(&self, at: usize, bytes: &mut [u8]);
}
