//! What a program works on, as others may see and change it between two scans.

use super::data::Data;
use unoclp_core::Millis;
use unoclp_core::isa::{COUNTER_DATA, NEAR_REGISTERS, REGISTER_BYTES, TIMER_DATA};

/// What the program works on.
pub struct Memory<'a> {
    /// Markers, registers and readings.
    pub data: &'a mut Data,
    /// The registers behind those of `data`, where a program runs that names them: they follow in memory too.
    pub more: &'a mut [u8],
    /// The data of the timers, and of the counters; empty where no program runs.
    pub timers: &'a mut [u8],
    /// See `timers`.
    pub counters: &'a mut [u8],
}

/// Values of 32 bits in a row, of which each has one or two.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Values {
    /// The registers.
    Registers,
    /// The presets of the timers, ms; or what has elapsed of them, only to be read.
    Timers,
    /// The presets of the counters, or what they have counted.
    Counters,
}

/// Bits of what [`engine_words`] is to do.
pub(super) const WRITTEN: u8 = 0;
pub(super) const ELAPSED: u8 = 1;

// SAFETY: `words.s` defines it so.
unsafe extern "C" {
    fn engine_words(
        words: *mut [u8; 2],
        value: *mut u8,
        end: *mut u8,
        count: u8,
        size: u8,
        first: u8,
        how: u8,
        now: Millis,
    );
}

impl<'a> Memory<'a> {
    /// Where no program runs.
    // Apart from who makes it, whose frame is large.
    #[inline(never)]
    pub fn idle(data: &'a mut Data) -> Memory<'a> {
        Memory {
            data,
            more: &mut [],
            timers: &mut [],
            counters: &mut [],
        }
    }

    /// Reads or writes words of these values or of their presets, from that word on: each value is two, the high one
    /// first, and of each word the high byte. What the program does not have reads as 0. At most 255 words.
    #[inline(never)]
    pub fn words(
        &mut self,
        values: Values,
        presets: bool,
        first: u16,
        words: &mut [[u8; 2]],
        write: bool,
        now: Millis,
    ) {
        let near = usize::from(NEAR_REGISTERS) * 2;
        let (bytes, size, preset, first) = match values {
            Values::Registers if usize::from(first) >= near => {
                (&mut *self.more, REGISTER_BYTES, 0, first - near as u16)
            }
            Values::Registers => (self.data.registers.as_flattened_mut(), REGISTER_BYTES, 0, first),
            Values::Timers => (&mut *self.timers, TIMER_DATA, 5, first),
            Values::Counters => (&mut *self.counters, COUNTER_DATA, 4, first),
        };
        let at = if presets { preset } else { 0 };
        let elapsed = !presets && values == Values::Timers;
        let bytes = bytes.get_mut(usize::from(first >> 1) * size + at..);
        let bytes = bytes.unwrap_or_default().as_mut_ptr_range();
        let how = u8::from(write) << WRITTEN | u8::from(elapsed) << ELAPSED;
        // SAFETY: it reads or writes as many words as there are, and values from the first to the end of `bytes`;
        // each of them that begins there is whole, since the data of each timer and counter are.
        unsafe {
            engine_words(
                words.as_mut_ptr(),
                bytes.start,
                bytes.end,
                words.len() as u8,
                size as u8,
                first as u8,
                how,
                now,
            );
        }
    }
}
