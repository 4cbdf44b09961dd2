//! Puts one row in place of many that are old.

use super::failure::failure;
use crate::query::Row;
use crate::thinned::{AT_ONCE, HOUR, MINUTE, Part, before, whole};
use ::postgres::{Client, Transaction};
use unoclp_journal::Failure;

/// Of several gateways with one database, one thins at a time: `unct`.
const LOCK: i64 = 0x756e_6374;

pub(super) fn thin(client: &mut Client, now: i64, keep: i64) -> Result<bool, Failure> {
    let mut all = client.transaction().map_err(failure)?;
    let lock = all.query_one("SELECT pg_try_advisory_xact_lock($1)", &[&LOCK]);
    if !lock.map_err(failure)?.get::<_, bool>(0) {
        return Ok(false);
    }
    let (samples_before, minutes_before) = before(now, keep);
    let more = of_samples(&mut all, samples_before)? | of_minutes(&mut all, minutes_before)?;
    all.commit().map_err(failure)?;
    Ok(more)
}

fn of_samples(all: &mut Transaction<'_>, before: i64) -> Result<bool, Failure> {
    let sql = "SELECT point, at, value, value, value FROM unoclp.sample WHERE at < $1 ORDER BY point, at, seq LIMIT $2";
    let (whole, more) = whole(parts(all, sql, before)?, MINUTE);
    let sql = "DELETE FROM unoclp.sample USING unnest($1::int[], $2::bigint[]) AS old (p, a)
        WHERE point = p AND at >= a AND at < a + 60000";
    put(all, sql, &whole, MINUTE)?;
    Ok(more)
}

fn of_minutes(all: &mut Transaction<'_>, before: i64) -> Result<bool, Failure> {
    let sql =
        "SELECT point, at, least, most, last FROM unoclp.thinned WHERE at < $1 AND width < 3600000
        ORDER BY point, at LIMIT $2";
    let (whole, more) = whole(parts(all, sql, before)?, HOUR);
    let sql = "DELETE FROM unoclp.thinned USING unnest($1::int[], $2::bigint[]) AS old (p, a)
        WHERE point = p AND at >= a AND at < a + 3600000 AND width < 3600000";
    put(all, sql, &whole, HOUR)?;
    Ok(more)
}

fn parts(all: &mut Transaction<'_>, sql: &str, before: i64) -> Result<Vec<Part>, Failure> {
    let parts = all.query(sql, &[&before, &AT_ONCE]).map_err(failure)?;
    let part = |row: &::postgres::Row| {
        let of = Row {
            at: row.get(1),
            least: row.get(2),
            most: row.get(3),
            last: row.get(4),
        };
        (i64::from(row.get::<_, i32>(0)), of)
    };
    Ok(parts.iter().map(part).collect())
}

/// Takes away what stands in these places by this statement, and puts rows there, in one with what stands there still.
fn put(all: &mut Transaction<'_>, sql: &str, whole: &[Part], width: i64) -> Result<(), Failure> {
    let points: Vec<i32> = whole.iter().map(|(point, _)| *point as i32).collect();
    let rows = || whole.iter().map(|(_, row)| row);
    let moments: Vec<i64> = rows().map(|row| row.at).collect();
    all.execute(sql, &[&points, &moments]).map_err(failure)?;
    let least: Vec<Option<f64>> = rows().map(|row| row.least).collect();
    let most: Vec<Option<f64>> = rows().map(|row| row.most).collect();
    let last: Vec<Option<f64>> = rows().map(|row| row.last).collect();
    all.execute(
        "INSERT INTO unoclp.thinned AS old (point, at, width, least, most, last)
            SELECT p, a, $6, l, m, e
            FROM unnest($1::int[], $2::bigint[], $3::float8[], $4::float8[], $5::float8[]) AS new (p, a, l, m, e)
         ON CONFLICT (point, at) DO UPDATE SET width = excluded.width, least = least(old.least, excluded.least),
            most = greatest(old.most, excluded.most), last = excluded.last",
        &[&points, &moments, &least, &most, &last, &width],
    )
    .map(drop)
    .map_err(failure)
}
