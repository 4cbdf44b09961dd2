//! A history in a file of SQLite: points, what they were, and what is left of that.
//!
//! - `form`: the tables, and how those of an older version become them
//! - `rows`: what is asked; `thin`: what is left of old rows

mod form;
mod rows;
mod thin;

use crate::query::{Query, Row};
use crate::store::Store;
use rusqlite::{Connection, OpenFlags, OptionalExtension, Transaction, params};
use std::path::Path;
use std::time::Duration;
use unoclp_journal::{Entry, Failure, Sample};

/// How long another process may hold the file.
const PATIENCE: Duration = Duration::from_secs(5);

/// A file of samples.
#[derive(Debug)]
pub struct Sqlite {
    pub(crate) file: Connection,
}

impl Sqlite {
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
        Ok(Sqlite { file })
    }

    /// The same to read alone, beside whoever writes.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(path: &Path) -> Result<Sqlite, Failure> {
        let file = Connection::open_with_flags(path, OpenFlags::SQLITE_OPEN_READ_ONLY)?;
        file.busy_timeout(PATIENCE)?;
        match form::found(&file)? {
            Some(_) => Ok(Sqlite { file }),
            None => Err(Failure::Foreign),
        }
    }

    /// Writes these samples, all or none of them.
    ///
    /// # Errors
    /// [`Failure`]; none of them is then written.
    pub fn append(&mut self, samples: &[Sample]) -> Result<(), Failure> {
        let all = self.file.transaction()?;
        append(&all, samples.iter())?;
        all.commit()?;
        Ok(())
    }
}

impl Store for Sqlite {
    fn taken(&mut self, source: &str) -> Result<Option<u64>, Failure> {
        Ok(taken(&self.file, source)?)
    }

    fn take(&mut self, source: &str, entries: &[Entry]) -> Result<(), Failure> {
        let all = self.file.transaction()?;
        let before = taken(&all, source)?.unwrap_or(0);
        let new = entries.iter().filter(|entry| entry.number > before);
        append(&all, new.map(|entry| &entry.sample))?;
        if let Some(last) = entries.last().filter(|last| last.number > before) {
            let number = i64::try_from(last.number).unwrap_or(i64::MAX);
            all.prepare_cached("INSERT OR REPLACE INTO taken VALUES (?, ?)")?
                .execute(params![source, number])?;
        }
        all.commit()?;
        Ok(())
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

/// Each sample gets a number of its own, in the order of writing: a clock that is set back changes no order.
fn append<'s>(
    all: &Transaction<'_>,
    samples: impl Iterator<Item = &'s Sample>,
) -> Result<(), rusqlite::Error> {
    let mut seq: i64 = all.query_row("SELECT seq FROM next", [], |row| row.get(0))?;
    for sample in samples {
        let row = params![point(all, sample)?, sample.at, seq, sample.value];
        all.prepare_cached("INSERT INTO sample VALUES (?, ?, ?, ?)")?
            .execute(row)?;
        seq += 1;
    }
    all.execute("UPDATE next SET seq = ?", [seq])?;
    Ok(())
}

/// The number of a sample's point, a new one where it has none.
fn point(all: &Transaction<'_>, sample: &Sample) -> Result<i64, rusqlite::Error> {
    let names = [&sample.board, &sample.point];
    let mut known = all.prepare_cached("SELECT id FROM point WHERE board = ? AND name = ?")?;
    if let Some(id) = known.query_row(names, |row| row.get(0)).optional()? {
        return Ok(id);
    }
    all.prepare_cached("INSERT INTO point (board, name) VALUES (?, ?)")?
        .execute(names)?;
    Ok(all.last_insert_rowid())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_the_disk_is_full_nothing_is_written_by_half() {
        let folder = tempfile::tempdir().unwrap();
        let mut store = Sqlite::open(&folder.path().join("h.db")).unwrap();
        let entry = |number: u64| Entry {
            number,
            sample: Sample {
                board: "b".into(),
                point: "p".into(),
                at: number as i64,
                value: Some(1.0),
            },
        };
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
