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
    /// What it does: `RUN`, `STOP`, `FAULT`, as it was told last.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub doing: Option<&'static str>,
    /// The number of its fault.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub fault: Option<u16>,
    /// The line of the fault.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub line: Option<u32>,
    /// Whether points of it are forced.
    pub forced: bool,
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

/// How an alarm stands.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct AlarmNow {
    /// What it is called.
    pub name: String,
    /// `normal`, `active`, `acknowledged`, `gone`.
    pub state: &'static str,
    /// `low`, `medium`, `high`.
    pub severity: &'static str,
    /// What is said of it.
    pub text: Texts,
    /// The boards whose points its condition reads.
    pub boards: Vec<String>,
    /// Since when it stands so, ms since 1970; null where that was always so.
    pub since: Option<i64>,
    /// Who has acknowledged it last.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub who: Option<String>,
}

/// The same in both languages.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub(crate) struct Texts {
    /// In English.
    pub en: String,
    /// In Portuguese.
    pub pt: String,
}

/// What became of an alarm.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct AlarmPast {
    /// When, ms since 1970.
    pub at: i64,
    /// Which.
    pub alarm: String,
    /// `came`, `gone`, `acknowledged`.
    pub change: String,
    /// How it stood from then on.
    pub state: String,
    /// Who has acknowledged it, if that is it.
    pub who: Option<String>,
}

/// What was done.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct DeedOf {
    /// When, ms since 1970.
    pub at: i64,
    /// By whom: a user; `$local` on this PC, `$control` with a token, `$modbus`, `$mqtt`.
    pub who: String,
    /// From which address.
    pub from: Option<String>,
    /// To which board, or alarm.
    pub of: String,
    /// What: `run`, `stop`, `single scan`, `restart`, `force`, `write`, `release`, `settings`, `upload`, `acknowledge`.
    pub what: String,
    /// Where, and with which values.
    pub detail: String,
}

/// Who asks, and what this one may do.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Asker {
    /// A user; `$local` on this PC, `$watch` or `$control` with a token.
    pub name: String,
    /// `watch`, `operate`, `engineer`.
    pub may: &'static str,
}

/// A point of a board by name.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub(crate) struct NameOf {
    /// Its board.
    pub board: String,
    /// What it is called.
    pub point: String,
    /// It is 0 or 1.
    pub bit: bool,
    /// A board takes values for it.
    pub writes: bool,
}

/// A panel.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub(crate) struct PanelOf {
    /// What it is called.
    pub name: String,
    /// What stands above it.
    pub title: Texts,
    /// Columns of its grid.
    pub columns: u8,
    /// A drawing in SVG above the grid.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub drawing: Option<String>,
    /// What is on the grid.
    pub items: Vec<ItemOf>,
    /// What moves in the drawing.
    pub binds: Vec<BindOf>,
    /// It is made of a board's names, and of no file.
    pub made: bool,
}

/// Something on a panel.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub(crate) struct ItemOf {
    /// `lamp`, `value`, `bar`, `trend`, `button`, `switch`, `set`.
    pub show: &'static str,
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// What stands beside it.
    pub label: Texts,
    /// The unit of the value.
    pub unit: String,
    /// The least value.
    pub least: f64,
    /// The most.
    pub most: f64,
    /// Column and row, from 1; without it the next free place.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub at: Option<[u8; 2]>,
    /// How many columns and rows it takes.
    pub size: [u8; 2],
}

/// What a point does to an element of a drawing.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub(crate) struct BindOf {
    /// The `id` of the element.
    pub id: String,
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// `show`, `light`, `text`, `level`, `turn`.
    pub does: &'static str,
    /// The value that is nothing.
    pub least: f64,
    /// The value that is all of it.
    pub most: f64,
}

/// A value that a board has taken.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Taken {
    /// The value.
    pub value: f64,
}

/// How an alarm stands once it is acknowledged.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Done {
    /// `acknowledged`, or `normal` where its condition holds no more.
    pub state: &'static str,
}

/// Why there is no answer.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Wrong {
    /// One of `no history`, `no point`, `no time`, `no number`, `no value`, `no alarm`, `no record`, `not allowed`,
    /// `nothing to acknowledge`, `not on a panel`, `not held`, `controlled`, `other program`, `away`, `busy`, `failing`.
    pub why: &'static str,
}
