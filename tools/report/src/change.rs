//! What a point is from a moment on.

/// What a point is from a moment on.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// The moment: ms since 1970, by the clock of this PC.
    pub at: i64,
    /// The value; none where it is not known any more.
    pub value: Option<f64>,
}
