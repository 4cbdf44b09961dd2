//! The file: points, what they were, and what is left of that.

use crate::sample::Sample;
use rusqlite::{Connection, ErrorCode, OpenFlags, Transaction, params};
use std::path::Path;
use std::time::Duration;

/// Says that the file is one of these: `uncl`.
const OURS: i64 = 0x756e_636c;
/// The version of the form. A file of another one is refused as it is.
const VERSION: i64 = 1;

/// Each sample has a number of its own, in the order of writing: a clock that is set back changes no order. A thinned row
/// stands for the samples from `at` on, `width` ms long.
const FORM: &str = "
    CREATE TABLE point (id INTEGER PRIMARY KEY, board TEXT NOT NULL, name TEXT NOT NULL, UNIQUE (board, name));
    CREATE TABLE sample (point INTEGER NOT NULL REFERENCES point, at INTEGER NOT NULL, seq INTEGER NOT NULL, value REAL,
        PRIMARY KEY (point, at, seq)) WITHOUT ROWID;
    CREATE TABLE thinned (point INTEGER NOT NULL REFERENCES point, at INTEGER NOT NULL, width INTEGER NOT NULL,
        least REAL, most REAL, last REAL, PRIMARY KEY (point, at)) WITHOUT ROWID;
    CREATE TABLE next (seq INTEGER NOT NULL);
    INSERT INTO next VALUES (0);
";

/// Why a file cannot be used.
#[derive(Debug)]
pub enum Failure {
    /// It is something else.
    Foreign,
    /// Another version has written it.
    Version(i64),
    /// The disk is full.
    Full,
    /// It may only be read.
    ReadOnly,
    /// What SQLite says.
    Other(String),
}

impl From<rusqlite::Error> for Failure {
    fn from(error: rusqlite::Error) -> Failure {
        match error.sqlite_error_code() {
            Some(ErrorCode::DiskFull) => Failure::Full,
            Some(ErrorCode::ReadOnly) => Failure::ReadOnly,
            Some(ErrorCode::NotADatabase) => Failure::Foreign,
            _ => Failure::Other(error.to_string()),
        }
    }
}

/// A file of samples.
#[derive(Debug)]
pub struct Store {
    pub(crate) file: Connection,
}

impl Store {
    /// Opens this file, and makes it where it is not there.
    ///
    /// # Errors
    /// [`Failure`]; the file is then as it was.
    pub fn open(path: &Path) -> Result<Store, Failure> {
        Store::of(Connection::open(path)?)
    }

    /// The same to read alone, beside whoever writes.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(path: &Path) -> Result<Store, Failure> {
        let file = Connection::open_with_flags(path, OpenFlags::SQLITE_OPEN_READ_ONLY)?;
        file.busy_timeout(Duration::from_secs(5))?;
        check(&file)?;
        Ok(Store { file })
    }

    fn of(mut file: Connection) -> Result<Store, Failure> {
        file.busy_timeout(Duration::from_secs(5))?;
        let tables: i64 =
            file.query_row("SELECT count(*) FROM sqlite_schema", [], |row| row.get(0))?;
        if tables > 0 {
            check(&file)?;
        }
        // Nobody who reads waits for who writes; what is committed outlasts a power cut.
        file.pragma_update(None, "journal_mode", "WAL")?;
        file.pragma_update(None, "synchronous", "FULL")?;
        if tables == 0 {
            let form = file.transaction()?;
            form.execute_batch(FORM)?;
            form.pragma_update(None, "application_id", OURS)?;
            form.pragma_update(None, "user_version", VERSION)?;
            form.commit()?;
        }
        Ok(Store { file })
    }

    /// Writes these samples, all or none of them.
    ///
    /// # Errors
    /// [`Failure`]; none of them is then written.
    pub fn append(&mut self, samples: &[Sample]) -> Result<(), Failure> {
        let all = self.file.transaction()?;
        let mut seq: i64 = all.query_row("SELECT seq FROM next", [], |row| row.get(0))?;
        for sample in samples {
            let point = point(&all, sample)?;
            let row = params![point, sample.at, seq, sample.value];
            all.prepare_cached("INSERT INTO sample VALUES (?, ?, ?, ?)")?
                .execute(row)?;
            seq += 1;
        }
        all.execute("UPDATE next SET seq = ?", [seq])?;
        all.commit()?;
        Ok(())
    }

    /// All points that there are samples of: board and name.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn points(&self) -> Result<Vec<(String, String)>, Failure> {
        let mut points = self
            .file
            .prepare("SELECT board, name FROM point ORDER BY board, name")?;
        let points = points.query_map([], |row| Ok((row.get(0)?, row.get(1)?)))?;
        Ok(points.collect::<Result<_, _>>()?)
    }
}

/// The number of a sample's point, a new one where it has none.
fn point(all: &Transaction<'_>, sample: &Sample) -> Result<i64, rusqlite::Error> {
    let names = [&sample.board, &sample.point];
    all.prepare_cached("INSERT OR IGNORE INTO point (board, name) VALUES (?, ?)")?
        .execute(names)?;
    all.prepare_cached("SELECT id FROM point WHERE board = ? AND name = ?")?
        .query_row(names, |row| row.get(0))
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
