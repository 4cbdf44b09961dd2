//! LED L while a fault lasts: its number, tens as long flashes, units as short ones.

use crate::board::clock::{self, Deadline};
use crate::board::pins::Pins;
use unoclp_core::Cause;

// All in tenths of a second.
const LONG: u8 = 8;
const SHORT: u8 = 2;
/// Dark between two flashes.
const GAP: u8 = 3;
/// Dark between tens and units.
const BETWEEN: u8 = 7;
/// Dark before the number comes again.
const PAUSE: u8 = 20;

/// The flash of STOP, one a second, ms.
const STOP_FLASH: u16 = 100;
const STOP_DARK: u16 = 900;

/// Shows STOP as long as it lasts, and calls `meanwhile` all the time.
pub fn show_stop(pins: &Pins, mut meanwhile: impl FnMut()) {
    let (mut on, mut since) = (true, now());
    pins.led(on);
    while pins.stop() {
        meanwhile();
        if now().wrapping_sub(since) >= if on { STOP_FLASH } else { STOP_DARK } {
            since = now();
            on = !on;
            pins.led(on);
        }
    }
}

/// Shows the number for ever.
pub fn show(pins: &Pins, cause: Cause) -> ! {
    loop {
        flash(pins, cause.number() / 10, LONG);
        wait(BETWEEN);
        flash(pins, cause.number() % 10, SHORT);
        wait(PAUSE);
    }
}

fn flash(pins: &Pins, times: u8, on: u8) {
    for _ in 0..times {
        pins.led(true);
        wait(on);
        pins.led(false);
        wait(GAP);
    }
}

#[inline(never)]
fn wait(tenths: u8) {
    for _ in 0..tenths {
        let end = Deadline::after(100);
        while !end.has_passed() {}
    }
}

/// ms, wrapping after a minute: the times above are shorter.
fn now() -> u16 {
    clock::now() as u16
}
