//! A checked program with its memory: what every compiler gives, what a PC runs, what every view of it takes.
//!
//! - [`Checked`]: a checked program that owns its memory
//! - [`SourceMap`]: where each of its steps stands in the text that it was written in
//! - [`numeric`]: both of a file in numeric code, which needs no compiler
//! - [`Work`]: how often this thread compiles, checks and draws
//!
//! Owns what compilers, views and the simulated PLC share, so that none must know another. Must not know a language but
//! numeric code, a diagram, a file system, a screen.

#![forbid(unsafe_code)]

mod map;
mod numeric;
mod program;
mod work;

pub use map::{Place, SourceMap};
pub use numeric::{Diagnosis, numeric};
pub use program::Checked;
pub use work::Work;
