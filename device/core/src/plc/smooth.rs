//! What goes on over time: the first-order filter and the integration (NC-17).

use crate::Millis;

/// The largest value that a filter takes, in either direction.
const FILTERED: i32 = 0x3F_FFFF;
/// The largest value and time, ms, that an integration takes in one scan.
const INTEGRATED: i32 = 0x7FFF;

/// Smooths a value; gives the value that is smoothed. Every `time` ms it goes one part in 2 to the power
/// of `strength` of the way.
pub(super) fn filter(data: &mut [u8; 9], value: i32, strength: u8, time: u16, now: Millis) -> i32 {
    let [begun, a, b, c, d, e, f, g, h] = *data;
    let mut since = Millis::from_le_bytes([a, b, c, d]);
    let mut sum = i32::from_le_bytes([e, f, g, h]);
    let value = value.clamp(-FILTERED - 1, FILTERED) << 8;
    if begun == 0 {
        (since, sum) = (now, value);
    } else if now.wrapping_sub(since) >= time.into() {
        since = now;
        sum += (value - sum) >> strength;
    }
    data[0] = 1;
    data[1..5].copy_from_slice(&since.to_le_bytes());
    data[5..].copy_from_slice(&sum.to_le_bytes());
    (sum + 128) >> 8
}

/// Adds to a register what a value comes to over the time since the scan before, per second.
pub(super) fn integrate(
    data: &mut [u8; 7],
    register: &mut i32,
    value: i32,
    runs: bool,
    now: Millis,
) {
    let [ran, a, b, c, d, e, f] = *data;
    if runs && ran != 0 {
        let since = Millis::from_le_bytes([a, b, c, d]);
        let passed = now.wrapping_sub(since).min(INTEGRATED.cast_unsigned());
        let value = value.clamp(-INTEGRATED - 1, INTEGRATED);
        let rest = i16::from_le_bytes([e, f]);
        let sum = value * passed.cast_signed() + i32::from(rest);
        *register = register.wrapping_add(sum / 1000);
        data[5..].copy_from_slice(&((sum % 1000) as i16).to_le_bytes());
    }
    data[0] = runs.into();
    data[1..5].copy_from_slice(&now.to_le_bytes());
}
