//! Timers: TON, TOF, TP, and the retentive TON (NC-9, NC-14).

use crate::isa::{Opcode, TIMER_DATA};

/// A time in ms, or a reading of the millisecond clock; the clock wraps after 49.7 days.
pub type Millis = u32;

/// The operands of a timer block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TimerBlock {
    /// The preset in ms, 0 to 2147483647.
    pub preset: Millis,
    /// What follows Q.
    pub target: Target,
}

impl TimerBlock {
    /// Whether it is a timer of its own, which has a number.
    pub const fn is_own(self) -> bool {
        !matches!(self.target, Target::Timer(_))
    }
}

/// What a timer drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// The output with this number, from 1.
    Output(u8),
    /// The marker with this number, from 1.
    Marker(u8),
    /// Nothing: the block is no timer of its own, but calls the one with this number again (NC-30).
    Timer(u8),
}

/// Which way a timer delays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delay {
    /// TON: Q follows IN's rise after the preset, IN's fall at once.
    On,
    /// TOF: Q follows IN's fall after the preset, IN's rise at once.
    Off,
    /// TP: a rise of IN gives a pulse as long as the preset; IN matters no more until it is over.
    Pulse,
    /// TOR: Q = 1 once IN has been 1 for the preset in all; only a reset ends that.
    Retentive,
}

impl Delay {
    /// Every delay.
    pub const ALL: [Delay; 4] = [Delay::On, Delay::Off, Delay::Pulse, Delay::Retentive];

    /// The opcode of its timer.
    pub const fn opcode(self) -> Opcode {
        match self {
            Delay::On => Opcode::OnDelay,
            Delay::Off => Opcode::OffDelay,
            Delay::Pulse => Opcode::Pulse,
            Delay::Retentive => Opcode::RetentiveOnDelay,
        }
    }

    /// The delay of a timer's opcode; none for what is no timer.
    pub fn of(opcode: Opcode) -> Option<Delay> {
        Delay::ALL
            .into_iter()
            .find(|delay| delay.opcode() == opcode)
    }

    /// The letters of its code.
    pub const fn letters(self) -> &'static str {
        self.opcode().row().letters
    }
}

/// Where a timer stands. `Idle` is 0, so that cleared memory is a timer that was never started.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Phase {
    /// TON: IN = 0. TOF: IN = 0, and the delay is over or never began. TP: IN = 0, and no pulse. TOR: IN = 0
    /// or never 1; `since` is the time that has been gathered.
    Idle = 0,
    /// The delay or pulse runs since `since`.
    Timing = 1,
    /// TON, TOR: the delay is over. TOF: IN = 1. TP: the pulse is over, and IN still 1.
    Done = 2,
}

/// The data of one timer.
#[derive(Clone, Copy)]
pub(crate) struct Timer {
    phase: Phase,
    q: bool,
    /// Time stamp of the scan that began the delay.
    since: Millis,
    preset: Millis,
}

impl Timer {
    /// A timer that was never started.
    pub(crate) fn new(preset: Millis) -> Timer {
        Timer {
            phase: Phase::Idle,
            q: false,
            since: 0,
            preset,
        }
    }

    /// A timer of which this is seen from outside, `on` being the state of what it drives. Where that leaves
    /// two phases open, the next scan of the timer finds the right one by its input.
    pub(crate) fn seen(
        delay: Delay,
        elapsed: Millis,
        preset: Millis,
        on: bool,
        now: Millis,
    ) -> Timer {
        let over = elapsed != 0 && elapsed >= preset;
        let (phase, since) = match delay {
            Delay::Retentive if over => (Phase::Done, 0),
            Delay::Retentive => (Phase::Idle, elapsed),
            _ if elapsed == 0 => (Phase::Idle, 0),
            _ => (Phase::Timing, now.wrapping_sub(elapsed)),
        };
        let q = match delay {
            Delay::On | Delay::Retentive => over,
            Delay::Off => elapsed != 0 || on,
            Delay::Pulse => elapsed != 0 && !over,
        };
        Timer {
            phase,
            q,
            since,
            preset,
        }
    }

