//! LED L while a fault lasts: its number, tens as long flashes, units as short ones.

use crate::board::clock;
use crate::board::pins::Pins;
use unoclp_core::{Cause, Millis};

const LONG: Millis = 800;
const SHORT: Millis = 200;
/// Dark between two flashes.
const GAP: Millis = 300;
/// Dark between tens and units.
const BETWEEN: Millis = 700;
/// Dark before the number comes again.
const PAUSE: Millis = 2000;

/// The flash of STOP, one a second.
const STOP_FLASH: Millis = 100;
const STOP_DARK: Millis = 900;

/// Shows STOP as long as it lasts, and calls `meanwhile` all the time.
pub fn show_stop(pins: &Pins, mut meanwhile: impl FnMut()) {
    let (mut on, mut since) = (true, clock::now());
    pins.led(on);
    while pins.stop() {
        meanwhile();
        if clock::now().wrapping_sub(since) >= if on { STOP_FLASH } else { STOP_DARK } {
            since = clock::now();
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

fn flash(pins: &Pins, times: u8, on: Millis) {
    for _ in 0..times {
        pins.led(true);
        wait(on);
        pins.led(false);
        wait(GAP);
    }
}

fn wait(time: Millis) {
    let since = clock::now();
    while clock::now().wrapping_sub(since) < time {}
}
