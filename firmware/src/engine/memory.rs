//! What a program works on, as others may see and change it between two scans.

use super::data::Data;
use unoclp_core::Millis;
use unoclp_core::isa::{COUNTER_DATA, REGISTER_BYTES, TIMER_DATA};

/// What the program works on.
pub struct Memory<'a> {
    /// Markers, registers and readings.
    pub data: &'a mut Data,
    /// The registers beyond those of `data`, which they follow in memory; empty where no program runs that names them.
    pub far: &'a mut [u8],
    /// The data of the timers, in file order, and of the counters, up to the highest that is named; empty where no
    /// program runs.
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

/// The most words that are done at once: an even number, so that no value is torn.
pub const SLICE: u8 = 64;

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
            far: &mut [],
            timers: &mut [],
            counters: &mut [],
        }
    }

    /// Reads or writes words of these values or of their presets, from that word on: each value is two, the high one
    /// first, and of each word the high byte. What the program does not have reads as 0. No further than to the end of a
    /// [`SLICE`], counted from the first value on; gives how many words.
    #[inline(never)]
    pub fn words(
        &mut self,
        values: Values,
        presets: bool,
        first: u8,
        words: &mut [[u8; 2]],
        write: bool,
        now: Millis,
    ) -> u8 {
        let count = (words.len() as u8).min(SLICE - (first & (SLICE - 1)));
        let (begin, length, size, preset) = match values {
            Values::Registers => {
                let length = size_of_val(&self.data.registers) + self.far.len();
                (
                    self.data.registers.as_mut_ptr().cast(),
                    length,
                    REGISTER_BYTES,
                    0,
                )
            }
            Values::Timers => (self.timers.as_mut_ptr(), self.timers.len(), TIMER_DATA, 5),
            Values::Counters => (
                self.counters.as_mut_ptr(),
                self.counters.len(),
                COUNTER_DATA,
                4,
            ),
        };
        let at = if presets { preset } else { 0 };
        let elapsed = !presets && values == Values::Timers;
        let at = length.min(usize::from(first >> 1) * size + at);
        let how = u8::from(write) << WRITTEN | u8::from(elapsed) << ELAPSED;
        // SAFETY: it reads or writes no more words than there are, and values from the first to the end of their data;
        // each of them that begins there is whole, since the data of each timer and counter are. Run memory comes
        // right after the registers of `data`, and begins with the others that the program has.
        unsafe {
            engine_words(
                words.as_mut_ptr(),
                begin.wrapping_add(at),
                begin.wrapping_add(length),
                count,
                size as u8,
                first,
                how,
                now,
            );
        }
        count
    }
}
