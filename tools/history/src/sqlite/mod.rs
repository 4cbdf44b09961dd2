//! A history in a file of SQLite: points, what they were, and what is left of that.
//!
//! Samples come in the order of time, a few of each point, and are asked for by point. So they are written at the end of one
//! table as they come, and sorted in among those of their points many at a time: else each would cost a page of its own.
//!
//! - `form`: the tables, and how those of an older version become them
//! - `put`: how samples come in
//! - `rows`: what is asked; `thin`: what is left of old rows

mod form;
mod put;
mod rows;
mod thin;

use crate::query::{Query, Row};
use crate::store::Store;
use put::Points;
use rusqlite::{Connection, OpenFlags, OptionalExtension};
use std::path::Path;
use std::time::Duration;
use unoclp_journal::{Entry, Failure, Sample};

/// How long another process may hold the file.
const PATIENCE: Duration = Duration::from_secs(5);

/// A file of samples.
#[derive(Debug)]
pub struct Sqlite {
    pub(crate) file: Connection,
    points: Points,
}

impl Sqlite {
    fn of(file: Connection) -> Sqlite {
        Sqlite {
            file,
            points: Points::default(),
        }
    }

    /// Opens this file, and makes it where it is not there. One of an older version is brought to this one.
    ///
    /// # Errors
    /// [`Failure`]; the file is then as it was.
    pub fn open(path: &Path) -> Result<Sqlite, Failure> {
        let mut file = Connection::open(path)?;
        file.busy_timeout(PATIENCE)?;
        let found = form::found(&file)?;
        // Nobody who reads waits for who writes; what is committed outlasts a power cut.
        file.pragma_update(None, "journal_mode", "WAL")?;
        file.pragma_update(None, "synchronous", "FULL")?;
        form::bring(&mut file, found)?;
        Ok(Sqlite::of(file))
    }

    /// The same to read alone, beside whoever writes.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(path: &Path) -> Result<Sqlite, Failure> {
        let file = Connection::open_with_flags(path, OpenFlags::SQLITE_OPEN_READ_ONLY)?;
        file.busy_timeout(PATIENCE)?;
        let found = form::found(&file)?.ok_or(Failure::Foreign)?;
        form::read_as_present(&file, found)?;
        Ok(Sqlite::of(file))
    }

    /// Writes these samples, all or none of them.
    ///
    /// # Errors
    /// [`Failure`]; none of them is then written.
    pub fn append(&mut self, samples: &[Sample]) -> Result<(), Failure> {
        self.put(samples.iter(), None)
    }

    /// The same, and how far they lead in which journal.
    fn put<'s>(
        &mut self,
        samples: impl Iterator<Item = &'s Sample>,
        taken: Option<(&str, u64)>,
    ) -> Result<(), Failure> {
        let written = put::put(&mut self.file, &mut self.points, samples, taken);
        if written.is_err() {
            // What was new among them has been undone.
            self.points = Points::default();
        }
        written
    }
}

impl Store for Sqlite {
    fn taken(&mut self, source: &str) -> Result<Option<u64>, Failure> {
        Ok(taken(&self.file, source)?)
    }

    fn take(&mut self, source: &str, entries: &[Entry]) -> Result<(), Failure> {
        let before = taken(&self.file, source)?.unwrap_or(0);
        let new = entries.iter().filter(|entry| entry.number > before);
        let Some(last) = new.clone().next_back() else {
            return Ok(());
        };
        self.put(new.map(|entry| &entry.sample), Some((source, last.number)))
    }

    fn points(&mut self) -> Result<Vec<(String, String)>, Failure> {
        let mut points = self
            .file
            .prepare("SELECT board, name FROM point ORDER BY board, name")?;
        let points = points.query_map([], |row| Ok((row.get(0)?, row.get(1)?)))?;
        Ok(points.collect::<Result<_, _>>()?)
    }

    fn rows(&mut self, query: &Query) -> Result<Vec<Row>, Failure> {
        rows::rows(&self.file, query)
    }

    fn thin(&mut self, now: i64, keep: i64) -> Result<bool, Failure> {
        thin::thin(&mut self.file, now, keep)
    }
}

fn taken(file: &Connection, source: &str) -> Result<Option<u64>, rusqlite::Error> {
    let mut taken = file.prepare_cached("SELECT n FROM taken WHERE source = ?")?;
    let taken: Option<i64> = taken.query_row([source], |row| row.get(0)).optional()?;
    Ok(taken.and_then(|taken| u64::try_from(taken).ok()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(number: u64) -> Entry {
        Entry {
            number,
            sample: Sample {
                board: "b".into(),
                point: "p".into(),
                at: number as i64,
                value: Some(1.0),
            },
        }
    }

    #[test]
    fn a_file_that_may_only_be_read_says_so_and_stays() {
        let folder = tempfile::tempdir().unwrap();
        let mut store = Sqlite::open(&folder.path().join("h.db")).unwrap();
        let read_only = |store: &Sqlite, is: bool| {
            store.file.pragma_update(None, "query_only", is).unwrap();
        };
        read_only(&store, true);
        assert_eq!(store.take("s", &[entry(1)]), Err(Failure::ReadOnly));
        assert_eq!(store.taken("s"), Ok(None));
        read_only(&store, false);
        store.take("s", &[entry(1)]).unwrap();
        let points = [("b".to_owned(), "p".to_owned())];
        assert_eq!(store.points().unwrap(), points);
    }

    #[test]
    fn where_the_disk_is_full_nothing_is_written_by_half() {
        let folder = tempfile::tempdir().unwrap();
        let mut store = Sqlite::open(&folder.path().join("h.db")).unwrap();
        store.take("s", &[entry(1)]).unwrap();
        let limit = |store: &Sqlite, pages: i64| {
            let set = format!("PRAGMA max_page_count({pages})");
            store.file.query_row(&set, [], |_| Ok(())).unwrap();
        };
        limit(&store, 1);
        let many: Vec<Entry> = (2..10_000).map(entry).collect();
        assert_eq!(store.take("s", &many), Err(Failure::Full));
        assert_eq!(store.taken("s"), Ok(Some(1)));
        let query = Query {
            board: "b".into(),
            point: "p".into(),
            from: 0,
            to: 20_000,
            step: 0,
            most: usize::MAX,
        };
        assert_eq!(store.rows(&query).unwrap().len(), 1);
        limit(&store, 1_000_000);
        store.take("s", &many).unwrap();
        assert_eq!(store.rows(&query).unwrap().len(), 9_999);
    }
}
