//! What the points of a site were, on disk until each who takes it has it: the history, the broker.
//!
//! - [`Sample`]: what a point was from a moment on; [`Entry`]: the same with its number
//! - [`File`]: the file: entries in order, and how far each reader is
//! - [`Journal`]: a thread that commits what comes; [`Reader`]: one who takes it
//! - [`point`]: the number of a point in a file of SQLite
//! - [`Failure`]: why a file cannot be used; [`now`], [`moment`]: the moment, and one in words
//!
//! Owns the numbers of samples, when they are on disk, how much waits there, and what is dropped. Must not know boards,
//! networks, nor what a reader does with an entry.

#![forbid(unsafe_code)]

mod bound;
mod entry;
mod failure;
mod file;
mod journal;
mod moment;
mod points;
mod readers;
mod shared;
mod writer;

pub use entry::{Entry, Sample};
pub use failure::Failure;
pub use file::{File, Place};
pub use journal::{Journal, Reader};
pub use moment::{moment, now};
pub use points::point;
pub use shared::{Policy, State, Tell};
