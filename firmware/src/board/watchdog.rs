//! The watchdog, and what start-up can know of the run before it
//! (ATmega328P datasheet, sections 11.8 and 11.9).
//!
//! The boot loader of the UNO clears the chip's own record of why it was reset. So the millisecond
//! interrupt counts the age of the scan in memory that start-up does not clear: a run that ended
//! in the middle of an old scan was ended by the watchdog.

use super::allowance;
use super::chip::wdt::wdtcsr::W;
use super::chip::{CPU, WDT};
use super::shared::Shared;
use avr_device::interrupt;
use core::arch::global_asm;

/// A scan is overdue at this age, ms. The watchdog bites at 120 ms or thereabouts: its oscillator
/// is no quartz.
const OVERDUE: u8 = 110;

/// What the board is doing, in values that power-up does not leave by accident.
const STARTING: u16 = 0xC19A;
const SCANNING: u16 = 0x3AC7;
const COMMANDED: u16 = 0x653C;

/// What stands in the guard as long as nothing has overwritten it.
const WHOLE: u16 = 0x5AC3;

// Memory that start-up does not clear. In assembly, because a `static` in this section would come
// with a first value, and be loaded with it.
global_asm!(
    ".section .noinit,\"aw\",@nobits",
    "DOING: .skip 2",
    "RESTARTS: .skip 2",
    "FAULTS: .skip 2",
    "AGE: .skip 1",
    "GUARD: .skip 2",
    ".global DOING, RESTARTS, FAULTS, AGE, GUARD",
    ".previous",
);

// SAFETY: the lines above define them, with these sizes; any bits are a value of each. No interrupt knows
// the words.
unsafe extern "C" {
    safe static DOING: Shared<u16>;
    /// Restarts since power-up.
    safe static RESTARTS: Shared<u16>;
    /// Faults since power-up.
    safe static FAULTS: Shared<u16>;
    /// The age of the scan, or by one more, ms; it stops at 255. The clock's interrupt counts it.
    safe static AGE: Shared<u8>;
    /// The last static bytes: a stack that grows too far meets them first.
    safe static GUARD: Shared<u16>;
}

/// Why the board has started. In the order of the causes in `docs/modbus.md`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// Power came.
    Power,
    /// The reset button, or a computer that opened the serial port.
    Reset,
    /// The watchdog, because a scan took too long.
    Watchdog,
    /// The chip has gone to the reset vector by itself, because run memory or flash has changed
    /// under a scan.
    Astray,
    /// A command over Modbus.
    Command,
}

/// See [`started`].
static STARTED: Shared<Start> = Shared::new(Start::Power);

/// Why the board has started.
pub fn started() -> Start {
    STARTED.get()
}

/// The watchdog.
pub struct Watchdog {
    timer: WDT,
}

impl Watchdog {
    /// Stops the watchdog, which goes on after a reset that it made, and finds out why the board
    /// has started: `astray` if it has done so without a reset.
    pub fn take(timer: WDT, cpu: &CPU, astray: bool) -> Watchdog {
        let record = cpu.mcusr().read();
        // The watchdog cannot be stopped while the record says that it was the cause.
        cpu.mcusr().reset();
        let doing = DOING.get();
        let overdue = doing == SCANNING && AGE.get() >= OVERDUE;
        let watchdog = Watchdog { timer };
        watchdog.stop();
        GUARD.set(WHOLE);

        let commanded = doing == COMMANDED;
        if record.porf().bit_is_set() || doing != STARTING && doing != SCANNING && !commanded {
            RESTARTS.set(0);
            FAULTS.set(0);
            allowance::renew();
            return watchdog;
        }
        RESTARTS.set(watchdog.restarts().saturating_add(1));
        STARTED.set(if astray {
            Start::Astray
        } else if commanded {
            Start::Command
        } else if record.wdrf().bit_is_set() || overdue {
            Start::Watchdog
        } else {
            Start::Reset
        });
        watchdog
    }

    /// Restarts since power-up.
    #[inline(never)]
    pub fn restarts(&self) -> u16 {
        RESTARTS.get()
    }

    /// Faults since power-up.
    #[inline(never)]
    pub fn faults(&self) -> u16 {
        FAULTS.get()
    }

    /// A fault stops the board.
    pub fn count_fault(&self) {
        FAULTS.set(self.faults().saturating_add(1));
    }

    /// Starts the watchdog: from now a scan that takes 120 ms resets the chip.
    pub fn start(&self) {
        feed();
        DOING.set(SCANNING);
        self.set(|w| w.wde().set_bit().wdpl().cycles_16k());
    }

    /// Stops it: no scan is made, so none can be overdue.
    pub fn stop(&self) {
        DOING.set(STARTING);
        self.set(|w| w);
    }

    /// Resets the chip, after 16 ms or thereabouts.
    #[allow(clippy::empty_loop, reason = "the watchdog ends it")]
    pub fn restart(&self) -> ! {
        DOING.set(COMMANDED);
        self.set(|w| w.wde().set_bit());
        loop {}
    }

    fn set(&self, value: impl Fn(&mut W) -> &mut W) {
        // A change must follow within four cycles of its announcement.
        interrupt::free(|_| {
            avr_device::asm::wdr();
            self.timer
                .wdtcsr()
                .write(|w| w.wdce().set_bit().wde().set_bit());
            self.timer.wdtcsr().write(|w| value(w));
        });
    }
}

/// Whether a millisecond has begun since the watchdog was fed.
pub fn is_hungry() -> bool {
    AGE.get() != 0
}

/// The watchdog waits again, and the age of the scan is 0.
#[inline(always)]
pub fn feed() {
    AGE.set(0);
    avr_device::asm::wdr();
}

/// What is done now counts as overdue: the next start is the watchdog's fault.
pub fn scan_is_overdue() {
    AGE.set(u8::MAX);
}

/// Whether the stack has kept to its place.
pub fn guard_is_whole() -> bool {
    GUARD.get() == WHOLE
}
