//! A journal that is open: who puts samples, and who takes them.

use crate::entry::{Entry, Sample};
use crate::failure::Failure;
use crate::file::File;
use crate::shared::{Policy, Shared, State, Tell, lock, places};
use crate::writer::Writer;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

/// Batches that wait for the thread.
const BATCHES: usize = 4_096;

impl std::fmt::Debug for Journal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Journal")
    }
}

impl std::fmt::Debug for Reader {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Reader {}", self.name)
    }
}

/// The way in. With the last of it all is committed that can be.
pub struct Journal {
    samples: Mutex<Option<SyncSender<Vec<Sample>>>>,
    file: Arc<Mutex<File>>,
    shared: Arc<Shared>,
    thread: Mutex<Option<JoinHandle<()>>>,
}

/// One who takes entries.
#[derive(Clone)]
pub struct Reader {
    name: String,
    source: String,
    file: Arc<Mutex<File>>,
    shared: Arc<Shared>,
}

impl Journal {
    /// Begins to commit, for these readers. `tell` hears when the file takes nothing, and when it does again.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn begin(
        mut file: File,
        policy: Policy,
        readers: &[&str],
        tell: Tell,
    ) -> Result<Journal, Failure> {
        file.set_readers(readers)?;
        let shared = Arc::new(Shared::default());
        lock(&shared.last).number = file.last();
        let file = Arc::new(Mutex::new(file));
        let (samples, came) = sync_channel(BATCHES);
        let writer = Writer::new(file.clone(), policy, shared.clone(), tell);
        let thread = thread::Builder::new().name("journal".to_owned());
        let thread = thread
            .spawn(move || writer.run(&came))
            .map_err(|error| Failure::Other(error.to_string()))?;
        Ok(Journal {
            samples: Mutex::new(Some(samples)),
            file,
            shared,
            thread: Mutex::new(Some(thread)),
        })
    }

    /// These are to be committed. Where too many wait for the thread they are given up, and counted.
    pub fn put(&self, samples: Vec<Sample>) {
        let count = samples.len() as u64;
        let taken = lock(&self.samples).as_ref().map(|to| to.try_send(samples));
        if !matches!(taken, Some(Ok(()))) {
            lock(&self.shared.state).dropped += count;
        }
    }

    /// How it stands.
    pub fn state(&self) -> State {
        lock(&self.shared.state).clone()
    }

    /// The reader of this name.
    pub fn reader(&self, name: &str) -> Reader {
        Reader {
            name: name.to_owned(),
            source: lock(&self.file).source().to_owned(),
            file: self.file.clone(),
            shared: self.shared.clone(),
        }
    }

    /// Commits all that has come, and takes nothing more.
    pub fn end(&self) {
        *lock(&self.samples) = None;
        if let Some(thread) = lock(&self.thread).take() {
            // One that has failed has said so.
            let _ = thread.join();
        }
        lock(&self.shared.last).is_over = true;
        self.shared.more.notify_all();
    }
}

impl Drop for Journal {
    fn drop(&mut self) {
        self.end();
        // How far readers have come since.
        let places = places(&self.shared);
        let _ = lock(&self.file).commit(&[], &places, u64::MAX);
    }
}

impl Reader {
    /// What tells this journal from all others.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The entries after this number, at most so many.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(&self, after: u64, most: usize) -> Result<Vec<Entry>, Failure> {
        lock(&self.file).read(after, most)
    }

    /// Up to this number all is taken, and need not be kept for this reader.
    pub fn take(&self, number: u64) {
        let mut places = lock(&self.shared.places);
        let place = places.entry(self.name.clone()).or_default();
        *place = number.max(*place);
    }

    /// The number of the last entry that is taken.
    pub fn place(&self) -> u64 {
        let said = lock(&self.shared.places).get(&self.name).copied();
        let kept = lock(&self.file).place(&self.name).number;
        said.map_or(kept, |said| said.max(kept))
    }

    /// How many entries were dropped before this reader could take them, ever.
    pub fn dropped(&self) -> u64 {
        lock(&self.file).place(&self.name).dropped
    }

    /// The number of the last entry.
    pub fn last(&self) -> u64 {
        lock(&self.shared.last).number
    }

    /// Whether no entry follows the last one any more.
    pub fn is_over(&self) -> bool {
        lock(&self.shared.last).is_over
    }

    /// Numbers go on after this one, if they are not there yet.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn skip_to(&self, number: u64) -> Result<(), Failure> {
        let mut file = lock(&self.file);
        file.skip_to(number)?;
        lock(&self.shared.last).number = file.last();
        Ok(())
    }

    /// Waits for an entry after this number, at most so long, and not where none follows; whether there is one.
    pub fn wait(&self, after: u64, most: Duration) -> bool {
        let last = lock(&self.shared.last);
        let waited = self
            .shared
            .more
            .wait_timeout_while(last, most, |last| last.number <= after && !last.is_over);
        let (last, _) = waited.unwrap_or_else(PoisonError::into_inner);
        last.number > after
    }

    /// Waits so long, but not where no entry follows the last one.
    pub fn pause(&self, most: Duration) {
        let last = lock(&self.shared.last);
        let waited = self
            .shared
            .more
            .wait_timeout_while(last, most, |last| !last.is_over);
        drop(waited);
    }

    /// Tells this listener whenever there are more entries.
    pub fn listen(&self, listener: impl Fn() + Send + Sync + 'static) {
        lock(&self.shared.listeners).push(Box::new(listener));
    }
}
