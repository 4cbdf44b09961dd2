//! A history, wherever it is kept.

use crate::query::{Query, Row};
use std::fmt::Debug;
use unoclp_journal::{Entry, Failure};

/// A history. What it says it has done outlasts a power cut.
pub trait Store: Debug + Send {
    /// The number of the last entry that was taken from this journal; none if none was.
    ///
    /// # Errors
    /// [`Failure`].
    fn taken(&mut self, source: &str) -> Result<Option<u64>, Failure>;

    /// Takes these entries of this journal, in order, but those that it has already: all, or none.
    ///
    /// # Errors
    /// [`Failure`]; then none of them is taken, or all are and it could not be said.
    fn take(&mut self, source: &str, entries: &[Entry]) -> Result<(), Failure>;

    /// All points that there are samples of: board and name.
    ///
    /// # Errors
    /// [`Failure`].
    fn points(&mut self) -> Result<Vec<(String, String)>, Failure>;

    /// The rows of a query, in the order of time. The first one begins at `from` with what the point was by then, if that is
    /// known. A step in which nothing has changed has no row.
    ///
    /// # Errors
    /// [`Failure`].
    fn rows(&mut self, query: &Query) -> Result<Vec<Row>, Failure>;

    /// Puts a row for each minute in place of samples that are older than `keep` ms at the moment `now`, and one for each
    /// hour in place of minutes that are four times as old. Says whether there is more to do.
    ///
    /// # Errors
    /// [`Failure`]; then nothing has changed.
    fn thin(&mut self, now: i64, keep: i64) -> Result<bool, Failure>;
}
