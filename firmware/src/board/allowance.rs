//! How often cells of the EEPROM may still be written, so that none is worn out in ten years without power cycling.
//!
//! Owns the count, in memory that start-up does not clear: a restart by command gives nobody more. Must not know what
//! is written. A cell is good for 100,000 writings (ATmega328P datasheet, section 8.1), which is one in
//! [`COST`] minutes.

use super::shared::Shared;
use core::arch::global_asm;
use unoclp_core::RECORDED;

/// What one writing takes: so many minutes.
pub const COST: u16 = RECORDED as u16;
/// So many may follow one another.
const AT_ONCE: u16 = 16;

// As in `watchdog.rs`.
global_asm!(
    ".section .noinit,\"aw\",@nobits",
    "SETTINGS_LEFT: .skip 2",
    "MARKERS_LEFT: .skip 2",
    "NUMBERS_LEFT: .skip 2",
    ".global SETTINGS_LEFT, MARKERS_LEFT, NUMBERS_LEFT",
    ".previous",
);

// SAFETY: the lines above define them, with these sizes; any bits are a value of each. No interrupt knows them.
unsafe extern "C" {
    /// Of the settings.
    pub safe static SETTINGS_LEFT: Shared<u16>;
    /// Of the retentive markers.
    pub safe static MARKERS_LEFT: Shared<u16>;
    /// Of the numbers that a program keeps.
    pub safe static NUMBERS_LEFT: Shared<u16>;
}

/// Power came.
pub fn fill() {
    SETTINGS_LEFT.set(COST * AT_ONCE);
    MARKERS_LEFT.set(COST * AT_ONCE);
    NUMBERS_LEFT.set(COST * AT_ONCE);
}

/// What is left behind one more writing, if that is allowed.
pub fn behind(left: &Shared<u16>) -> Option<u16> {
    left.get().checked_sub(COST)
}

/// A minute has passed, which gives so much.
#[inline(never)]
pub fn grow(left: &Shared<u16>, by: u16) {
    left.set((left.get() + by).min(COST * AT_ONCE));
}
