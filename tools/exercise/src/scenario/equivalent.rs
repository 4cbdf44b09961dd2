//! A change that makes no wrong program, as somebody has written it down.
//!
//! Owns its form. Must not know how changes are made.

use super::Both;
use serde::Deserialize;

/// A change of the model solution that leaves it right, and why.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Equivalent {
    /// The line of Instruction List as it was, with single spaces.
    pub was: String,
    /// And as it is then; empty where it is gone.
    pub is: String,
    /// Why that does the same.
    pub why: Both,
}
