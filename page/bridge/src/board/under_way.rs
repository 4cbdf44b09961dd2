//! A scan of the core that is under way.
//!
//! Owns what it has come to. Must not know who goes on with it.

use unoclp_core::{Inputs, Scan};
use unoclp_exercise::live::Flow;

/// A scan that is under way.
pub struct Slow {
    pub(super) scan: Scan,
    pub(super) flow: Flow,
    pub(super) inputs: Inputs,
    /// Of each instruction whether it only begins a rung: it is no element.
    pub(super) heads: Vec<bool>,
    /// The outputs as the scan before has left them.
    pub(super) driven: u32,
}

impl Slow {
    /// Whether it stops before the instruction that comes next.
    pub(super) fn stops(&self, to: Option<&[usize]>) -> bool {
        let next = self.scan.next();
        match to {
            Some(to) => to.contains(&next),
            None => !self.heads.get(next).copied().unwrap_or_default(),
        }
    }
}
