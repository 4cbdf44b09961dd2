//! A file that is open: who puts rows, and who asks for them.

use crate::files::Files;
use crate::row::{Asked, Deed, Happening, Row};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};
use unoclp_journal::Failure;

/// Rows that wait in memory while the file cannot be written; beyond that, the newest are dropped and counted.
const WAITING: usize = 10_000;
/// How often a file that cannot be written is tried again.
const AGAIN: Duration = Duration::from_secs(1);

/// Hears when and why the file cannot be written, and when it can be again.
pub type Tell = Box<dyn Fn(Option<&Failure>) + Send>;

/// The state of a file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct State {
    /// Rows that are written.
    pub written: u64,
    /// Rows that were dropped because the file could not be written for too long, or as the oldest.
    pub dropped: u64,
    /// How large the files are.
    pub bytes: u64,
    /// Why the file cannot be written at present.
    pub failure: Option<Failure>,
}

/// What the writer is given.
enum Put {
    Row(Row),
    /// Somebody waits until all rows before this one have been tried.
    Waits(SyncSender<()>),
}

/// A file that is open. With the last of it all is written that can be.
pub struct Record {
    path: PathBuf,
    puts: Mutex<Option<SyncSender<Put>>>,
    state: Arc<Mutex<State>>,
    thread: Mutex<Option<JoinHandle<()>>>,
}

impl std::fmt::Debug for Record {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Record {}", self.path.display())
    }
}

impl Record {
    /// Opens the record at this path, and creates it if it does not exist. It gets as large as `bound` bytes; then the oldest
    /// half goes. `tell` hears when it takes nothing.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn begin(path: &Path, bound: u64, tell: Tell) -> Result<Record, Failure> {
        let files = Files::open(path, bound)?;
        let (send, puts) = sync_channel(WAITING);
        let state = State {
            bytes: files.bytes(),
            ..State::default()
        };
        let state = Arc::new(Mutex::new(state));
        let writer = Writer {
            files,
            state: state.clone(),
            tell,
            waiting: Vec::new(),
        };
        let thread = thread::Builder::new().name("record".to_owned());
        let thread = thread.spawn(move || writer.run(&puts));
        let thread = thread.map_err(|why| Failure::Other(why.to_string()))?;
        Ok(Record {
            path: path.to_owned(),
            puts: Mutex::new(Some(send)),
            state,
            thread: Mutex::new(Some(thread)),
        })
    }

    /// An alarm has changed.
    pub fn alarm(&self, happening: Happening) {
        self.put(Row::Alarm(happening));
    }

    /// A user or client has acted.
    pub fn deed(&self, deed: Deed) {
        self.put(Row::Deed(deed));
    }

    /// Waits until the file has taken all that was put, or has refused it; a process that is killed after this has lost
    /// nothing that the file could take.
    pub fn settle(&self) {
        let (settled, wait) = sync_channel(1);
        if self.send(Put::Waits(settled)) {
            // A writer that has ended has written.
            let _ = wait.recv();
        }
    }

    fn put(&self, row: Row) {
        if !self.send(Put::Row(row)) {
            lock(&self.state).dropped += 1;
        }
    }

    fn send(&self, put: Put) -> bool {
        match &*lock(&self.puts) {
            Some(puts) => puts.try_send(put).is_ok(),
            None => false,
        }
    }

    /// The last change of each alarm.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn last(&self) -> Result<Vec<Happening>, Failure> {
        Files::read(&self.path)?.last()
    }

    /// Changes of alarms.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn alarms(&self, asked: &Asked) -> Result<Vec<Happening>, Failure> {
        Files::read(&self.path)?.alarms(asked)
    }

    /// Actions.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn deeds(&self, asked: &Asked) -> Result<Vec<Deed>, Failure> {
        Files::read(&self.path)?.deeds(asked)
    }

    /// Its state.
    pub fn state(&self) -> State {
        lock(&self.state).clone()
    }

    /// All that has come is written, where the file takes it.
    pub fn end(&self) {
        lock(&self.puts).take();
        if let Some(thread) = lock(&self.thread).take() {
            // One that has failed has said so.
            let _ = thread.join();
        }
    }
}

impl Drop for Record {
    fn drop(&mut self) {
        self.end();
    }
}

struct Writer {
    files: Files,
    state: Arc<Mutex<State>>,
    tell: Tell,
    waiting: Vec<Row>,
}

impl Writer {
    fn run(mut self, puts: &Receiver<Put>) {
        let mut next = Instant::now();
        let mut waits = Vec::new();
        loop {
            let first = match puts.recv_timeout(AGAIN) {
                Ok(put) => Some(put),
                Err(RecvTimeoutError::Timeout) => None,
                Err(RecvTimeoutError::Disconnected) => break,
            };
            for put in first.into_iter().chain(puts.try_iter()) {
                match put {
                    Put::Row(row) => self.take(row),
                    Put::Waits(settled) => waits.push(settled),
                }
            }
            if Instant::now() >= next && !self.write() {
                next = Instant::now() + AGAIN;
            }
            for settled in waits.drain(..) {
                // Who no longer waits need not hear it.
                let _ = settled.try_send(());
            }
        }
        self.write();
    }

    fn take(&mut self, row: Row) {
        match self.waiting.len() < WAITING {
            true => self.waiting.push(row),
            false => lock(&self.state).dropped += 1,
        }
    }

    /// Writes what waits; false where the file takes nothing.
    fn write(&mut self) -> bool {
        if self.waiting.is_empty() {
            return true;
        }
        let written = self.files.append(&self.waiting);
        let bytes = self.files.bytes();
        let mut state = lock(&self.state);
        let before = state.failure.take();
        match written {
            Ok(gone) => {
                state.written += self.waiting.len() as u64;
                state.dropped += gone;
                state.bytes = bytes;
                drop(state);
                self.waiting.clear();
                if before.is_some() {
                    (self.tell)(None);
                }
                true
            }
            Err(why) => {
                state.failure = Some(why.clone());
                drop(state);
                if before.is_none() {
                    (self.tell)(Some(&why));
                }
                false
            }
        }
    }
}

fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_settled_is_in_the_file_while_it_is_open() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("r");
        let record = Record::begin(&path, u64::MAX, Box::new(|_| ())).unwrap();
        for at in 0..20 {
            record.deed(Deed {
                at,
                who: "ana".into(),
                from: None,
                of: "hot".into(),
                what: "acknowledge".into(),
                detail: String::new(),
            });
            record.settle();
            // As a program sees it that starts after this one was killed.
            let asked = Asked {
                from: at,
                to: i64::MAX,
                most: 1,
            };
            assert_eq!(Files::read(&path).unwrap().deeds(&asked).unwrap().len(), 1);
        }
        record.end();
        record.settle();
    }
}
