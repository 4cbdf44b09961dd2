//! A thread that writes samples, and what waits where the file takes nothing.

use crate::sample::Sample;
use crate::store::{Failure, Store};
use std::collections::VecDeque;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, SyncSender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Samples that wait for the file; of more, the oldest go.
const WAITING: usize = 200_000;
/// Batches that wait for the thread.
const BATCHES: usize = 4_096;
/// How long what has come waits for more, to be written together; and how often a file that takes nothing is tried again.
const TOGETHER: Duration = Duration::from_secs(1);
/// Samples that are written together at most.
const AT_ONCE: usize = 10_000;
/// How often what is old is thinned.
const THINNED: Duration = Duration::from_secs(60);

/// How it stands with the history.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct State {
    /// Samples written.
    pub written: u64,
    /// Samples that were given up, since the file took nothing for too long.
    pub dropped: u64,
    /// Samples that wait.
    pub waiting: usize,
    /// Why the file takes nothing at present.
    pub failure: Option<String>,
}

/// The way to the thread. It ends, with all written that can be, when the last of these is dropped.
#[derive(Debug)]
pub struct Keeper {
    samples: Option<SyncSender<Vec<Sample>>>,
    state: Arc<Mutex<State>>,
    thread: Option<JoinHandle<()>>,
}

impl Keeper {
    /// Begins to write into this file, and to thin what is older than `keep`. `tell` hears when the file takes nothing, and
    /// when it does again.
    pub fn begin(
        store: Store,
        keep: Duration,
        tell: impl Fn(Option<&Failure>) + Send + 'static,
    ) -> Keeper {
        let (samples, came) = mpsc::sync_channel(BATCHES);
        let state = Arc::new(Mutex::new(State::default()));
        let writer = Writer {
            store,
            keep: i64::try_from(keep.as_millis()).unwrap_or(i64::MAX / 8),
            waiting: VecDeque::new(),
            state: state.clone(),
            tell: Box::new(tell),
        };
        let thread = thread::spawn(move || writer.run(&came));
        Keeper {
            samples: Some(samples),
            state,
            thread: Some(thread),
        }
    }

    /// These are to be written. Where too many wait for the thread they are given up, and counted.
    pub fn keep(&self, samples: Vec<Sample>) {
        let count = samples.len() as u64;
        let taken = self.samples.as_ref().map(|to| to.try_send(samples));
        if !matches!(taken, Some(Ok(()))) {
            lock(&self.state).dropped += count;
        }
    }

    /// How it stands.
    pub fn state(&self) -> State {
        lock(&self.state).clone()
    }
}

impl Drop for Keeper {
    fn drop(&mut self) {
        self.samples = None;
        if let Some(thread) = self.thread.take() {
            // One that has failed has said so.
            let _ = thread.join();
        }
    }
}

/// Hears when the file takes nothing, and why; and when it does again.
type Tell = Box<dyn Fn(Option<&Failure>) + Send>;

struct Writer {
    store: Store,
    keep: i64,
    waiting: VecDeque<Sample>,
    state: Arc<Mutex<State>>,
    tell: Tell,
}

impl Writer {
    fn run(mut self, came: &Receiver<Vec<Sample>>) {
        let mut thin = Instant::now();
        while self.gather(came) {
            self.write();
            if thin <= Instant::now() {
                let more = self.store.thin(now(), self.keep).unwrap_or(false);
                thin = Instant::now() + if more { TOGETHER } else { THINNED };
            }
        }
        self.write();
    }

    /// Takes what comes until it is time to write; false at the end.
    fn gather(&mut self, came: &Receiver<Vec<Sample>>) -> bool {
        let until = Instant::now() + TOGETHER;
        loop {
            match came.recv_timeout(until.saturating_duration_since(Instant::now())) {
                Ok(samples) => self.wait(samples),
                Err(RecvTimeoutError::Timeout) => return true,
                Err(RecvTimeoutError::Disconnected) => return false,
            }
            if self.waiting.len() >= AT_ONCE {
                return true;
            }
        }
    }

