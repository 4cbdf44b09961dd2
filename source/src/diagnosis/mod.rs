//! The faults of a program file, each shown in its source line.

mod help;
mod show;

pub use show::show;
