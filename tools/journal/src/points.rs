//! The numbers of points in a file of SQLite: a table `point` of board and name, which a history in a file has too.

use crate::entry::Sample;
use rusqlite::{OptionalExtension, Transaction};

/// The number of a sample's point, a new one where it has none.
///
/// # Errors
/// What SQLite says.
pub fn point(all: &Transaction<'_>, sample: &Sample) -> Result<i64, rusqlite::Error> {
    let names = [&sample.board, &sample.point];
    let mut known = all.prepare_cached("SELECT id FROM point WHERE board = ? AND name = ?")?;
    if let Some(id) = known.query_row(names, |row| row.get(0)).optional()? {
        return Ok(id);
    }
    all.prepare_cached("INSERT INTO point (board, name) VALUES (?, ?)")?
        .execute(names)?;
    Ok(all.last_insert_rowid())
}
