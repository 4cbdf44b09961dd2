//! Instructions that concern registers, RAM and flash alone, many at once: nine of ten, for which simavr's core looks
//! through nested cases, and asks for what is due after each.
//!
//! Owns how they go on until the next that reaches into the chip, which simavr executes; [`kind`] knows which they are, and
//! [`execute`] what each does. A test compares every opcode with simavr. It knows the ATmega328P alone.

mod execute;
mod kind;
#[cfg(test)]
mod tests;

use super::Avr;
use crate::chip::Chip;
use execute::{DATA, Machine};
use kind::{KINDS, Kind};
use simavr_ffi as ffi;

/// Cycles of the longest instruction.
const LONGEST: u64 = 4;
/// Bytes of the longest instruction that is skipped, with the skip.
const MOST: u32 = 6;

/// How far they go.
#[derive(Clone, Copy, Debug)]
pub struct Far {
    /// While fewer cycles than these have gone by since the last reset.
    pub end: u64,
    /// Until the instruction at this byte address is the next; at least one is executed.
    pub stop: Option<u32>,
    /// Where the program ends: nothing goes there.
    pub code_end: u32,
}

impl Avr {
    /// Executes as many instructions as are quick, none where the next is not. Gives the lowest stack pointer, where any
    /// was executed.
    pub fn run_quickly(&mut self, far: Far) -> Option<u16> {
        if self.chip() != Chip::Atmega328p {
            return None;
        }
        let avr = self.as_ptr().as_ptr();
        // SAFETY: the chip is initialised, and `&mut self` keeps everybody else out, callbacks too, since nothing of simavr
        // is called. Data and flash are allocations of their own, of as many bytes as `Avr::data` and `Avr::flash` have,
        // and nothing else refers to them; the first timer is null or one of the chip's own slots.
        let (chip, data, flash, due) = unsafe {
            let chip = &mut *avr;
            let data = &mut *chip.data.cast::<[u8; DATA]>();
            let flash = std::slice::from_raw_parts(chip.flash, chip.flashend as usize + 1);
            let due = chip
                .cycle_timers
                .timer
                .as_ref()
                .map_or(u64::MAX, |timer| timer.when);
            (chip, data, flash, due)
        };
        if chip.state as u32 != ffi::cpu_Running || chip.interrupt_state != 0 {
            return None;
        }
        let end = far.end.min(due.saturating_sub(LONGEST));
        let stop = far.stop.unwrap_or(u32::MAX);
        let kinds: &[Kind; 1 << 16] = &KINDS;
        let mut machine = Machine {
            data,
            sreg: &mut chip.sreg,
            flash,
            code_end: far.code_end,
            low: u16::MAX,
        };
        let (mut pc, mut cycle) = (chip.pc, chip.cycle);
        // Nobody goes past the end, not even by a skip.
        while cycle < end && pc + MOST < far.code_end {
            let Some(opcode) = machine.word(pc) else {
                break;
            };
            let kind = kinds[usize::from(opcode)];
            let Some((next, cycles)) = machine.execute(kind, opcode, pc) else {
                break;
            };
            // Only a jump goes there, and it has changed nothing yet.
            if machine.accept(next, pc).is_none() {
                break;
            }
            (pc, cycle) = (next, cycle + cycles);
            if pc == stop {
                break;
            }
        }
        let low = machine.low;
        if cycle == chip.cycle {
            return None;
        }
        (chip.pc, chip.cycle) = (pc, cycle);
        Some(low)
    }
}
