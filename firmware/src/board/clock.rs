//! The millisecond clock, from timer 1 (ATmega328P datasheet, section 16).

use super::chip::TC1;
use super::shared::Shared;
use avr_device::interrupt;
use core::arch::global_asm;
use unoclp_core::Millis;

/// The chip's clock, Hz (ceramic resonator of the UNO).
pub const CLOCK_HZ: u32 = 16_000_000;

/// Clock cycles of one count of timer 1.
const PRESCALER: u32 = 8;
/// The last count of a millisecond.
const TOP: u16 = (CLOCK_HZ / PRESCALER / 1000 - 1) as u16;

global_asm!(tick_interrupt!(), include_str!("tick.s"), options(raw));

/// Milliseconds since start, wrapping: the interrupt in `tick.s` counts them, and nothing else writes
/// here. The symbol is for it, and lets a simulator set the clock.
#[unsafe(export_name = "MILLIS")]
static NOW: Shared<Millis> = Shared::new(0);

/// Reads the clock together with something else, again where the interrupt has come between. It is
/// never kept waiting for that: it counts the age of the scan, even of one that hangs just here.
#[inline(always)]
fn undisturbed<T>(mut other: impl FnMut() -> T) -> (Millis, T) {
    loop {
        // What the interrupt changes between these shows in the low byte, which comes back only after
        // 256 ms.
        let before = NOW.low_byte();
        let other = other();
        let millis = NOW.get();
        if NOW.low_byte() == before {
            return (millis, other);
        }
    }
}

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

/// Whether the clock is on: at the start that is so only where the firmware has begun again without
/// a reset of the chip, which switches everything off.
pub fn is_on(timer: &TC1) -> bool {
    timer.timsk1().read().toie1().bit_is_set()
}

/// The time in ms since start, wrapping after 49.7 days.
pub fn now() -> Millis {
    undisturbed(|| ()).0
}

/// An end of waiting.
#[derive(Clone, Copy)]
pub struct Deadline(u16);

impl Deadline {
    /// So many ms from now, 32,767 at most.
    pub fn after(time: u16) -> Deadline {
        Deadline((now() as u16).wrapping_add(time))
    }

    /// So many ms from the start of the clock, 32,767 at most.
    pub const fn from_start(time: u16) -> Deadline {
        Deadline(time)
    }

    /// Whether it has passed; to be asked within 32 s.
    #[inline(never)]
    pub fn has_passed(self) -> bool {
        self.0.wrapping_sub(now() as u16) as i16 <= 0
    }
}

/// A moment, to half a microsecond.
#[derive(Clone, Copy, Default)]
pub struct Moment {
    /// Half microseconds of this millisecond, 0 to [`TOP`].
    pub count: u16,
    /// The millisecond that the count belongs to.
    of: u8,
}

/// This moment, and the time in ms since start, wrapping after 49.7 days.
#[inline(always)]
pub fn moment(timer: &TC1) -> (Millis, Moment) {
    let (millis, count) = undisturbed(|| timer.tcnt1().read().bits());
    let of = millis as u8;
    (millis, Moment { count, of })
}

/// The longest time that is measured between two moments, ms: in half microseconds it fits 16 bits.
const LONGEST: u8 = 31;

impl Moment {
    /// When the timer stood at this count, less than a millisecond before.
    pub fn back_to(self, count: u16) -> Moment {
        let before = u8::from(count > self.count);
        Moment {
            count,
            of: self.of.wrapping_sub(before),
        }
    }

    /// The time from an earlier moment, in half microseconds, 65,535 for anything longer; none where
    /// the clock stands.
    pub fn since(self, earlier: Moment) -> Option<u16> {
        let millis = self.of.wrapping_sub(earlier.of);
        if millis > LONGEST {
            return Some(u16::MAX);
        }
        let mut halves = self.count.wrapping_sub(earlier.count);
        if millis == 0 && halves > TOP {
            return None;
        }
        for _ in 0..millis {
            halves = halves.wrapping_add(TOP + 1);
        }
        Some(halves)
    }
}
