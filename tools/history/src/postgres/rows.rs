//! What is asked of a database.

use super::failure::failure;
use crate::query::{Answer, Query, Row};
use ::postgres::Client;
use ::postgres::fallible_iterator::FallibleIterator;
use ::postgres::types::ToSql;
use unoclp_journal::Failure;

pub(super) fn rows(client: &mut Client, query: &Query) -> Result<Vec<Row>, Failure> {
    let sql = "SELECT id FROM unoclp.point WHERE board = $1 AND name = $2";
    let id = client
        .query_opt(sql, &[&query.board, &query.point])
        .map_err(failure)?;
    let Some(point) = id.map(|row| row.get::<_, i32>(0)) else {
        return Ok(Vec::new());
    };
    let mut answer = Answer::new(query, before(client, point, query.from)?);
    let parameters: [&(dyn ToSql + Sync); 3] = [&point, &query.from, &query.to];
    // As they come, so that many need no room.
    let mut found = client
        .query_raw(
            "SELECT at, least, most, last, 0::bigint AS seq FROM unoclp.thinned WHERE point = $1 AND at >= $2 AND at < $3
             UNION ALL
             SELECT at, value, value, value, seq FROM unoclp.sample WHERE point = $1 AND at >= $2 AND at < $3
             ORDER BY at, seq",
            parameters,
        )
        .map_err(failure)?;
    while let Some(row) = found.next().map_err(failure)? {
        let is_wanted = answer.take(Row {
            at: row.get(0),
            least: row.get(1),
            most: row.get(2),
            last: row.get(3),
        });
        if !is_wanted {
            break;
        }
    }
    Ok(answer.rows())
}

/// What a point was just before this moment; none where that is not known.
fn before(client: &mut Client, point: i32, at: i64) -> Result<Option<Option<f64>>, Failure> {
    let sql = "SELECT last FROM (
            (SELECT at, last, 0::bigint AS seq FROM unoclp.thinned WHERE point = $1 AND at < $2 ORDER BY at DESC LIMIT 1)
            UNION ALL
            (SELECT at, value, seq FROM unoclp.sample WHERE point = $1 AND at < $2 ORDER BY at DESC, seq DESC LIMIT 1)
         ) AS found ORDER BY at DESC, seq DESC LIMIT 1";
    let last = client.query_opt(sql, &[&point, &at]).map_err(failure)?;
    Ok(last.map(|row| row.get(0)))
}
