//! Why something that was ordered of a board is not done.

use crate::words::{self, Both, No, both};
use unoclp_client::Failure;

/// Why something was not done.
pub(super) enum Undone {
    /// It is told; the board is still there.
    Told(Both),
    /// The board is lost.
    Lost(Failure),
}

impl From<Failure> for Undone {
    fn from(failure: Failure) -> Undone {
        match failure {
            Failure::Refused(_) => Undone::Told(both(|lang| words::failure(lang, &failure))),
            failure => Undone::Lost(failure),
        }
    }
}

impl From<Both> for Undone {
    fn from(told: Both) -> Undone {
        Undone::Told(told)
    }
}

impl From<No> for Undone {
    fn from(no: No) -> Undone {
        Undone::Told(no.into())
    }
}
