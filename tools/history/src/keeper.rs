//! A thread that takes from the journal what the history does not have yet.

use crate::store::Store;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};
use unoclp_journal::{Entry, Failure, Reader, now};

/// Entries that are taken together at most.
const AT_ONCE: usize = 10_000;
/// From one taking to the next at least: what comes meanwhile is taken together.
const TOGETHER: Duration = Duration::from_millis(200);
/// A history that takes nothing is tried again after this, then after twice as long, and so on, up to
const SOON: Duration = Duration::from_millis(500);
/// this.
const LATE: Duration = Duration::from_secs(30);
/// How often what is old is thinned, and how soon again where there was more.
const THINNED: Duration = Duration::from_secs(60);
const MORE: Duration = Duration::from_secs(1);

/// How it stands with the history.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct State {
    /// Entries taken since the beginning.
    pub taken: u64,
    /// Why it takes nothing at present.
    pub failure: Option<Failure>,
}

/// How a history is opened.
pub type Open = Box<dyn Fn() -> Result<Box<dyn Store>, Failure> + Send>;
/// Hears when the history takes nothing, and why; and when it does again.
pub type Tell = Box<dyn Fn(Option<&Failure>) + Send>;

/// The way to the thread. It ends once its journal has ended and all is taken that can be.
#[derive(Debug)]
pub struct Keeper {
    state: Arc<Mutex<State>>,
    thread: Mutex<Option<JoinHandle<()>>>,
}

impl Keeper {
    /// Begins to take what this reader has, and to thin what is older than `keep`. The history is this one, or else is opened
    /// as soon as it can be.
    ///
    /// # Errors
    /// Where the system refuses a thread.
    pub fn begin(
        store: Option<Box<dyn Store>>,
        open: Open,
        reader: Reader,
        keep: Duration,
        tell: Tell,
    ) -> std::io::Result<Keeper> {
        let state = Arc::new(Mutex::new(State::default()));
        let mut taker = Taker {
            store,
            open,
            at: None,
            reader,
            keep: i64::try_from(keep.as_millis()).unwrap_or(i64::MAX),
            thin: Instant::now(),
            state: state.clone(),
            tell,
        };
        let thread = thread::Builder::new().name("history".to_owned());
        let thread = thread.spawn(move || taker.run())?;
        Ok(Keeper {
            state,
            thread: Mutex::new(Some(thread)),
        })
    }

    /// How it stands.
    pub fn state(&self) -> State {
        lock(&self.state).clone()
    }

    /// Waits for the end, which comes after that of the journal.
    pub fn end(&self) {
        if let Some(thread) = lock(&self.thread).take() {
            // One that has failed has said so.
            let _ = thread.join();
        }
    }
}

struct Taker {
    store: Option<Box<dyn Store>>,
    open: Open,
    /// The number of the last entry that the history has; none as long as it was not asked.
    at: Option<u64>,
    reader: Reader,
    keep: i64,
    /// When what is old is thinned next.
    thin: Instant,
    state: Arc<Mutex<State>>,
    tell: Tell,
}

impl Taker {
    fn run(&mut self) {
        let mut wait = SOON;
        loop {
            let is_over = self.reader.is_over();
            let done = self.round();
            match done {
                Ok(more) => {
                    wait = SOON;
                    if is_over && !more {
                        return;
                    }
                }
                Err(why) => {
                    self.failed(why);
                    if is_over {
                        return;
                    }
                    // A new connection knows what the last one has taken.
                    (self.store, self.at) = (None, None);
                    self.reader.pause(wait);
                    wait = (wait * 2).min(LATE);
                }
            }
        }
    }

    /// Takes what there is, and thins; says whether there is more at once.
    fn round(&mut self) -> Result<bool, Failure> {
        let store = match &mut self.store {
            Some(store) => store,
            none => none.insert((self.open)()?),
        };
        let at = match self.at {
            Some(at) => at,
            None => begin(&mut **store, &self.reader)?,
        };
        self.at = Some(at);
        let more = match self.reader.wait(at, MORE) {
            false => false,
            true => {
                let entries = self.reader.read(at, AT_ONCE)?;
                store.take(self.reader.source(), &entries)?;
                self.took(at, &entries);
                entries.len() == AT_ONCE
            }
        };
        lock(&self.state)
            .failure
            .take()
            .inspect(|_| (self.tell)(None));
        if self.thin <= Instant::now()
            && let Some(store) = &mut self.store
        {
            let is_more = store.thin(now(), self.keep)?;
            self.thin = Instant::now() + if is_more { MORE } else { THINNED };
        }
        if !more {
            self.reader.pause(TOGETHER);
        }
        Ok(more)
    }

    fn took(&mut self, at: u64, entries: &[Entry]) {
        // Where those that were there are gone, the bound has dropped them.
        let last = entries
            .last()
            .map_or(self.reader.last(), |last| last.number);
        self.at = Some(last.max(at));
        self.reader.take(last);
        lock(&self.state).taken += entries.len() as u64;
    }

    fn failed(&self, why: Failure) {
        let before = lock(&self.state).failure.replace(why.clone());
        if before.is_none() {
            (self.tell)(Some(&why));
        }
    }
}

/// The number of the last entry that the history has. A journal that is older than that goes on after it.
fn begin(store: &mut dyn Store, reader: &Reader) -> Result<u64, Failure> {
    let taken = store.taken(reader.source())?.unwrap_or(0);
    if taken > reader.last() {
        reader.skip_to(taken)?;
    }
    reader.take(taken);
    Ok(taken)
}

fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}
