//! LED L: RUN, STOP, and the number of a fault, tens as long flashes, units as short ones.

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

/// The flash of STOP, and the dark moment of RUN with forces; one in each [`PERIOD`].
const MOMENT: u16 = 100;
/// A power of two, for the sake of the scan: a second, nearly.
const PERIOD: u16 = 1024;

/// RUN: steady, dark for a moment each second while something is forced.
#[inline(always)]
pub fn show_run(pins: &Pins, forced: bool) {
    pins.led(!(forced && in_moment(now())));
}

/// Shows STOP until `meanwhile` says that it is over.
pub fn show_stop(pins: &Pins, mut meanwhile: impl FnMut() -> bool) {
    let since = now();
    while !meanwhile() {
        pins.led(in_moment(now().wrapping_sub(since)));
    }
}

fn in_moment(time: u16) -> bool {
    time % PERIOD < MOMENT
}

/// Shows the number until `meanwhile` says that it is over.
pub fn show(pins: &Pins, cause: Cause, mut meanwhile: impl FnMut() -> bool) {
    let (mut tens, mut units) = (0, cause.number());
    while units >= 10 {
        units -= 10;
        tens += 1;
    }
    let (mut left, mut long, mut on) = (tens, true, false);
    let (mut since, mut time) = (now(), 0);
    while !meanwhile() {
        if now().wrapping_sub(since) < time {
            continue;
        }
        since = now();
        on = !on && left > 0;
        pins.led(on);
        time = if on {
            left -= 1;
            if long { LONG } else { SHORT }
        } else if left > 0 {
            GAP
        } else {
            long = !long;
            left = if long { tens } else { units };
            GAP + if long { PAUSE } else { BETWEEN }
        };
    }
}

/// ms, wrapping after a minute: the times above are shorter.
fn now() -> u16 {
    clock::now() as u16
}
