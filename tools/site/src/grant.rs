//! The right to write a point.

use crate::points::{Kind, Place};
use unoclp_client::diagnostics::Kept;

/// A point that may be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grant {
    /// The unit of its board.
    pub unit: u8,
    /// Board and point, as the file names them.
    pub name: String,
    /// The name of the point, as its board has it.
    pub point: String,
    /// How the words of its value are made.
    pub kind: Kind,
    /// The addresses.
    pub places: Vec<Place>,
    /// It is so only while the board keeps this program; none: whichever it keeps.
    pub while_kept: Option<Kept>,
}
