//! What the points of a site were, kept in a file of SQLite or in PostgreSQL.
//!
//! - [`Store`]: a history, wherever it is kept; `sqlite`: in a file; `postgres`: in a database
//! - [`Query`], [`Row`]: what is asked of it, and what it gives; [`csv`]: the same for a spreadsheet
//! - [`Database`]: where a history is, and how it is opened
//! - [`Keeper`]: a thread that takes from the journal what the history does not have yet
//! - [`move_all`]: from a file to a database
//!
//! Owns the form of the history, how long what stands in it, and in which order; that it takes each entry of a journal
//! once. Must not know boards, networks beyond its database's, nor how a value was read.

#![forbid(unsafe_code)]

mod address;
mod csv;
mod database;
mod keeper;
mod moved;
mod postgres;
mod query;
mod sqlite;
mod store;
mod thinned;

pub use address::{Address, Trust};
pub use csv::csv;
pub use database::Database;
pub use keeper::{Keeper, State};
pub use moved::{Moved, NotMoved, move_all};
pub use postgres::Postgres;
pub use query::{Query, Row};
pub use sqlite::Sqlite;
pub use store::Store;
pub use unoclp_journal::{Failure, Sample};
