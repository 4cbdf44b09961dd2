//! Loops that only wait for a bit of an I/O register: time goes through them at once, exact to the cycle.
//!
//! Owns which loops those are, and how far the time may go in one; must not know what is waited for.

use super::Avr;
use simavr_ffi as ffi;
use std::ptr::NonNull;

/// `rjmp .-4`: the second instruction of a loop goes back to the first.
const BACK: u16 = 0xCFFE;
/// `rjmp .-2`: forever here.
const STAND: u16 = 0xCFFF;

/// How far the chip is let run: no further than here or there.
#[derive(Clone, Copy, Debug, Default)]
pub struct Leave {
    /// This cycle.
    pub end: u64,
    /// This byte address.
    pub stop: Option<u32>,
}

impl Avr {
    /// From within the callback that reads an I/O register, while `bit` of it is set. Where the program does nothing but
    /// read it until the bit is clear, so many whole rounds go by as fit before anything happens: a timer or an
    /// interrupt of the chip, or the end of the leave, in cycles since the last reset.
    ///
    /// # Safety
    /// See [`Avr::cycle_of`].
    pub unsafe fn pass_waiting(avr: NonNull<ffi::avr_t>, register: u16, bit: u8, leave: Leave) {
        // SAFETY: the caller's; plain values, and the flash as in `Avr::flash`.
        unsafe {
            let chip = &mut *avr.as_ptr();
            let flash = std::slice::from_raw_parts(chip.flash, chip.flashend as usize + 1);
            let Some(round) = Round::at(flash, chip.pc, register, bit) else {
                return;
            };
            pass(chip, &round, leave);
        }
    }

    /// The same between two steps, where the next instruction jumps to itself (`rjmp .-2`).
    pub fn pass_standing(&mut self, leave: Leave) {
        let pc = self.pc();
        if self.flash_word(pc) == STAND {
            let round = Round {
                cycles: 2,
                end: pc + 2,
            };
            // SAFETY: the chip is alive, and `&mut self` keeps everybody else out.
            unsafe { pass(&mut *self.as_ptr().as_ptr(), &round, leave) };
        }
    }
}

/// Lets whole rounds of the loop at PC go by.
///
/// # Safety
/// The chip is an initialised one.
unsafe fn pass(chip: &mut ffi::avr_t, round: &Round, leave: Leave) {
    let stops_here = leave
        .stop
        .is_some_and(|stop| (chip.pc..round.end).contains(&stop));
    if stops_here || chip.interrupt_state != 0 {
        return;
    }
    // SAFETY: the caller's; the first timer is null or one of the chip's own slots.
    let timer = unsafe { chip.cycle_timers.timer.as_ref() };
    let due = timer.map_or(0, |timer| timer.when);
    let rounds = due.min(leave.end).saturating_sub(chip.cycle) / round.cycles;
    chip.cycle += rounds.saturating_sub(1) * round.cycles;
}

/// One round of a loop.
#[derive(Debug, PartialEq, Eq)]
struct Round {
    cycles: u64,
    /// The byte address after it.
    end: u32,
}

impl Round {
    /// The loop at this byte address, where it waits for this bit: `sbic`, `rjmp`; or `in`, `andi`, `cpi` with 0 or
    /// none, `brne` (AVR Instruction Set Manual).
    fn at(flash: &[u8], pc: u32, register: u16, bit: u8) -> Option<Round> {
        let word = |n: u32| {
            let bytes = flash.get((pc + 2 * n) as usize..)?.first_chunk()?;
            Some(u16::from_le_bytes(*bytes))
        };
        let io = register - 0x20;
        let round = |instructions: u32| Round {
            cycles: u64::from(instructions) + 1,
            end: pc + 2 * instructions,
        };
        if io < 0x20 && word(0)? == 0x9900 | io << 3 | u16::from(bit) {
            return (word(1)? == BACK).then(|| round(2));
        }
        let read = word(0)?;
        let number = read >> 4 & 0x1F;
        if read != 0xB000 | (io & 0x30) << 5 | number << 4 | io & 0xF || number < 16 {
            return None;
        }
        let high = (number - 16) << 4;
        let mask = 1u16 << bit;
        if word(1)? != 0x7000 | (mask & 0xF0) << 4 | high | mask & 0xF {
            return None;
        }
        let compares = word(2)? == 0x3000 | high;
        let last = 2 + u32::from(compares);
        // `brne` counts from the instruction after it.
        let back = (last + 1).wrapping_neg() as u16 & 0x7F;
        (word(last)? == 0xF401 | back << 3).then(|| round(last + 1))
    }
}
