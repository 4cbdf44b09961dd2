//! The file of a journal: entries in order, and how far each reader is.

use crate::bound::{up_to, used};
use crate::entry::{Entry, Sample};
use crate::failure::Failure;
use crate::points::point;
pub use crate::readers::Place;
use crate::readers::{Readers, drop_up_to, taken_by_all};
use rusqlite::{Connection, OptionalExtension, Transaction, params};
use std::fmt::Write;
use std::path::Path;
use std::time::Duration;

/// Says that the file is one of these: `uncj`.
const OURS: i64 = 0x756e_636a;
/// The version of the form. A file of another one is refused as it is.
const VERSION: i64 = 1;
/// The write-ahead file is cut to this once it has been worked in, bytes.
const AHEAD: i64 = 4 << 20;

const FORM: &str = "
    CREATE TABLE journal (source TEXT NOT NULL, next INTEGER NOT NULL);
    CREATE TABLE point (id INTEGER PRIMARY KEY, board TEXT NOT NULL, name TEXT NOT NULL, UNIQUE (board, name));
    CREATE TABLE entry (n INTEGER PRIMARY KEY, point INTEGER NOT NULL REFERENCES point, at INTEGER NOT NULL, value REAL);
    CREATE TABLE reader (name TEXT PRIMARY KEY, n INTEGER NOT NULL, dropped INTEGER NOT NULL) WITHOUT ROWID;
";

/// A journal's file, which no other process can open meanwhile.
#[derive(Debug)]
pub struct File {
    pub(crate) file: Connection,
    source: String,
    /// The number of the next entry.
    next: u64,
    readers: Readers,
}

impl File {
    /// Opens this file, and makes it where it is not there.
    ///
    /// # Errors
    /// [`Failure`]; the file is then as it was.
    pub fn open(path: &Path) -> Result<File, Failure> {
        let mut file = Connection::open(path)?;
        file.busy_timeout(Duration::ZERO)?;
        // From the first reading on it is nobody else's.
        file.pragma_update(None, "locking_mode", "EXCLUSIVE")?;
        let tables: i64 =
            file.query_row("SELECT count(*) FROM sqlite_schema", [], |row| row.get(0))?;
        if tables > 0 {
            check(&file)?;
        }
        file.pragma_update(None, "journal_mode", "WAL")?;
        // What is committed outlasts a power cut.
        file.pragma_update(None, "synchronous", "FULL")?;
        file.pragma_update(None, "journal_size_limit", AHEAD)?;
        if tables == 0 {
            make(&mut file)?;
        }
        // Takes the lock for good, and says so where another has it.
        file.execute("UPDATE journal SET next = next", [])?;
        let (source, next): (String, i64) =
            file.query_row("SELECT source, next FROM journal", [], |row| {
                Ok((row.get(0)?, row.get(1)?))
            })?;
        let readers = readers(&file)?;
        Ok(File {
            file,
            source,
            next: unsigned(next),
            readers,
        })
    }

    /// What tells this journal from all others.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The number of the last entry, 0 before the first.
    pub fn last(&self) -> u64 {
        self.next - 1
    }

    /// Where a reader is.
    pub fn place(&self, reader: &str) -> Place {
        self.readers.get(reader).copied().unwrap_or_default()
    }

    /// These are the readers from now on: what they have not taken is kept. A new one begins with what is there.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn set_readers(&mut self, names: &[&str]) -> Result<(), Failure> {
        let first = self.first()?;
        let known = std::mem::take(&mut self.readers);
        let begin = Place {
            number: first.map_or(self.last(), |first| first - 1),
            dropped: 0,
        };
        for name in names {
            let place = known.get(*name).copied().unwrap_or(begin);
            self.readers.insert((*name).to_owned(), place);
        }
        let all = self.file.transaction()?;
        all.execute("DELETE FROM reader", [])?;
        write_readers(&all, &self.readers)?;
        all.commit()?;
        Ok(())
    }

    /// Numbers go on after this one, if they are not there yet: somebody has taken it.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn skip_to(&mut self, number: u64) -> Result<(), Failure> {
        if self.next <= number {
            let next = number + 1;
            self.file
                .execute("UPDATE journal SET next = ?", [signed(next)])?;
            self.next = next;
        }
        Ok(())
    }

    /// Commits these samples, how far the readers are by `places`, and forgets what all have taken. Where the file is then
    /// larger than `bound` bytes the oldest entries go.
    ///
    /// # Errors
    /// [`Failure`]; then nothing has changed.
    pub fn commit(
        &mut self,
        samples: &[Sample],
        places: &[(String, u64)],
        bound: u64,
    ) -> Result<(), Failure> {
        let mut readers = self.readers.clone();
        for (name, number) in places {
            if let Some(place) = readers.get_mut(name) {
                place.number = place.number.max(*number);
            }
        }
        let all = self.file.transaction()?;
        let mut next = self.next;
        for sample in samples {
            let point = point(&all, sample)?;
            let row = params![signed(next), point, sample.at, sample.value];
            all.prepare_cached("INSERT INTO entry VALUES (?, ?, ?, ?)")?
                .execute(row)?;
            next += 1;
        }
        all.execute("UPDATE journal SET next = ?", [signed(next)])?;
        let taken = taken_by_all(&readers, next - 1);
        forget(&all, taken)?;
        while let Some(first) = first(&all)?.filter(|first| *first < next)
            && used(&all)? > bound
        {
            let number = up_to(first, next - 1);
            forget(&all, number)?;
            drop_up_to(&mut readers, number);
        }
        write_readers(&all, &readers)?;
        all.commit()?;
        self.next = next;
        self.readers = readers;
        Ok(())
    }

    /// The entries after this number, at most so many.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(&self, after: u64, most: usize) -> Result<Vec<Entry>, Failure> {
        let mut entries = self.file.prepare_cached(
            "SELECT n, board, name, at, value FROM entry JOIN point ON point.id = entry.point
             WHERE n > ? ORDER BY n LIMIT ?",
        )?;
        let most = i64::try_from(most).unwrap_or(i64::MAX);
        let entries = entries.query_map([signed(after), most], |row| {
            Ok(Entry {
                number: unsigned(row.get(0)?),
                sample: Sample {
                    board: row.get(1)?,
                    point: row.get(2)?,
                    at: row.get(3)?,
                    value: row.get(4)?,
                },
            })
        })?;
        Ok(entries.collect::<Result<_, _>>()?)
    }

    /// The bytes of its pages that hold something.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn used(&self) -> Result<u64, Failure> {
        Ok(used(&self.file)?)
    }

    fn first(&self) -> Result<Option<u64>, Failure> {
        Ok(first(&self.file)?)
    }
}

