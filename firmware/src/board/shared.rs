//! Memory that interrupts or a reset come upon: single bytes and words, each read and written as it is.
//!
//! Owns that the compiler leaves each access where it stands; must not know who else accesses it.

use core::cell::UnsafeCell;

/// A value that others access too: an interrupt, or the start after a reset.
#[repr(transparent)]
pub struct Shared<T>(UnsafeCell<T>);

// SAFETY: the chip has one core. A byte is read and written in one instruction, so nobody sees it half
// written; more than that is for whom no interrupt that writes it is enabled, or who drops what one has
// come into.
unsafe impl<T> Sync for Shared<T> {}

impl<T: Copy> Shared<T> {
    /// With this value.
    pub const fn new(value: T) -> Shared<T> {
        Shared(UnsafeCell::new(value))
    }

    /// The value.
    #[inline(always)]
    pub fn get(&self) -> T {
        // SAFETY: it is valid, and any bits are a value. Volatile, since others write it; without an atomic
        // load, which would keep the clock's interrupt waiting: that counts the age of the scan.
        unsafe { self.0.get().read_volatile() }
    }

    /// Its low byte alone.
    #[inline(always)]
    pub fn low_byte(&self) -> u8 {
        // SAFETY: as above; it is the first of at least one.
        unsafe { self.0.get().cast::<u8>().read_volatile() }
    }

    /// From now on this value.
    #[inline(always)]
    pub fn set(&self, value: T) {
        // SAFETY: as above.
        unsafe { self.0.get().write_volatile(value) }
    }
}
