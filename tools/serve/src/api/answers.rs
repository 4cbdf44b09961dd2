//! What is answered as JSON. `/api/openapi.json` is made of these types.

use serde::Serialize;
use std::collections::BTreeMap;
use utoipa::ToSchema;

/// Whether the boards are there.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Health {
    /// How many boards there are.
    pub boards: usize,
    /// How many of them answer.
    pub up: usize,
}

/// A board.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct BoardNow {
    /// What it is called.
    pub name: String,
    /// Whether it answers.
    pub up: bool,
    /// Why it does not, in the language of the gateway.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub why: Option<String>,
    /// What its points were when they were last read; null where that is not known any more.
    pub points: BTreeMap<String, Option<f64>>,
}

/// A point that the history has.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct PointOf {
    /// Its board.
    pub board: String,
    /// What it is called.
    pub point: String,
}

/// What a point was.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct PastOf {
    /// Its board.
    pub board: String,
    /// What it is called.
    pub point: String,
    /// In the order of time. A step in which nothing changed has no row: the point was what it was last.
    pub rows: Vec<PastRow>,
    /// There is more after the last row: ask on from its time.
    pub more: bool,
}

/// What a point was over a step, or from a change on.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct PastRow {
    /// Where it begins, ms since 1970.
    pub at: i64,
    /// The least value in it; null if the board was away throughout.
    pub least: Option<f64>,
    /// The most.
    pub most: Option<f64>,
    /// What it was at the end; null if the board was away then.
    pub last: Option<f64>,
}

/// Why there is no answer.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Wrong {
    /// One of `no history`, `no point`, `no time`, `no number`, `busy`, `failing`.
    pub why: &'static str,
}
