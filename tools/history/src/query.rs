//! What is asked of the file, and what it gives.

use crate::store::{Failure, Store};
use rusqlite::{OptionalExtension, params};

/// What a point was, over a time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Query {
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// From this moment on, ms since 1970,
    pub from: i64,
    /// and until before this one.
    pub to: i64,
    /// One row for so many ms; 0: each change is one.
    pub step: i64,
    /// At most so many rows, the earliest.
    pub most: usize,
}

/// What a point was, over a step or from a change on.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Where it begins, ms since 1970.
    pub at: i64,
    /// The least value in it; none if the board was away throughout.
    pub least: Option<f64>,
    /// The most.
    pub most: Option<f64>,
    /// What it was at the end; none if the board was away then.
    pub last: Option<f64>,
}

impl Row {
    fn of(at: i64, value: Option<f64>) -> Row {
        Row {
            at,
            least: value,
            most: value,
            last: value,
        }
    }

    /// Takes in a later one.
    pub(crate) fn extend(&mut self, later: &Row) {
        self.least = with(self.least, later.least, f64::min);
        self.most = with(self.most, later.most, f64::max);
        self.last = later.last;
    }

    /// The same, as the first of what begins here.
    fn beginning(self, at: i64) -> Row {
        Row { at, ..self }
    }
}

fn with(one: Option<f64>, other: Option<f64>, choose: fn(f64, f64) -> f64) -> Option<f64> {
    match (one, other) {
        (Some(one), Some(other)) => Some(choose(one, other)),
        (one, other) => one.or(other),
    }
}

impl Store {
    /// The rows of a query, in the order of time. The first one begins at `from` with what the point was by then, if that is
    /// known. A step in which nothing has changed has no row.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn rows(&self, query: &Query) -> Result<Vec<Row>, Failure> {
        let Some(point) = self.id(&query.board, &query.point)? else {
            return Ok(Vec::new());
        };
        let mut rows: Vec<Row> = Vec::new();
        if let Some(value) = self.before(point, query.from)? {
            rows.push(Row::of(query.from, value));
        }
        let mut found = self.file.prepare_cached(
            "SELECT at, least, most, last, 0 AS seq FROM thinned WHERE point = ?1 AND at >= ?2 AND at < ?3
             UNION ALL SELECT at, value, value, value, seq FROM sample WHERE point = ?1 AND at >= ?2 AND at < ?3
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
            let row = row?;
            let at = match query.step {
                ..=0 => row.at,
                step => query.from + (row.at - query.from).div_euclid(step) * step,
            };
            let is_full = rows.len() == query.most;
            match rows
                .last_mut()
                .filter(|last| query.step > 0 && last.at == at)
            {
                Some(last) => last.extend(&row),
                None if is_full => break,
                None => rows.push(row.beginning(at)),
            }
        }
        Ok(rows)
    }

    fn id(&self, board: &str, point: &str) -> Result<Option<i64>, Failure> {
        let mut id = self
            .file
            .prepare_cached("SELECT id FROM point WHERE board = ? AND name = ?")?;
        Ok(id.query_row([board, point], |row| row.get(0)).optional()?)
    }

    /// What a point was just before this moment; none where that is not known.
    fn before(&self, point: i64, at: i64) -> Result<Option<Option<f64>>, Failure> {
        let mut last = self.file.prepare_cached(
            "SELECT last FROM (
                SELECT * FROM (SELECT at, last, 0 AS seq FROM thinned WHERE point = ?1 AND at < ?2 ORDER BY at DESC LIMIT 1)
                UNION ALL
                SELECT * FROM (SELECT at, value, seq FROM sample WHERE point = ?1 AND at < ?2 ORDER BY at DESC, seq DESC LIMIT 1)
             ) ORDER BY at DESC, seq DESC LIMIT 1",
        )?;
        let last = last.query_row([point, at], |row| row.get(0));
        Ok(last.optional()?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Sample;

    #[test]
    fn where_the_disk_is_full_nothing_is_written_by_half() {
        let folder = tempfile::tempdir().unwrap();
        let mut store = Store::open(&folder.path().join("h.db")).unwrap();
        let sample = |at| Sample {
            board: "b".into(),
            point: "p".into(),
            at,
            value: Some(1.0),
        };
        store.append(&[sample(0)]).unwrap();
        let pages: i64 = store
            .file
            .pragma_query_value(None, "page_count", |row| row.get(0))
            .unwrap();
        let limit = |store: &Store, pages: i64| {
            let set = format!("max_page_count({pages})");
            store
                .file
                .query_row(&format!("PRAGMA {set}"), [], |_| Ok(()))
                .unwrap();
        };
        limit(&store, pages);
        let many: Vec<Sample> = (1..10_000).map(sample).collect();
        assert!(matches!(store.append(&many), Err(Failure::Full)));
        let query = Query {
            board: "b".into(),
            point: "p".into(),
            from: 0,
            to: 20_000,
            step: 0,
            most: usize::MAX,
        };
        assert_eq!(store.rows(&query).unwrap().len(), 1);
        limit(&store, 10 * pages + 1_000);
        store.append(&many).unwrap();
        assert_eq!(store.rows(&query).unwrap().len(), 10_000);
    }
}
