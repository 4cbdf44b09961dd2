//! What every compiler gives, and every view of a program takes.
//!
//! - [`Checked`]: a checked program that owns its memory
//! - [`SourceMap`]: where each of its steps stands in the text that it was written in
//! - [`numeric`]: both of a file in numeric code, which needs no compiler
//!
//! It owns what compilers and views share, so that neither must know the other. It knows no other language, no
//! diagram, no file system and no screen.

#![forbid(unsafe_code)]

mod map;
mod numeric;
mod program;

pub use map::{Place, SourceMap};
pub use numeric::{Diagnosis, numeric};
pub use program::Checked;
