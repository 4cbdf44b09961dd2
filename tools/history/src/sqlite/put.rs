//! How samples come in: at the end of one table, and from there, many at a time, among those of their points.

use rusqlite::{Connection, Transaction, params};
use std::collections::HashMap;
use unoclp_journal::{Failure, Sample, point};

/// Once so many samples stand as they came, they are sorted in. Who reads looks through all of them.
const SORTED_AT: i64 = 50_000;

/// The numbers of points that are known, by board and name.
#[derive(Debug, Default)]
pub(super) struct Points(HashMap<String, HashMap<String, i64>>);

/// Writes these samples, and up to which number of which journal they lead: all of it, or nothing.
pub(super) fn put<'s>(
    file: &mut Connection,
    points: &mut Points,
    samples: impl Iterator<Item = &'s Sample>,
    taken: Option<(&str, u64)>,
) -> Result<(), Failure> {
    let all = file.transaction()?;
    let next = append(&all, points, samples)?;
    if let Some((source, number)) = taken {
        let number = i64::try_from(number).unwrap_or(i64::MAX);
        all.prepare_cached("INSERT OR REPLACE INTO taken VALUES (?, ?)")?
            .execute(params![source, number])?;
    }
    let first: Option<i64> = all
        .prepare_cached("SELECT min(seq) FROM recent")?
        .query_row([], |row| row.get(0))?;
    all.commit()?;
    // They are written, whether there is room to sort them or not.
    if first.is_some_and(|first| next - first >= SORTED_AT) {
        let all = file.transaction()?;
        sort_in(&all)?;
        all.commit()?;
    }
    Ok(())
}

/// Each sample gets a number of its own, in the order of writing: a clock that is set back changes no order. Gives the next
/// number.
fn append<'s>(
    all: &Transaction<'_>,
    points: &mut Points,
    samples: impl Iterator<Item = &'s Sample>,
) -> Result<i64, rusqlite::Error> {
    let mut seq: i64 = all
        .prepare_cached("SELECT seq FROM next")?
        .query_row([], |row| row.get(0))?;
    let mut insert = all.prepare_cached("INSERT INTO recent VALUES (?, ?, ?, ?)")?;
    for sample in samples {
        let point = points.of(all, sample)?;
        insert.execute(params![seq, point, sample.at, sample.value])?;
        seq += 1;
    }
    all.prepare_cached("UPDATE next SET seq = ?")?
        .execute([seq])?;
    Ok(seq)
}

/// Sorts in all that stands as it came.
pub(super) fn sort_in(all: &Transaction<'_>) -> Result<(), rusqlite::Error> {
    let sql = "INSERT INTO sample SELECT point, at, seq, value FROM recent ORDER BY point, at, seq";
    all.prepare_cached(sql)?.execute([])?;
    all.prepare_cached("DELETE FROM recent")?.execute([])?;
    Ok(())
}

impl Points {
    /// The number of a sample's point, a new one where it has none.
    fn of(&mut self, all: &Transaction<'_>, sample: &Sample) -> Result<i64, rusqlite::Error> {
        let known = self.0.get(&*sample.board);
        if let Some(id) = known.and_then(|of| of.get(&*sample.point)) {
            return Ok(*id);
        }
        let id = point(all, sample)?;
        let board = self.0.entry(sample.board.clone()).or_default();
        board.insert(sample.point.clone(), id);
        Ok(id)
    }
}
