//! LED L while a fault lasts: its number, tens as long flashes, units as short ones.

use crate::board::clock;
use crate::board::pins::Pins;
use unoclp_core::Cause;

// All in ms.
const LONG: u16 = 800;
const SHORT: u16 = 200;
/// Dark between two flashes.
const GAP: u16 = 300;
/// Dark between tens and units.
const BETWEEN: u16 = 700;
/// Dark before the number comes again.
const PAUSE: u16 = 2000;

/// The flash of STOP, one a second.
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

fn flash(pins: &Pins, times: u8, on: u16) {
    for _ in 0..times {
        pins.led(true);
        wait(on);
        pins.led(false);
        wait(GAP);
    }
}

fn wait(time: u16) {
    let since = now();
    while now().wrapping_sub(since) < time {}
}

/// ms, wrapping after a minute: the times above are shorter.
fn now() -> u16 {
    clock::now() as u16
}
