//! Holding simulated time back to real time.

use crate::CYCLES_PER_MS;
use std::time::{Duration, Instant};

/// When simulated time is held back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pace {
    /// While nothing is on the serial line, so that what is sent is answered as fast as the simulation goes.
    #[default]
    Quiet,
    /// Always.
    RealTime,
}

/// Real time that is given up where the simulation is late by more than this.
const LATE: Duration = Duration::from_millis(50);

/// Compares the two clocks, from a moment at which they were the same.
pub(super) struct Pacer {
    real: Instant,
    cycles: u64,
}

impl Pacer {
    pub fn new(now: Instant, cycles: u64) -> Pacer {
        Pacer { real: now, cycles }
    }

    /// How long to wait until real time comes to `cycles`.
    pub fn wait(&mut self, now: Instant, cycles: u64) -> Duration {
        let simulated = cycles.saturating_sub(self.cycles);
        let due = self.real + Duration::from_nanos(simulated * 1_000_000 / CYCLES_PER_MS);
        if now > due + LATE {
            *self = Pacer::new(now, cycles);
        }
        due.saturating_duration_since(now)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simulated_time_waits_for_real_time_and_gives_up_what_is_late() {
        let start = Instant::now();
        let ms = Duration::from_millis;
        let mut pacer = Pacer::new(start, 1_000);
        let cycles = |ms: u64| 1_000 + ms * CYCLES_PER_MS;
        assert_eq!(pacer.wait(start, cycles(10)), ms(10));
        assert_eq!(pacer.wait(start + ms(4), cycles(10)), ms(6));
        // Late by less than 50 ms: that is caught up.
        assert_eq!(pacer.wait(start + ms(60), cycles(20)), ms(0));
        assert_eq!(pacer.wait(start + ms(60), cycles(70)), ms(10));
        // By more: from there on they are the same.
        assert_eq!(pacer.wait(start + ms(200), cycles(100)), ms(0));
        assert_eq!(pacer.wait(start + ms(200), cycles(101)), ms(1));
        // A day is no trouble.
        assert_eq!(
            pacer.wait(start + ms(200), cycles(86_400_100)),
            ms(86_400_000)
        );
    }
}
