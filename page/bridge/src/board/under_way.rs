//! A scan of the core that is under way.
//!
//! Owns what it has come to. Must not know who goes on with it.

use unoclp_exercise::live::Followed;

/// A scan that is under way.
pub struct Slow {
    pub(super) followed: Followed,
    /// Of each instruction whether it only begins a rung: it is no element.
    pub(super) heads: Vec<bool>,
    /// The outputs as the scan before has left them.
    pub(super) driven: u32,
}
