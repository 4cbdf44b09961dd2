//! What has come of a unit, and where the builder is in the text.
//!
//! Owns the order of the steps, held by types: a unit is declared, its declarations end, and then it gets its body, once.

/// A unit whose variables are being declared.
#[derive(Debug)]
#[must_use = "its declarations end by `Builder::close`"]
pub struct Declaring(pub(super) u32);

/// A unit whose variables are declared, and which has no body yet.
#[derive(Debug)]
#[must_use = "it gets its statements by `Builder::body`"]
pub struct Closed(pub(super) u32);

/// A unit that somebody may be in.
pub trait Enter {
    /// Its number in the tree.
    fn number(&self) -> u32;
}

impl Enter for Declaring {
    fn number(&self) -> u32 {
        self.0
    }
}

impl Enter for Closed {
    fn number(&self) -> u32 {
        self.0
    }
}

/// Where the builder was before it went into a unit, or out of all of them.
#[derive(Debug)]
#[must_use = "the builder goes back there by `Builder::back`"]
pub struct Before(pub(super) Option<usize>);
