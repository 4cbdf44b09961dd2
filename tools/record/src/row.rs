//! A row of the file, and what is asked of it.

/// A row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Row {
    /// An alarm has changed.
    Alarm(Happening),
    /// A user or client has acted.
    Deed(Deed),
}

/// A change of an alarm.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Happening {
    /// The moment: ms since 1970, by the clock of the PC.
    pub at: i64,
    /// The alarm.
    pub alarm: String,
    /// The change: `came`, `gone`, `acknowledged`.
    pub change: String,
    /// Its state from then on.
    pub state: String,
    /// Who did it, if somebody did.
    pub who: Option<String>,
}

/// An action of a user or client.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Deed {
    /// The moment: ms since 1970, by the clock of the PC.
    pub at: i64,
    /// Who: a user, or by which way.
    pub who: String,
    /// The address that it came from, where it came over a network.
    pub from: Option<String>,
    /// The board, or the alarm.
    pub of: String,
    /// What: `run`, `stop`, `force`, `write` …
    pub what: String,
    /// With which values.
    pub detail: String,
}

/// Which rows are asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Asked {
    /// From this moment on, ms since 1970,
    pub from: i64,
    /// and until before this one.
    pub to: i64,
    /// At most this many, the latest.
    pub most: usize,
}
