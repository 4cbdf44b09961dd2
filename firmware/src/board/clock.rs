//! The millisecond clock, from timer 1 (ATmega328P datasheet, section 16).

use super::CLOCK_HZ;
use avr_device::atmega328p::TC1;
use avr_device::interrupt::{self, Mutex};
use core::arch::global_asm;
use core::cell::Cell;
use unoclp_core::Millis;

/// Clock cycles of one count of timer 1.
const PRESCALER: u32 = 8;
/// The last count of a millisecond.
const TOP: u16 = (CLOCK_HZ / PRESCALER / 1000 - 1) as u16;

global_asm!(include_str!("tick.s"), options(raw));

/// Milliseconds since start, wrapping: the interrupt in `tick.s` counts them, and nothing else writes
/// here. The symbol is for it, and lets a simulator set the clock.
#[unsafe(export_name = "MILLIS")]
static NOW: Mutex<Cell<Millis>> = Mutex::new(Cell::new(0));

/// Starts the clock and enables interrupts.
pub fn start(timer: &TC1) {
    // Mode 14, fast PWM up to ICR1: overflows each TOP + 1 counts, and leaves D9 its PWM.
    timer.icr1().write(|w| w.set(TOP));
    timer.tccr1a().write(|w| w.wgm1().set(0b10));
    timer
        .tccr1b()
        .write(|w| w.wgm1().set(0b11).cs1().prescale_8());
    timer.timsk1().write(|w| w.toie1().set_bit());
    // SAFETY: called once at start, outside any critical section.
    unsafe { interrupt::enable() };
}

/// Whether the clock is on: at the start that is so only where the firmware has begun anew without
/// a reset of the chip, which switches everything off.
pub fn is_on(timer: &TC1) -> bool {
    timer.timsk1().read().toie1().bit_is_set()
}

/// The time in ms since start, wrapping after 49.7 days.
pub fn now() -> Millis {
    interrupt::free(|cs| NOW.borrow(cs).get())
}

/// A moment, to half a microsecond.
#[derive(Clone, Copy)]
pub struct Moment {
    /// The time in ms since start, wrapping after 49.7 days.
    pub millis: Millis,
    /// Half microseconds of this millisecond, 0 to [`TOP`].
    count: u16,
    /// The millisecond that the count belongs to: the next, where the interrupt is still to come.
    of: u8,
}

/// This moment.
#[inline(always)]
pub fn moment(timer: &TC1) -> Moment {
    interrupt::free(|cs| {
        let millis = NOW.borrow(cs).get();
        let mut moment = Moment {
            millis,
            count: timer.tcnt1().read().bits(),
            of: millis as u8,
        };
        if timer.tifr1().read().tov1().bit_is_set() {
            moment.count = timer.tcnt1().read().bits();
            moment.of = moment.of.wrapping_add(1);
        }
        moment
    })
}

/// The longest time that is measured between two moments, ms: in half microseconds it fits 16 bits.
const LONGEST: u8 = 31;
/// No scan takes so many ms: the watchdog comes first.
const AGES: u8 = 128;

impl Moment {
    /// No moment that time is measured from: [`since`](Moment::since) gives none.
    pub fn forgotten(self) -> Moment {
        Moment {
            of: self.of.wrapping_sub(AGES),
            ..self
        }
    }

    /// The time from an earlier moment of the same millisecond, in half microseconds.
    #[inline(always)]
    pub fn since_in_millisecond(self, earlier: Moment) -> Option<u16> {
        (self.of == earlier.of).then(|| self.count.wrapping_sub(earlier.count))
    }

    /// The time from an earlier moment, in half microseconds, 65,535 for anything longer; none from
    /// one that is forgotten.
    pub fn since(self, earlier: Moment) -> Option<u16> {
        let millis = self.of.wrapping_sub(earlier.of);
        if millis >= AGES {
            return None;
        }
        if millis > LONGEST {
            return Some(u16::MAX);
        }
        let mut halves = self.count.wrapping_sub(earlier.count);
        for _ in 0..millis {
            halves = halves.wrapping_add(TOP + 1);
        }
        Some(halves)
    }
}
