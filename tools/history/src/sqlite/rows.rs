//! What is asked of a file.

use crate::query::{Answer, Query, Row};
use rusqlite::{Connection, OptionalExtension, params};
use unoclp_journal::Failure;

pub(super) fn rows(file: &Connection, query: &Query) -> Result<Vec<Row>, Failure> {
    let mut id = file.prepare_cached("SELECT id FROM point WHERE board = ? AND name = ?")?;
    let id = id.query_row([&query.board, &query.point], |row| row.get(0));
    let Some(point): Option<i64> = id.optional()? else {
        return Ok(Vec::new());
    };
    let mut answer = Answer::new(query, before(file, point, query.from)?);
    let mut found = file.prepare_cached(
        "SELECT at, least, most, last, 0 AS seq FROM thinned WHERE point = ?1 AND at >= ?2 AND at < ?3
         UNION ALL SELECT at, value, value, value, seq FROM sample WHERE point = ?1 AND at >= ?2 AND at < ?3
         UNION ALL SELECT at, value, value, value, seq FROM recent WHERE point = ?1 AND at >= ?2 AND at < ?3
         ORDER BY at, seq",
    )?;
    let found = found.query_map(params![point, query.from, query.to], |row| {
        Ok(Row {
            at: row.get(0)?,
            least: row.get(1)?,
            most: row.get(2)?,
            last: row.get(3)?,
        })
    })?;
    for row in found {
        if !answer.take(row?) {
            break;
        }
    }
    Ok(answer.rows())
}

/// What a point was just before this moment; none where that is not known.
fn before(file: &Connection, point: i64, at: i64) -> Result<Option<Option<f64>>, Failure> {
    let mut last = file.prepare_cached(
        "SELECT last FROM (
            SELECT * FROM (SELECT at, last, 0 AS seq FROM thinned WHERE point = ?1 AND at < ?2 ORDER BY at DESC LIMIT 1)
            UNION ALL
            SELECT * FROM (SELECT at, value, seq FROM sample WHERE point = ?1 AND at < ?2 ORDER BY at DESC, seq DESC LIMIT 1)
            UNION ALL
            SELECT * FROM (SELECT at, value, seq FROM recent WHERE point = ?1 AND at < ?2 ORDER BY at DESC, seq DESC LIMIT 1)
         ) ORDER BY at DESC, seq DESC LIMIT 1",
    )?;
    let last = last.query_row([point, at], |row| row.get(0));
    Ok(last.optional()?)
}
