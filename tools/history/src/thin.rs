//! What is left of samples that are old: a row for each minute, and later for each hour.

use crate::query::Row;
use crate::store::{Failure, Store};
use rusqlite::{Transaction, params};

const MINUTE: i64 = 60_000;
const HOUR: i64 = 3_600_000;
/// So many times as long as samples are kept, minutes are.
const MINUTES_KEPT: i64 = 4;
/// As many rows as are thinned in one go: nobody waits long for it.
const AT_ONCE: i64 = 20_000;

impl Store {
    /// Puts a row for each minute in place of samples that are older than `keep` ms at the moment `now`, and one for each
    /// hour in place of minutes that are four times as old. Says whether there is more to do.
    ///
    /// # Errors
    /// [`Failure`]; then nothing has changed.
    pub fn thin(&mut self, now: i64, keep: i64) -> Result<bool, Failure> {
        let all = self.file.transaction()?;
        // Whole minutes and hours alone, so that none is thinned twice.
        let samples_before = (now - keep).div_euclid(MINUTE) * MINUTE;
        let minutes_before = (now - MINUTES_KEPT * keep).div_euclid(HOUR) * HOUR;
        let more = of_samples(&all, samples_before)? | of_minutes(&all, minutes_before)?;
        all.commit()?;
        Ok(more)
    }
}

/// What is thinned: a point, and a row of it.
type Part = (i64, Row);

fn of_samples(all: &Transaction<'_>, before: i64) -> Result<bool, Failure> {
    let parts = parts(
        all,
        "SELECT point, at, value, value, value FROM sample WHERE at < ?1 ORDER BY point, at, seq LIMIT ?2",
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
        "SELECT point, at, least, most, last FROM thinned WHERE at < ?1 AND width < 3600000 ORDER BY point, at LIMIT ?2",
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

/// One row for each width of each point. Where there is more than goes at once, the last one may lack its end and is left
/// out, unless it is all there is.
fn whole(parts: Vec<Part>, width: i64) -> (Vec<Part>, bool) {
    let more = parts.len() as i64 == AT_ONCE;
    let mut whole: Vec<Part> = Vec::new();
    for (point, row) in parts {
        let at = row.at.div_euclid(width) * width;
        match whole.last_mut() {
            Some((of, last)) if *of == point && last.at == at => last.extend(&row),
            _ => whole.push((point, Row { at, ..row })),
        }
    }
    if more && whole.len() > 1 {
        whole.pop();
    }
    (whole, more)
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
