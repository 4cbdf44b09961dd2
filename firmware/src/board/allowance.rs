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

/// The most that may be used where one more writing is to be allowed.
pub const LAST: u16 = before(AT_ONCE);
/// The same where four are left for later.
pub const FIFTH_LAST: u16 = before(AT_ONCE - 4);
/// The same of programs, 1,200 of which may be stored while the supply stays: people store a hundred in a day, and none
/// in the next. Each writes its mark twice.
pub const LAST_PROGRAM: u16 = before(1_200);

/// What all of so many writings but one take.
const fn before(writings: u16) -> u16 {
    COST * (writings - 1)
}

// As in `watchdog.rs`.
global_asm!(
    ".section .noinit,\"aw\",@nobits",
    "SETTINGS_USED: .skip 2",
    "MARKERS_USED: .skip 2",
    "NUMBERS_USED: .skip 2",
    "PROGRAMS_USED: .skip 2",
    ".global SETTINGS_USED, MARKERS_USED, NUMBERS_USED, PROGRAMS_USED",
    ".previous",
);

// SAFETY: the lines above define them, with these sizes; any bits are a value of each. No interrupt knows them.
unsafe extern "C" {
    /// By the settings.
    pub safe static SETTINGS_USED: Shared<u16>;
    /// By the retentive markers.
    pub safe static MARKERS_USED: Shared<u16>;
    /// By the numbers that a program keeps.
    pub safe static NUMBERS_USED: Shared<u16>;
    /// By the mark of the program.
    pub safe static PROGRAMS_USED: Shared<u16>;
}

/// Power came: nothing is used.
pub fn renew() {
    SETTINGS_USED.set(0);
    MARKERS_USED.set(0);
    NUMBERS_USED.set(0);
    PROGRAMS_USED.set(0);
}

/// Uses one writing more where no more than `most` is used; says whether that is so.
#[inline(never)]
pub fn take(used: &Shared<u16>, most: u16) -> bool {
    let before = used.get();
    if before > most {
        return false;
    }
    used.set(before + COST);
    true
}

/// A minute has passed, which gives so much back.
#[inline(never)]
pub fn give(used: &Shared<u16>, by: u16) {
    used.set(used.get().saturating_sub(by));
}
