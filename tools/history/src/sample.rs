//! What a point was from a moment on.

/// What a point was from a moment on, until its next sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// The moment: ms since 1970, by the clock of the PC.
    pub at: i64,
    /// The value; none while the board is away.
    pub value: Option<f64>,
}