    fn wait(&mut self, samples: Vec<Sample>) {
        self.waiting.extend(samples);
        let over = self.waiting.len().saturating_sub(WAITING);
        self.waiting.drain(..over);
        let mut state = lock(&self.state);
        state.dropped += over as u64;
        state.waiting = self.waiting.len();
    }

    fn write(&mut self) {
        while !self.waiting.is_empty() {
            let count = self.waiting.len().min(AT_ONCE);
            let batch = &self.waiting.make_contiguous()[..count];
            let written = self.store.append(batch);
            let mut state = lock(&self.state);
            let failed = state.failure.is_some();
            match written {
                Ok(()) => {
                    self.waiting.drain(..count);
                    state.written += count as u64;
                    state.failure = None;
                    state.waiting = self.waiting.len();
                    if failed {
                        (self.tell)(None);
                    }
                }
                Err(why) => {
                    state.failure = Some(format!("{why:?}"));
                    if !failed {
                        (self.tell)(Some(&why));
                    }
                    return;
                }
            }
        }
    }
}

/// ms since 1970, by the clock of the PC.
fn now() -> i64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.map_or(0, |since| {
        i64::try_from(since.as_millis()).unwrap_or(i64::MAX)
    })
}

fn lock(state: &Mutex<State>) -> std::sync::MutexGuard<'_, State> {
    state.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::query::Query;
    use rusqlite::Connection;

    fn sample(number: u32) -> Sample {
        Sample {
            board: "b".into(),
            point: "count".into(),
            at: number.into(),
            value: Some(number.into()),
        }
    }

    fn numbers(path: &std::path::Path) -> Vec<u32> {
        let query = Query {
            board: "b".into(),
            point: "count".into(),
            from: 0,
            to: i64::MAX,
            step: 0,
            most: usize::MAX,
        };
        let rows = Store::read(path).unwrap().rows(&query).unwrap();
        rows.iter().map(|row| row.last.unwrap() as u32).collect()
    }

    #[test]
    fn what_the_file_does_not_take_waits_and_is_written_in_order_once() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("h.db");
        let store = Store::open(&path).unwrap();
        store.file.busy_timeout(Duration::ZERO).unwrap();
        let (tell, told) = mpsc::channel();
        // It is thinned in another test.
        let keeper = Keeper::begin(store, Duration::from_secs(1 << 40), move |failure| {
            // After the end of the test nobody listens.
            let _ = tell.send(failure.map(|why| format!("{why:?}")));
        });
        let other = Connection::open(&path).unwrap();
        other.execute_batch("BEGIN IMMEDIATE").unwrap();
        for number in 0..100 {
            keeper.keep(vec![sample(number)]);
        }
        let failure = told.recv().unwrap();
        assert!(failure.is_some_and(|why| why.contains("locked")));
        assert_eq!(keeper.state().written, 0);
        keeper.keep((100..200).map(sample).collect());
        other.execute_batch("ROLLBACK").unwrap();
        assert_eq!(told.recv().unwrap(), None);
        keeper.keep((200..300).map(sample).collect());
        drop(keeper);
        assert_eq!(numbers(&path), (0..300).collect::<Vec<_>>());
    }

    #[test]
    fn what_waits_is_bounded_and_the_oldest_goes() {
        let folder = tempfile::tempdir().unwrap();
        let state = Arc::new(Mutex::new(State::default()));
        let mut writer = Writer {
            store: Store::open(&folder.path().join("h.db")).unwrap(),
            keep: 1,
            waiting: VecDeque::new(),
            state: state.clone(),
            tell: Box::new(|_| ()),
        };
        writer.wait((0..WAITING as u32).map(sample).collect());
        writer.wait((0..7).map(sample).collect());
        assert_eq!(writer.waiting.len(), WAITING);
        assert_eq!(writer.waiting.front().unwrap().at, 7);
        assert_eq!(lock(&state).dropped, 7);
    }
}
