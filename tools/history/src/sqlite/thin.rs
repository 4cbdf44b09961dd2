//! Puts one row in place of many that are old.

use super::put::sort_in;
use crate::query::Row;
use crate::thinned::{AT_ONCE, HOUR, MINUTE, Part, before, whole};
use rusqlite::{Connection, Transaction, params};
use unoclp_journal::Failure;

pub(super) fn thin(file: &mut Connection, now: i64, keep: i64) -> Result<bool, Failure> {
    let all = file.transaction()?;
    let (samples_before, minutes_before) = before(now, keep);
    let is_old = "SELECT EXISTS (SELECT * FROM recent WHERE at < ?)";
    if all.query_row(is_old, [samples_before], |row| row.get(0))? {
        sort_in(&all)?;
    }
    let more = of_samples(&all, samples_before)? | of_minutes(&all, minutes_before)?;
    all.commit()?;
    Ok(more)
}

fn of_samples(all: &Transaction<'_>, before: i64) -> Result<bool, Failure> {
    let parts = parts(
        all,
        "SELECT id, at, value, value, value FROM point CROSS JOIN sample ON point = id
         WHERE at < ?1 ORDER BY id, at, seq LIMIT ?2",
        before,
    )?;
    let (whole, more) = whole(parts, MINUTE);
    for (point, row) in &whole {
        all.prepare_cached("DELETE FROM sample WHERE point = ? AND at >= ? AND at < ?")?
            .execute(params![point, row.at, row.at + MINUTE])?;
        put(all, *point, row, MINUTE)?;
    }
    Ok(more)
}

fn of_minutes(all: &Transaction<'_>, before: i64) -> Result<bool, Failure> {
    let parts = parts(
        all,
        "SELECT id, at, least, most, last FROM point CROSS JOIN thinned ON point = id
         WHERE at < ?1 AND width < 3600000 ORDER BY id, at LIMIT ?2",
        before,
    )?;
    let (whole, more) = whole(parts, HOUR);
    for (point, row) in &whole {
        all.prepare_cached(
            "DELETE FROM thinned WHERE point = ? AND at >= ? AND at < ? AND width < 3600000",
        )?
        .execute(params![point, row.at, row.at + HOUR])?;
        put(all, *point, row, HOUR)?;
    }
    Ok(more)
}

/// What is old, point by point: nobody looks through what is not.
fn parts(all: &Transaction<'_>, sql: &str, before: i64) -> Result<Vec<Part>, Failure> {
    let mut parts = all.prepare_cached(sql)?;
    let parts = parts.query_map([before, AT_ONCE], |row| {
        let of = Row {
            at: row.get(1)?,
            least: row.get(2)?,
            most: row.get(3)?,
            last: row.get(4)?,
        };
        Ok((row.get(0)?, of))
    })?;
    Ok(parts.collect::<Result<_, _>>()?)
}

/// Puts a row, in one with what stands there already.
fn put(all: &Transaction<'_>, point: i64, row: &Row, width: i64) -> Result<(), Failure> {
    all.prepare_cached(
        "INSERT INTO thinned VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT (point, at) DO UPDATE SET width = excluded.width,
            least = min(coalesce(least, excluded.least), coalesce(excluded.least, least)),
            most = max(coalesce(most, excluded.most), coalesce(excluded.most, most)), last = excluded.last",
    )?
    .execute(params![point, row.at, width, row.least, row.most, row.last])?;
    Ok(())
}
