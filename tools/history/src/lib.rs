//! What the points of a site were, kept in a file of SQLite.
//!
//! - [`Sample`]: what a point was from a moment on
//! - [`Store`]: the file
//! - [`Query`], [`Row`]: what is asked of it, and what it gives; [`csv`]: the same for a spreadsheet
//! - [`Keeper`]: a thread that writes, and what waits where the file takes nothing
//!
//! Owns the form of the file, how long what stands in it, and in which order. Must not know boards, networks, nor how a
//! value was read.

#![forbid(unsafe_code)]

mod csv;
mod keeper;
mod query;
mod sample;
mod store;
mod thin;

pub use csv::csv;
pub use keeper::{Keeper, State};
pub use query::{Query, Row};
pub use sample::Sample;
pub use store::{Failure, Store};
