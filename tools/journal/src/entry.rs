//! What a point was from a moment on, and its number.

/// What a point was from a moment on, until its next sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// The moment: ms since 1970, by the clock of the PC.
    pub at: i64,
    /// The value; none while it is not known.
    pub value: Option<f64>,
}

/// A sample that is on disk.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Its number: 1 for the first of a journal, one more for each that follows. No clock changes the order.
    pub number: u64,
    /// What the point was.
    pub sample: Sample,
}
