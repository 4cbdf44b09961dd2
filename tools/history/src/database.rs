//! Where a history is, and how it is opened.

use crate::address::Address;
use crate::postgres::Postgres;
use crate::sqlite::Sqlite;
use crate::store::Store;
use std::path::PathBuf;
use unoclp_journal::Failure;

/// Where a history is.
#[derive(Clone, Debug)]
pub enum Database {
    /// In this file of SQLite.
    File(PathBuf),
    /// In this database of PostgreSQL.
    Server(Address),
}

impl Database {
    /// Opens it to write, and makes it where it is not there.
    ///
    /// # Errors
    /// [`Failure`]; what is there is then as it was.
    pub fn open(&self) -> Result<Box<dyn Store>, Failure> {
        Ok(match self {
            Database::File(path) => Box::new(Sqlite::open(path)?),
            Database::Server(address) => Box::new(Postgres::open(address)?),
        })
    }

    /// Opens it to read alone.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn read(&self) -> Result<Box<dyn Store>, Failure> {
        Ok(match self {
            Database::File(path) => Box::new(Sqlite::read(path)?),
            Database::Server(address) => Box::new(Postgres::read(address)?),
        })
    }
}
