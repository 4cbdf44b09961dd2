//! What happened at a site: when alarms came and went, and who did what to a board. In a file of SQLite that only grows.
//!
//! - [`Happening`], [`Deed`]: a row of the one, and of the other; [`Row`]: either
//! - `file`: one file; `files`: the one that grows and the one before it, within a bound
//! - [`Asked`]: what is asked of them; [`csv_of_alarms`], [`csv_of_deeds`]: the same for a spreadsheet
//! - [`Record`]: they are open: a thread commits what comes, at once
//!
//! Owns the form of the files, how large they get, and that nothing in one is changed or removed. Must not know what an alarm means, who may do
//! what, nor who asks.

#![forbid(unsafe_code)]

mod csv;
mod file;
mod files;
mod record;
mod row;

pub use csv::{csv_of_alarms, csv_of_deeds};
pub use record::{Record, State, Tell};
pub use row::{Asked, Deed, Happening, Row};
pub use unoclp_journal::{Failure, now};
