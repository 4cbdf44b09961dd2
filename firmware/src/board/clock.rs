//! The millisecond clock, from timer 1 (ATmega328P datasheet, section 16).

use super::{CLOCK_HZ, watchdog};
use avr_device::atmega328p::TC1;
use avr_device::interrupt::{self, Mutex};
use core::cell::Cell;
use unoclp_core::Millis;

/// Clock cycles of one count of timer 1.
const PRESCALER: u32 = 8;
/// The last count of a millisecond.
const TOP: u16 = (CLOCK_HZ / PRESCALER / 1000 - 1) as u16;

/// Milliseconds since start, wrapping. The symbol lets a simulator set the clock.
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

/// The time in ms since start, wrapping after 49.7 days.
pub fn now() -> Millis {
    interrupt::free(|cs| NOW.borrow(cs).get())
}

/// A moment, to half a microsecond.
#[derive(Clone, Copy)]
pub struct Stamp {
    millis: u16,
    /// Half microseconds of this millisecond, 0 to [`TOP`].
    count: u16,
}

/// This moment.
pub fn stamp(timer: &TC1) -> Stamp {
    interrupt::free(|cs| {
        let mut millis = NOW.borrow(cs).get() as u16;
        let mut count = timer.tcnt1().read().bits();
        if timer.tifr1().read().tov1().bit_is_set() {
            // A millisecond has ended that the interrupt has not counted yet.
            count = timer.tcnt1().read().bits();
            millis = millis.wrapping_add(1);
        }
        Stamp { millis, count }
    })
}

impl Stamp {
    /// The time since an earlier moment, µs; 65,535 for anything longer.
    pub fn micros_since(self, earlier: Stamp) -> u16 {
        let millis = self.millis.wrapping_sub(earlier.millis);
        if millis > 64 {
            return u16::MAX;
        }
        // At most 64 ms and one more: in half microseconds this fits 17 bits.
        let halves = i32::from(millis) * (i32::from(TOP) + 1) + i32::from(self.count)
            - i32::from(earlier.count);
        (halves >> 1).clamp(0, i32::from(u16::MAX)) as u16
    }
}

#[avr_device::interrupt(atmega328p)]
fn TIMER1_OVF() {
    // SAFETY: interrupts are off while an interrupt runs.
    let cs = unsafe { interrupt::CriticalSection::new() };
    let now = NOW.borrow(cs);
    now.set(now.get().wrapping_add(1));
    watchdog::grow_older();
}
