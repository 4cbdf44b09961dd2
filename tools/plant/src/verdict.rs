//! What came of a run: which rules broke, and which goals were met.

/// A rule that broke.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Broken {
    /// Its number among [`Plant::nevers`](crate::Plant::nevers).
    pub rule: usize,
    /// When, ms after the first step.
    pub at: u64,
}

/// A goal that was not met in its time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Missed {
    /// Its number among [`Plant::goals`](crate::Plant::goals).
    pub goal: usize,
    /// Since when it was due, ms after the first step.
    pub since: u64,
    /// When its time was over.
    pub at: u64,
}

/// What has come of a run so far.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Verdict {
    /// The rules that broke, each once, in the order of time.
    pub broken: Vec<Broken>,
    /// The goals whose time was over, each once.
    pub missed: Vec<Missed>,
    /// How often each goal was met.
    pub met: Vec<u32>,
}

impl Verdict {
    /// Whether no rule broke and no goal was missed.
    pub fn is_passed(&self) -> bool {
        self.broken.is_empty() && self.missed.is_empty()
    }

    /// When the first rule broke or the first goal was missed, ms after the first step.
    pub fn first(&self) -> Option<u64> {
        let broken = self.broken.iter().map(|broken| broken.at);
        broken
            .chain(self.missed.iter().map(|missed| missed.at))
            .min()
    }
}
