//! TON and TOF (NC-9).

use crate::Point;
use crate::plc::Millis;

/// Bytes of a timer's data in run memory.
pub(crate) const DATA_BYTES: usize = 5;

/// The operands of a timer block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TimerBlock {
    /// The preset in ms, 0 to 2147483647.
    pub preset: Millis,
    /// The output that follows Q.
    pub output: Point,
}

/// Which way a timer delays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delay {
    /// TON: Q follows IN's rise after the preset, IN's fall at once.
    On,
    /// TOF: Q follows IN's fall after the preset, IN's rise at once.
    Off,
}

/// Where a timer stands. `Idle` is 0, so that cleared memory is a timer that was never started.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Phase {
    /// TON: IN = 0. TOF: IN = 0, and the delay is over or never began. Q = 0.
    Idle = 0,
    /// The delay runs since `since`. TON: Q = 0. TOF: Q = 1.
    Timing = 1,
    /// TON: the delay is over. TOF: IN = 1. Q = 1.
    On = 2,
}

/// The data of one timer.
#[derive(Clone, Copy)]
pub(crate) struct Timer {
    phase: Phase,
    /// Time stamp of the scan that began the delay.
    since: Millis,
}

impl Timer {
    /// The timer that these bytes of run memory hold.
    pub(crate) fn load([phase, since @ ..]: [u8; DATA_BYTES]) -> Timer {
        Timer {
            phase: match phase {
                0 => Phase::Idle,
                1 => Phase::Timing,
                _ => Phase::On,
            },
            since: Millis::from_le_bytes(since),
        }
    }

    /// The bytes that hold this timer.
    pub(crate) fn store(self) -> [u8; DATA_BYTES] {
        let [a, b, c, d] = self.since.to_le_bytes();
        [self.phase as u8, a, b, c, d]
    }

    /// One scan of the timer; gives Q.
    pub(crate) fn scan(&mut self, delay: Delay, input: bool, preset: Millis, now: Millis) -> bool {
        // The level that ends the delay at once, and the phase it leads to.
        let (at_rest, rest) = match delay {
            Delay::On => (!input, Phase::Idle),
            Delay::Off => (input, Phase::On),
        };
        let (before, after) = match delay {
            Delay::On => (Phase::Idle, Phase::On),
            Delay::Off => (Phase::On, Phase::Idle),
        };
        if at_rest {
            self.phase = rest;
        } else {
            if self.phase == before {
                self.phase = Phase::Timing;
                self.since = now;
            }
            if self.phase == Phase::Timing && self.running_for(now) >= preset {
                // Latched: what comes after a wrap of the counter no longer matters.
                self.phase = after;
            }
        }
        self.output(delay)
    }

    /// Q as it stands.
    pub(crate) fn output(&self, delay: Delay) -> bool {
        match delay {
            Delay::On => self.phase == Phase::On,
            Delay::Off => self.phase != Phase::Idle,
        }
    }

    /// Elapsed time of the delay in ms, at most the preset; 0 while no delay runs, except that a
    /// TON that is done stands at its preset.
    pub(crate) fn elapsed(&self, delay: Delay, preset: Millis, now: Millis) -> Millis {
        match (self.phase, delay) {
            (Phase::Timing, _) => self.running_for(now).min(preset),
            (Phase::On, Delay::On) => preset,
            _ => 0,
        }
    }

    /// Right across the wrap of the counter, because presets stay below half its range.
    fn running_for(&self, now: Millis) -> Millis {
        now.wrapping_sub(self.since)
    }
}
