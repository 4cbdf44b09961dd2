//! How points are stored: in the byte of their row, or beyond 16 in two bytes. The UNO has none of the latter, and no board
//! with a firmware has outputs above 64 that a timer drives: what is compiled for one has nothing of them.
//!
//! A row whose byte holds a point names the others in two bytes: one of its own, then XX. Those of its own are the
//! bytes that would store the branch points 09 to 15, which no rung has.

use super::{BEHIND_POINTS, FIRST_POINT};

#[cfg(any(not(target_arch = "avr"), mega))]
pub(crate) use wide::{far_row, holds_number, is_far, near_row};

#[cfg(all(target_arch = "avr", not(mega)))]
pub(crate) use narrow::{far_row, holds_number, is_far, near_row};

#[cfg(not(target_arch = "avr"))]
pub(crate) use wide::{far_output, stored_target};

/// The byte of the row that a first stored byte belongs to.
pub(crate) const fn first_of(byte: u8) -> u8 {
    if holds_point(byte) {
        byte & 0xF0
    } else {
        near_row(byte)
    }
}

/// Whether the low four bits of a first stored byte are the index of a point.
pub const fn holds_point(byte: u8) -> bool {
    byte >= FIRST_POINT && byte < BEHIND_POINTS && !is_far(byte)
}

#[cfg(any(not(target_arch = "avr"), mega))]
mod wide {
    use super::holds_point;
    use crate::isa::{FIRST_POINT, POINTS};
    #[cfg(not(target_arch = "avr"))]
    use crate::isa::{MARKER_TARGET, TIMER_TARGET};

    /// The first byte of the first row's points above 16, and the first after those of the last row, a reset coil's.
    const FAR: u8 = 0x88;
    const BEHIND_FAR: u8 = 0x8F;
    /// A stored target of a timer from this byte on is an output above 64.
    #[cfg(not(target_arch = "avr"))]
    const FAR_TARGET: u8 = 0xC0;

    /// Whether a first stored byte is that of a point above 16, which follows it.
    pub(crate) const fn is_far(byte: u8) -> bool {
        byte >= FAR && byte < BEHIND_FAR
    }

    /// The byte of the row that a first byte of a far point belongs to; any other as it is.
    pub(crate) const fn near_row(byte: u8) -> u8 {
        match is_far(byte) {
            true => (byte - FAR + (FIRST_POINT >> 4)) << 4,
            false => byte,
        }
    }

    /// Whether the byte of this row holds the point with this number.
    pub(crate) const fn holds_number(row: u8, xx: u8) -> bool {
        holds_point(row) && xx <= POINTS
    }

    /// The first byte of this row where it does not hold its point.
    pub(crate) const fn far_row(row: u8) -> u8 {
        match holds_point(row) {
            true => FAR + (row >> 4) - (FIRST_POINT >> 4),
            false => row,
        }
    }

    /// How the output with this number, from 1, is stored as a timer's target.
    #[cfg(not(target_arch = "avr"))]
    pub(crate) const fn stored_target(xx: u8) -> u8 {
        match xx {
            ..=MARKER_TARGET => xx.saturating_sub(1),
            _ => FAR_TARGET - 1 - MARKER_TARGET + xx,
        }
    }

    /// The index of the output above 64 that is stored so as a timer's target; none of a marker and of another output.
    #[cfg(not(target_arch = "avr"))]
    pub(crate) const fn far_output(stored: u8) -> Option<u8> {
        match stored.checked_sub(FAR_TARGET) {
            Some(index) if stored < TIMER_TARGET => Some(index + MARKER_TARGET),
            _ => None,
        }
    }
}

#[cfg(all(target_arch = "avr", not(mega)))]
mod narrow {
    use super::holds_point;

    #[inline(always)]
    pub(crate) const fn is_far(_: u8) -> bool {
        false
    }

    #[inline(always)]
    pub(crate) const fn near_row(byte: u8) -> u8 {
        byte
    }

    #[inline(always)]
    pub(crate) const fn holds_number(row: u8, _: u8) -> bool {
        holds_point(row)
    }

    #[inline(always)]
    pub(crate) const fn far_row(row: u8) -> u8 {
        row
    }
}
