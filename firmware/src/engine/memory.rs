//! What a program works on, as others may see and change it between two scans.

use super::data::Data;

/// What the program works on.
pub struct Memory<'a> {
    /// Markers, registers and readings.
    pub data: &'a mut Data,
    /// The data of the timers, and of the counters; empty where no program runs.
    pub timers: &'a mut [u8],
    /// See `timers`.
    pub counters: &'a mut [u8],
}

impl<'a> Memory<'a> {
    /// Where no program runs.
    pub fn idle(data: &'a mut Data) -> Memory<'a> {
        Memory {
            data,
            timers: &mut [],
            counters: &mut [],
        }
    }
}
