//! What the thread and the readers of a journal share.

use crate::failure::Failure;
use std::collections::BTreeMap;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// When samples are on disk, and how much of it they take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Policy {
    /// From one commit to the next at least. A power cut takes what has come within the last of these.
    pub every: Duration,
    /// How large the file gets at most, bytes: of more, the oldest entries go, and are counted.
    pub bound: u64,
}

/// How it stands with a journal.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct State {
    /// Samples committed.
    pub committed: u64,
    /// Samples that wait in memory.
    pub waiting: usize,
    /// Samples that were given up before they were on disk.
    pub dropped: u64,
    /// Bytes of the file that hold something.
    pub used: u64,
    /// Why the file takes nothing at present.
    pub failure: Option<Failure>,
}

/// Hears when the file takes nothing, and why; and when it does again.
pub type Tell = Box<dyn Fn(Option<&Failure>) + Send>;
/// Hears that there are more entries.
type More = Box<dyn Fn() + Send + Sync>;

/// The last entry.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Last {
    /// Its number.
    pub number: u64,
    /// None follows.
    pub is_over: bool,
}

/// What the thread and the readers share.
#[derive(Default)]
pub(crate) struct Shared {
    pub state: Mutex<State>,
    /// The last entry,
    pub last: Mutex<Last>,
    /// which has changed.
    pub more: Condvar,
    pub listeners: Mutex<Vec<More>>,
    /// How far readers say that they are.
    pub places: Mutex<BTreeMap<String, u64>>,
}

/// How far readers say that they are.
pub(crate) fn places(shared: &Shared) -> Vec<(String, u64)> {
    let places = lock(&shared.places);
    let places = places.iter();
    places
        .map(|(name, number)| (name.clone(), *number))
        .collect()
}

pub(crate) fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}
