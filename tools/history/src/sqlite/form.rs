//! The tables of a file, and how those of an older version become them.

use rusqlite::Connection;
use unoclp_journal::Failure;

/// Says that the file is one of these: `uncl`.
const OURS: i64 = 0x756e_636c;
/// The version of the form. A later one is refused as it is.
const VERSION: i64 = 3;

/// A thinned row stands for the samples from `at` on, `width` ms long. Of each journal (source) all is taken up to `n`.
const FORM: &str = "
    CREATE TABLE point (id INTEGER PRIMARY KEY, board TEXT NOT NULL, name TEXT NOT NULL, UNIQUE (board, name));
    CREATE TABLE sample (point INTEGER NOT NULL REFERENCES point, at INTEGER NOT NULL, seq INTEGER NOT NULL, value REAL,
        PRIMARY KEY (point, at, seq)) WITHOUT ROWID;
    CREATE TABLE thinned (point INTEGER NOT NULL REFERENCES point, at INTEGER NOT NULL, width INTEGER NOT NULL,
        least REAL, most REAL, last REAL, PRIMARY KEY (point, at)) WITHOUT ROWID;
    CREATE TABLE next (seq INTEGER NOT NULL);
    INSERT INTO next VALUES (0);
";
/// What version 2 has beside that.
const TAKEN: &str =
    "CREATE TABLE taken (source TEXT PRIMARY KEY, n INTEGER NOT NULL) WITHOUT ROWID;";
/// What version 3 has beside that: samples as they have come, before they are sorted in among the others.
const RECENT: &str = "TABLE recent (seq INTEGER PRIMARY KEY, point INTEGER NOT NULL, at INTEGER NOT NULL, value REAL);";

/// The version of a file; none of an empty one.
pub(super) fn found(file: &Connection) -> Result<Option<i64>, Failure> {
    let tables: i64 = file.query_row("SELECT count(*) FROM sqlite_schema", [], |row| row.get(0))?;
    if tables == 0 {
        return Ok(None);
    }
    let number = |name| file.pragma_query_value(None, name, |row| row.get::<_, i64>(0));
    if number("application_id")? != OURS {
        return Err(Failure::Foreign);
    }
    match number("user_version")? {
        version @ 1..=VERSION => Ok(Some(version)),
        other => Err(Failure::Version(other)),
    }
}

/// Brings a file of this version to the present one: all of it, or nothing.
pub(super) fn bring(file: &mut Connection, found: Option<i64>) -> Result<(), Failure> {
    if found == Some(VERSION) {
        return Ok(());
    }
    let form = file.transaction()?;
    if found.is_none() {
        form.execute_batch(FORM)?;
        form.pragma_update(None, "application_id", OURS)?;
    }
    if found < Some(2) {
        form.execute_batch(TAKEN)?;
    }
    form.execute_batch(&format!("CREATE {RECENT}"))?;
    form.pragma_update(None, "user_version", VERSION)?;
    form.commit()?;
    Ok(())
}

/// Lets a file of this version be read as one of the present one. The file stays as it is.
pub(super) fn read_as_present(file: &Connection, found: i64) -> Result<(), Failure> {
    if found < VERSION {
        file.execute_batch(&format!("CREATE TEMP {RECENT}"))?;
    }
    Ok(())
}
