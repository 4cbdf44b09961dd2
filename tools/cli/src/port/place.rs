//! Which port a board is at.

use crate::messages;
use std::fmt;
use unoclp_client::Line;

/// Where a board is, and how it is spoken to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The serial port, `/dev/ttyACM0` or `COM3`.
    pub port: String,
    /// What is spoken there.
    pub line: Line,
}

impl fmt::Display for Place {
    /// `/dev/ttyACM0, address 1`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&messages::place(&self.port, self.line.address))
    }
}
