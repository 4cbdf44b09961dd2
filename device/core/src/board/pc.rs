//! A PC, for programs that no board holds.

use super::{Board, Engine};
use crate::Image;

/// What two digits name of a kind of points.
const POINTS: u8 = 99;

impl Board {
    /// The core on a PC: as many points as codes of two digits name, each on a pin of its own, and 32 KB of program. No
    /// firmware has this.
    pub const PC: Board = Board {
        name: "PC",
        inputs: POINTS,
        outputs: POINTS,
        analogue: POINTS,
        shared_from: 0,
        pwm: Image((1 << POINTS) - 1),
        markers: POINTS,
        counters: POINTS,
        labels: POINTS,
        timers: POINTS,
        stored_bytes: 32 * 1024,
        linked_bytes: 32 * 1024,
        real: true,
        engine: &Engine::CORE,
    };
}
