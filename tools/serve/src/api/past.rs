//! What points were, asked over HTTP.
//!
//! Owns what may be asked, how much at a time, and how many ask at once. Must not know where it is kept.

use super::answers::{PastOf, PastRow, PointOf};
use serde::Deserialize;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Semaphore;
use unoclp_history::{Failure, Query, Row};
use unoclp_record::now;
use unoclp_site::duration;

/// As many ask at once; others are told to come again.
const AT_ONCE: usize = 4;
/// Rows of an answer, unless it is said how many; and at most.
pub(super) const ROWS: usize = 10_000;
pub(super) const MOST: usize = 100_000;
/// How far back, unless it is said.
const LAST: Duration = Duration::from_secs(3_600);

/// What points were, wherever it is kept.
pub trait Past: Send + Sync {
    /// All points: board and name.
    ///
    /// # Errors
    /// Where it cannot be read at present.
    fn points(&self) -> Result<Vec<(String, String)>, Failure>;
    /// The rows of a query.
    ///
    /// # Errors
    /// Where it cannot be read at present.
    fn rows(&self, query: &Query) -> Result<Vec<Row>, Failure>;
}

/// What is asked.
#[derive(Debug, Deserialize)]
pub(crate) struct Asked {
    board: String,
    point: String,
    from: Option<String>,
    to: Option<String>,
    last: Option<String>,
    step: Option<String>,
    most: Option<String>,
}

/// Why there is no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum No {
    History,
    Point,
    Time,
    Number,
    Value,
    Alarm,
    Record,
    Role,
    Acknowledged,
    Panel,
    Held,
    Controlled,
    Program,
    Away,
    Busy,
    Failing,
}

impl No {
    /// As it is told. These words are those of `docs/site.md`.
    pub fn word(self) -> &'static str {
        match self {
            No::History => "no history",
            No::Point => "no point",
            No::Time => "no time",
            No::Number => "no number",
            No::Value => "no value",
            No::Alarm => "no alarm",
            No::Record => "no record",
            No::Role => "not allowed",
            No::Acknowledged => "nothing to acknowledge",
            No::Panel => "not on a panel",
            No::Held => "not held",
            No::Controlled => "controlled",
            No::Program => "other program",
            No::Away => "away",
            No::Busy => "busy",
            No::Failing => "failing",
        }
    }
}

/// The way to what points were.
#[derive(Clone)]
pub(crate) struct Archive {
    past: Option<Arc<dyn Past>>,
    free: Arc<Semaphore>,
}

impl Archive {
    pub fn new(past: Option<Arc<dyn Past>>) -> Archive {
        Archive {
            past,
            free: Arc::new(Semaphore::new(AT_ONCE)),
        }
    }

    /// All points that there is something of.
    pub async fn points(&self) -> Result<Vec<PointOf>, No> {
        let points = self.ask(|past| past.points()).await?;
        let point = |(board, point)| PointOf { board, point };
        Ok(points.into_iter().map(point).collect())
    }

    /// What a point was.
    pub async fn rows(&self, asked: Asked) -> Result<PastOf, No> {
        let query = asked.query(now())?;
        let Asked { board, point, .. } = asked;
        let of = (board.clone(), point.clone());
        let most = query.most;
        let asked_for = Query {
            // One more says whether there is more.
            most: most + 1,
            ..query
        };
        let rows = self.ask(move |past| {
            let rows = past.rows(&asked_for)?;
            let is_known = !rows.is_empty() || past.points()?.contains(&of);
            Ok((rows, is_known))
        });
        let (rows, is_known) = rows.await?;
        if !is_known {
            return Err(No::Point);
        }
        let more = rows.len() > most;
        let row = |row: Row| PastRow {
            at: row.at,
            least: row.least,
            most: row.most,
            last: row.last,
        };
        Ok(PastOf {
            board,
            point,
            rows: rows.into_iter().take(most).map(row).collect(),
            more,
        })
    }

    async fn ask<T: Send + 'static>(
        &self,
        ask: impl FnOnce(&dyn Past) -> Result<T, Failure> + Send + 'static,
    ) -> Result<T, No> {
        let past = self.past.clone().ok_or(No::History)?;
        self.when_free(move || ask(&*past)).await
    }

    /// Reads from a disk, if not too many do.
    pub async fn when_free<T: Send + 'static>(
        &self,
        ask: impl FnOnce() -> Result<T, Failure> + Send + 'static,
    ) -> Result<T, No> {
        let free = self.free.clone().try_acquire_owned();
        let free = free.map_err(|_| No::Busy)?;
        let asked = tokio::task::spawn_blocking(move || {
            let _free = free;
            ask()
        });
        let answer = asked.await.map_err(|_| No::Failing)?;
        answer.map_err(|_| No::Failing)
    }
}

impl Asked {
    fn query(&self, now: i64) -> Result<Query, No> {
        let moment = |text: &Option<String>| match text {
            Some(text) => text.parse::<i64>().map(Some).map_err(|_| No::Time),
            None => Ok(None),
        };
        let time = |text: &Option<String>| match text {
            Some(text) => duration(text).map(Some).ok_or(No::Time),
            None => Ok(None),
        };
        let to = moment(&self.to)?.unwrap_or(i64::MAX);
        let last = time(&self.last)?.unwrap_or(LAST);
        let from = moment(&self.from)?.unwrap_or_else(|| now.min(to).saturating_sub(ms(last)));
        let most = match &self.most {
            Some(text) => text.parse().map_err(|_| No::Number)?,
            None => ROWS,
        };
        match (1..=MOST).contains(&most) {
            false => Err(No::Number),
            true => Ok(Query {
                board: self.board.clone(),
                point: self.point.clone(),
                from,
                to,
                step: time(&self.step)?.map_or(0, ms),
                most,
            }),
        }
    }
}

pub(super) fn ms(time: Duration) -> i64 {
    i64::try_from(time.as_millis()).unwrap_or(i64::MAX)
}