    /// The timer that these bytes of run memory hold.
    pub(crate) fn load([state, bytes @ ..]: [u8; TIMER_DATA]) -> Timer {
        let [a, b, c, d, e, f, g, h] = bytes;
        Timer {
            phase: match state & 3 {
                0 => Phase::Idle,
                1 => Phase::Timing,
                _ => Phase::Done,
            },
            q: state & Q != 0,
            since: Millis::from_le_bytes([a, b, c, d]),
            preset: Millis::from_le_bytes([e, f, g, h]),
        }
    }

    /// The bytes that hold this timer.
    pub(crate) fn store(self) -> [u8; TIMER_DATA] {
        let [a, b, c, d] = self.since.to_le_bytes();
        let [e, f, g, h] = self.preset.to_le_bytes();
        let q = if self.q { Q } else { 0 };
        [self.phase as u8 | q, a, b, c, d, e, f, g, h]
    }

    /// One scan of the timer; gives Q.
    pub(crate) fn scan(&mut self, delay: Delay, input: bool, now: Millis) -> bool {
        match delay {
            Delay::On => self.delay(input, true, now),
            Delay::Off => self.delay(input, false, now),
            Delay::Pulse => self.pulse(input, now),
            Delay::Retentive => self.gather(input, now),
        }
        self.q = match delay {
            Delay::On | Delay::Retentive => self.phase == Phase::Done,
            Delay::Off => self.phase != Phase::Idle,
            Delay::Pulse => self.phase == Phase::Timing,
        };
        self.q
    }

    /// TON waits at IN = 1, TOF at IN = 0; each begins in the phase that the other ends in.
    fn delay(&mut self, input: bool, waits_at: bool, now: Millis) {
        let (before, after) = if waits_at {
            (Phase::Idle, Phase::Done)
        } else {
            (Phase::Done, Phase::Idle)
        };
        if input != waits_at {
            self.phase = before;
            return;
        }
        if self.phase == before {
            self.phase = Phase::Timing;
            self.since = now;
        }
        self.end_when_over(after, now);
    }

    fn pulse(&mut self, input: bool, now: Millis) {
        match self.phase {
            Phase::Idle if input => {
                self.phase = Phase::Timing;
                self.since = now;
            }
            Phase::Done if !input => self.phase = Phase::Idle,
            _ => {}
        }
        self.end_when_over(if input { Phase::Done } else { Phase::Idle }, now);
    }

    fn gather(&mut self, input: bool, now: Millis) {
        match (self.phase, input) {
            // From now on `since` is a time stamp, from then on the time that has been gathered.
            (Phase::Idle, true) => {
                self.phase = Phase::Timing;
                self.since = now.wrapping_sub(self.since);
            }
            (Phase::Timing, false) => {
                self.phase = Phase::Idle;
                self.since = now.wrapping_sub(self.since);
            }
            _ => {}
        }
        self.end_when_over(Phase::Done, now);
    }

    fn end_when_over(&mut self, after: Phase, now: Millis) {
        if self.phase == Phase::Timing && self.running_for(now) >= self.preset {
            // Latched: what comes after a wrap of the counter no longer matters.
            self.phase = after;
        }
    }

    /// Q as the last scan of the timer left it.
    pub(crate) fn q(&self) -> bool {
        self.q
    }

    /// The preset in ms.
    pub(crate) fn preset(&self) -> Millis {
        self.preset
    }

    /// The preset from now on.
    pub(crate) fn set_preset(&mut self, preset: Millis) {
        self.preset = preset;
    }

    /// As if it had never been started.
    pub(crate) fn reset(&mut self) {
        *self = Timer::new(self.preset);
    }

    /// Elapsed time in ms, at most the preset. 0 while nothing runs, except that what is done stands at
    /// its preset, and a TOR at what it has gathered.
    pub(crate) fn elapsed(&self, delay: Delay, now: Millis) -> Millis {
        match (self.phase, delay) {
            (Phase::Timing, _) => self.running_for(now).min(self.preset),
            (Phase::Done, Delay::Off) => 0,
            (Phase::Done, _) => self.preset,
            (Phase::Idle, Delay::Retentive) => self.since.min(self.preset),
            (Phase::Idle, _) => 0,
        }
    }

    /// Right across the wrap of the counter, because presets stay below half its range.
    fn running_for(&self, now: Millis) -> Millis {
        now.wrapping_sub(self.since)
    }
}

/// The bit of a timer's first byte that keeps Q.
const Q: u8 = 0x80;
