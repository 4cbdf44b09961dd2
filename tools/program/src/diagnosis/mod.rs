//! The faults of a program file, each shown in its source line.

mod help;
mod portuguese;
mod show;

pub use help::no_real;
pub use portuguese::portuguese;
pub use show::{Problem, cause, show, tell};
