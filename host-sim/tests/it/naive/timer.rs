//! Timers as NC-9 and NC-14 tell them. Time never wraps here.

/// A timer block, and what it remembers.
pub struct Timer {
    pub kind: String,
    pub preset: i64,
    pub q: bool,
    /// What began to run, and when.
    since: Option<i64>,
    /// TP: the pulse is over, and IN has not been 0 since.
    spent: bool,
    /// TOR: what was gathered before.
    gathered: i64,
}

impl Timer {
    pub fn new(kind: &str, preset: i64) -> Timer {
        Timer {
            kind: kind.to_owned(),
            preset,
            q: false,
            since: None,
            spent: false,
            gathered: 0,
        }
    }

    pub fn reset(&mut self) {
        *self = Timer::new(&self.kind, self.preset);
    }

    pub fn reach(&mut self, input: bool, now: i64) -> bool {
        match self.kind.as_str() {
            "TON" if input => self.q |= now - *self.since.get_or_insert(now) >= self.preset,
            "TON" => self.reset(),
            "TOF" if input => (self.q, self.since) = (true, None),
            "TOF" if self.q && now - *self.since.get_or_insert(now) >= self.preset => self.reset(),
            "TOF" => {}
            "TP" => {
                self.spent &= input;
                if input && !self.spent {
                    self.since.get_or_insert(now);
                }
                self.q = self.since.is_some_and(|since| now - since < self.preset);
                if self.since.is_some() && !self.q {
                    (self.since, self.spent) = (None, input);
                }
            }
            // TOR
            _ if self.q => {}
            _ if input => {
                let since = *self.since.get_or_insert(now);
                self.q = self.gathered + now - since >= self.preset;
            }
            _ => {
                self.gathered += self.since.map_or(0, |since| now - since);
                self.since = None;
            }
        }
        self.q
    }

    pub fn elapsed(&self, now: i64) -> i64 {
        let runs = self.since.map_or(0, |since| now - since);
        match self.kind.as_str() {
            "TON" | "TOR" if self.q => self.preset,
            "TP" if self.spent => self.preset,
            _ => (self.gathered + runs).min(self.preset),
        }
    }
}
