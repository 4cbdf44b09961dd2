//! The thread that commits.

use crate::entry::Sample;
use crate::file::File;
use crate::shared::{Policy, Shared, Tell, lock, places};
use std::collections::VecDeque;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Samples that wait in memory for a file that takes nothing; of more, the oldest go.
const WAITING: usize = 200_000;
/// Samples of one commit at most.
const AT_ONCE: usize = 10_000;
/// How often a file that takes nothing is tried again, and what readers have taken is noted.
const AGAIN: Duration = Duration::from_secs(1);

pub(crate) struct Writer {
    file: Arc<Mutex<File>>,
    policy: Policy,
    shared: Arc<Shared>,
    tell: Tell,
    waiting: VecDeque<Sample>,
    /// What the readers have taken, as it was last noted.
    noted: Vec<(String, u64)>,
}

impl Writer {
    pub fn new(file: Arc<Mutex<File>>, policy: Policy, shared: Arc<Shared>, tell: Tell) -> Writer {
        Writer {
            file,
            policy,
            shared,
            tell,
            waiting: VecDeque::new(),
            noted: Vec::new(),
        }
    }

    pub fn run(mut self, came: &Receiver<Vec<Sample>>) {
        let mut next = Instant::now();
        while self.gather(came, next) {
            self.write();
            let failing = lock(&self.shared.state).failure.is_some();
            next = Instant::now() + if failing { AGAIN } else { self.policy.every };
        }
        self.write();
    }

    /// Takes what comes until something has come and this moment is over; false at the end. Without anything it goes on after
    /// a while, to note what readers have taken.
    fn gather(&mut self, came: &Receiver<Vec<Sample>>, next: Instant) -> bool {
        let idle = Instant::now() + AGAIN;
        loop {
            let until = if self.waiting.is_empty() { idle } else { next };
            match came.recv_timeout(until.saturating_duration_since(Instant::now())) {
                Ok(samples) => self.wait(samples),
                Err(RecvTimeoutError::Timeout) => return true,
                Err(RecvTimeoutError::Disconnected) => return false,
            }
            if self.waiting.len() >= AT_ONCE && lock(&self.shared.state).failure.is_none() {
                return true;
            }
        }
    }

    fn wait(&mut self, samples: Vec<Sample>) {
        self.waiting.extend(samples);
        let over = self.waiting.len().saturating_sub(WAITING);
        self.waiting.drain(..over);
        let mut state = lock(&self.shared.state);
        state.dropped += over as u64;
        state.waiting = self.waiting.len();
    }

    fn write(&mut self) {
        loop {
            let places = places(&self.shared);
            if self.waiting.is_empty() && places == self.noted {
                return;
            }
            let count = self.waiting.len().min(AT_ONCE);
            let batch = &self.waiting.make_contiguous()[..count];
            let mut file = lock(&self.file);
            let committed = file.commit(batch, &places, self.policy.bound);
            let (last, used) = (file.last(), file.used().unwrap_or(0));
            drop(file);
            match committed {
                Ok(()) => {
                    self.waiting.drain(..count);
                    self.noted = places;
                    self.committed(count, used);
                    if count > 0 {
                        self.announce(last);
                    }
                }
                Err(why) => {
                    let before = lock(&self.shared.state).failure.replace(why.clone());
                    if before.is_none() {
                        (self.tell)(Some(&why));
                    }
                    return;
                }
            }
        }
    }

    fn committed(&self, count: usize, used: u64) {
        let mut state = lock(&self.shared.state);
        state.committed += count as u64;
        state.waiting = self.waiting.len();
        state.used = used;
        let failed = state.failure.take().is_some();
        drop(state);
        if failed {
            (self.tell)(None);
        }
    }

    fn announce(&self, last: u64) {
        let mut now = lock(&self.shared.last);
        now.number = last.max(now.number);
        drop(now);
        self.shared.more.notify_all();
        for listener in &*lock(&self.shared.listeners) {
            listener();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::State;

    fn sample(number: usize) -> Sample {
        Sample {
            board: "b".into(),
            point: "p".into(),
            at: number as i64,
            value: None,
        }
    }

    #[test]
    fn what_waits_in_memory_is_bounded_and_the_oldest_goes() {
        let folder = tempfile::tempdir().unwrap();
        let file = File::open(&folder.path().join("j")).unwrap();
        let policy = Policy {
            every: Duration::ZERO,
            bound: u64::MAX,
        };
        let file = Arc::new(Mutex::new(file));
        let mut writer = Writer::new(file, policy, Arc::default(), Box::new(|_| ()));
        writer.wait((0..WAITING).map(sample).collect());
        writer.wait((0..7).map(sample).collect());
        assert_eq!(writer.waiting.len(), WAITING);
        assert_eq!(writer.waiting.front().unwrap().at, 7);
        let stands = State {
            waiting: WAITING,
            dropped: 7,
            ..State::default()
        };
        assert_eq!(*lock(&writer.shared.state), stands);
    }
}
