//! What a plant asks of whoever controls it.

use crate::text::Text;
use unoclp_lang::Condition;

/// What must never be.
#[derive(Debug)]
pub struct Never {
    /// What it says.
    pub text: Text,
    /// What must not hold.
    pub when: Condition,
    /// It may hold before this time, ms.
    pub after: u64,
    /// It may hold for so long, ms.
    pub lasts: u64,
}

/// What must come to be.
#[derive(Debug)]
pub struct Goal {
    /// What it says.
    pub text: Text,
    /// What must come to hold.
    pub when: Condition,
    /// Each time that this begins to hold; none: once, from the start.
    pub each: Option<Condition>,
    /// In this time, ms.
    pub within: u64,
}
