//! The clocks among the system markers (NC-12).

use crate::Millis;

/// The system markers S 02 and S 03, which change in step with the time stamps.
#[derive(Clone, Copy, Debug, Default)]
pub struct Clocks {
    /// Time stamp of the last change.
    since: Millis,
    /// 0–19: tenths of the 1 Hz clock's halves, halves of the 10 Hz clock's period.
    phase: u8,
}

impl Clocks {
    /// A tenth of half a period of S 02 and half a period of S 03, ms.
    const STEP: Millis = 50;
    /// So many steps are a period of S 02.
    const PERIOD: u8 = 20;

    /// Clocks that begin with the first scan.
    pub const fn new() -> Clocks {
        Clocks { since: 0, phase: 0 }
    }

    /// At the beginning of a scan. No scan makes more than one step, so after a long one the clocks are
    /// late, and go faster until they are right again.
    pub fn scan(&mut self, first: bool, now: Millis) {
        if first {
            self.since = now;
        } else if now.wrapping_sub(self.since) >= Clocks::STEP {
            self.since = self.since.wrapping_add(Clocks::STEP);
            self.phase += 1;
            if self.phase >= Clocks::PERIOD {
                self.phase = 0;
            }
        }
    }

    /// S 02: 1 Hz.
    pub const fn slow(&self) -> bool {
        self.phase >= Clocks::PERIOD / 2
    }

    /// S 03: 10 Hz.
    pub const fn fast(&self) -> bool {
        self.phase & 1 != 0
    }
}
