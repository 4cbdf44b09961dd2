//! Where everything is that a program in its linked form refers to.

use super::memory::Memory;
use crate::operation::Images;
use crate::store::Kept;
use unoclp_core::isa::TIMER_DATA;

/// Inputs in the low half of the images' register, outputs in the high half.
pub const POINTS: u8 = Images::OUTPUTS_AT;

/// Bytes of a number that is kept: its address, and its place in the snapshot.
pub const ADDRESS_BYTES: usize = 2;
/// See [`ADDRESS_BYTES`].
pub const SNAPSHOT_BYTES: usize = 4;

/// What the linked form of a program refers to.
pub struct Layout<'m> {
    /// [`Data`](super::Data), timers and counters.
    pub memory: Memory<'m>,
    /// The address of each number that is kept, and the snapshot of them.
    pub kept: &'m mut [u8],
    /// See `kept`.
    pub snapshot: &'m mut [u8],
    /// The address of the first linked byte.
    pub begin: u16,
    /// The program.
    pub stored: Kept,
    /// Whether it jumps back.
    pub jumps_back: bool,
}

impl Layout<'_> {
    /// The address after the last of own data.
    pub fn own_end(&self) -> u16 {
        self.kept.as_ptr() as usize as u16
    }

    /// The address of the timer with this index.
    pub fn timer(&self, index: u8) -> u16 {
        self.memory.timers.as_ptr() as usize as u16 + u16::from(index) * TIMER_DATA as u16
    }
}