fn make(file: &mut Connection) -> Result<(), Failure> {
    let mut random = [0; 16];
    getrandom::fill(&mut random).map_err(|error| Failure::Other(error.to_string()))?;
    let mut source = String::new();
    for byte in random {
        // To a string nothing fails.
        let _ = write!(source, "{byte:02x}");
    }
    let form = file.transaction()?;
    form.execute_batch(FORM)?;
    form.execute("INSERT INTO journal VALUES (?, 1)", [source])?;
    form.pragma_update(None, "application_id", OURS)?;
    form.pragma_update(None, "user_version", VERSION)?;
    form.commit()?;
    Ok(())
}

fn check(file: &Connection) -> Result<(), Failure> {
    let number = |name| file.pragma_query_value(None, name, |row| row.get::<_, i64>(0));
    if number("application_id")? != OURS {
        return Err(Failure::Foreign);
    }
    match number("user_version")? {
        VERSION => Ok(()),
        other => Err(Failure::Version(other)),
    }
}

fn readers(file: &Connection) -> Result<Readers, Failure> {
    let mut readers = file.prepare("SELECT name, n, dropped FROM reader")?;
    let readers = readers.query_map([], |row| {
        let place = Place {
            number: unsigned(row.get(1)?),
            dropped: unsigned(row.get(2)?),
        };
        Ok((row.get(0)?, place))
    })?;
    Ok(readers.collect::<Result<_, _>>()?)
}

fn write_readers(all: &Transaction<'_>, readers: &Readers) -> Result<(), Failure> {
    for (name, place) in readers {
        let row = params![name, signed(place.number), signed(place.dropped)];
        all.prepare_cached("INSERT OR REPLACE INTO reader VALUES (?, ?, ?)")?
            .execute(row)?;
    }
    Ok(())
}

fn forget(all: &Transaction<'_>, up_to: u64) -> Result<(), Failure> {
    all.prepare_cached("DELETE FROM entry WHERE n <= ?")?
        .execute([signed(up_to)])?;
    Ok(())
}

fn first(file: &Connection) -> Result<Option<u64>, rusqlite::Error> {
    let mut first = file.prepare_cached("SELECT n FROM entry ORDER BY n LIMIT 1")?;
    let first: Option<i64> = first.query_row([], |row| row.get(0)).optional()?;
    Ok(first.map(unsigned))
}

/// SQLite counts with a sign; no journal lives to need it.
fn signed(number: u64) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX)
}

fn unsigned(number: i64) -> u64 {
    u64::try_from(number).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_the_disk_is_full_nothing_is_written_by_half_and_no_number_is_lost() {
        let folder = tempfile::tempdir().unwrap();
        let mut file = File::open(&folder.path().join("j")).unwrap();
        file.set_readers(&["r"]).unwrap();
        let samples: Vec<Sample> = (0..10_000)
            .map(|at| Sample {
                board: "b".into(),
                point: "p".into(),
                at,
                value: Some(1.0),
            })
            .collect();
        file.commit(&samples[..1], &[], u64::MAX).unwrap();
        let limit = |file: &File, pages: i64| {
            let set = format!("PRAGMA max_page_count({pages})");
            file.file.query_row(&set, [], |_| Ok(())).unwrap();
        };
        limit(&file, 1);
        let taken = [("r".to_owned(), 1)];
        let full = file.commit(&samples, &taken, u64::MAX);
        assert_eq!(full, Err(Failure::Full));
        assert_eq!((file.last(), file.place("r").number), (1, 0));
        limit(&file, 1_000_000);
        file.commit(&samples, &taken, u64::MAX).unwrap();
        let entries = file.read(0, usize::MAX).unwrap();
        let numbers: Vec<u64> = entries.iter().map(|entry| entry.number).collect();
        assert_eq!(numbers, (2..=10_001).collect::<Vec<_>>());
    }
}
