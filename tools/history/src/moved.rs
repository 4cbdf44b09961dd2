//! From a file to a database: all of it, or nothing.

use crate::postgres::{Postgres, id};
use crate::sqlite::Sqlite;
use ::postgres::Transaction;
use rusqlite::Row;
use rusqlite::types::FromSql;
use std::collections::HashMap;
use unoclp_journal::Failure;

/// Rows that go at once.
const AT_ONCE: usize = 20_000;

/// How many rows have moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Moved {
    /// Points.
    pub points: u64,
    /// Samples, and rows of minutes and hours.
    pub rows: u64,
}

/// Why nothing has moved.
#[derive(Debug)]
pub enum NotMoved {
    /// The database has samples of this board's point already.
    Known(String, String),
    /// The file cannot be read.
    From(Failure),
    /// The database does not take it.
    To(Failure),
}

/// Copies all of a file into a database, and what was taken of which journal: the gateway goes on there where it has ended.
/// Nobody may write into the file meanwhile.
///
/// # Errors
/// [`NotMoved`]; the database is then as it was.
pub fn move_all(from: &Sqlite, to: &mut Postgres) -> Result<Moved, NotMoved> {
    let mut all = to.client.transaction().map_err(to_failure)?;
    let ids = points(from, &mut all)?;
    let mut moved = Moved {
        points: ids.len() as u64,
        rows: 0,
    };
    let of = |point: i64| ids.get(&point).copied().unwrap_or_default();
    let rows = "SELECT point, at, value FROM (SELECT point, at, seq, value FROM sample
        UNION ALL SELECT point, at, seq, value FROM recent) ORDER BY seq";
    moved.rows += batches(from, rows, |batch| {
        let points: Vec<i32> = column(batch, |row| row.0).into_iter().map(of).collect();
        let moments = column(batch, |row| row.1);
        let values = column(batch, |row| row.2[0]);
        let sql = "INSERT INTO unoclp.sample (point, at, value)
            SELECT p, a, v FROM unnest($1::int[], $2::bigint[], $3::float8[]) WITH ORDINALITY AS new (p, a, v, o) ORDER BY o";
        all.execute(sql, &[&points, &moments, &values])
    })?;
    for width in [crate::thinned::MINUTE, crate::thinned::HOUR] {
        let rows =
            format!("SELECT point, at, least, most, last FROM thinned WHERE width = {width}");
        moved.rows += batches(from, &rows, |batch| {
            let points: Vec<i32> = column(batch, |row| row.0).into_iter().map(of).collect();
            let moments = column(batch, |row| row.1);
            let [least, most, last] = [0, 1, 2].map(|at| column(batch, |row| row.2[at]));
            let sql = "INSERT INTO unoclp.thinned
                SELECT p, a, $6, l, m, e
                FROM unnest($1::int[], $2::bigint[], $3::float8[], $4::float8[], $5::float8[]) AS new (p, a, l, m, e)";
            all.execute(sql, &[&points, &moments, &least, &most, &last, &width])
        })?;
    }
    taken(from, &mut all)?;
    all.commit().map_err(to_failure)?;
    Ok(moved)
}

/// What a row has beside its point and its moment; where it is a sample, the first is its value.
type Values = [Option<f64>; 3];
type Batch = [(i64, i64, Values)];

fn column<T>(batch: &Batch, of: impl Fn(&(i64, i64, Values)) -> T) -> Vec<T> {
    batch.iter().map(of).collect()
}

/// Puts the rows of this statement, some at a time; says how many.
fn batches(
    from: &Sqlite,
    sql: &str,
    mut put: impl FnMut(&Batch) -> Result<u64, ::postgres::Error>,
) -> Result<u64, NotMoved> {
    let mut rows = from.file.prepare(sql).map_err(from_failure)?;
    let last = rows.column_count();
    let mut rows = rows.query([]).map_err(from_failure)?;
    let (mut batch, mut count) = (Vec::new(), 0);
    loop {
        let row = rows.next().map_err(from_failure)?;
        if row.is_none() || batch.len() == AT_ONCE {
            count += put(&batch).map_err(to_failure)?;
            batch.clear();
        }
        let Some(row) = row else {
            return Ok(count);
        };
        let value = |at| match at < last {
            true => get::<Option<f64>>(row, at),
            false => Ok(None),
        };
        batch.push((
            get(row, 0)?,
            get(row, 1)?,
            [value(2)?, value(3)?, value(4)?],
        ));
    }
}

fn get<T: FromSql>(row: &Row<'_>, at: usize) -> Result<T, NotMoved> {
    row.get(at).map_err(from_failure)
}

/// The points of the file by their numbers there, with those that they have in the database.
fn points(from: &Sqlite, all: &mut Transaction<'_>) -> Result<HashMap<i64, i32>, NotMoved> {
    let mut points = from
        .file
        .prepare("SELECT id, board, name FROM point")
        .map_err(from_failure)?;
    let points = points
        .query_map([], |row| Ok((row.get(0)?, row.get(1)?, row.get(2)?)))
        .map_err(from_failure)?;
    let (mut ids, mut known) = (HashMap::new(), HashMap::new());
    for point in points {
        let (of, board, name): (i64, String, String) = point.map_err(from_failure)?;
        let id = id(all, &mut known, &board, &name).map_err(NotMoved::To)?;
        let sql = "SELECT EXISTS (SELECT FROM unoclp.sample WHERE point = $1)
            OR EXISTS (SELECT FROM unoclp.thinned WHERE point = $1)";
        if all.query_one(sql, &[&id]).map_err(to_failure)?.get(0) {
            return Err(NotMoved::Known(board, name));
        }
        ids.insert(of, id);
    }
    Ok(ids)
}

fn taken(from: &Sqlite, all: &mut Transaction<'_>) -> Result<(), NotMoved> {
    let mut taken = from
        .file
        .prepare("SELECT source, n FROM taken")
        .map_err(from_failure)?;
    let taken = taken
        .query_map([], |row| Ok((row.get(0)?, row.get(1)?)))
        .map_err(from_failure)?;
    for source in taken {
        let (source, number): (String, i64) = source.map_err(from_failure)?;
        let sql = "INSERT INTO unoclp.taken VALUES ($1, $2)
            ON CONFLICT (source) DO UPDATE SET n = greatest(taken.n, excluded.n)";
        all.execute(sql, &[&source, &number]).map_err(to_failure)?;
    }
    Ok(())
}

fn from_failure(error: rusqlite::Error) -> NotMoved {
    NotMoved::From(error.into())
}

fn to_failure(error: ::postgres::Error) -> NotMoved {
    NotMoved::To(crate::postgres::failure(error))
}
