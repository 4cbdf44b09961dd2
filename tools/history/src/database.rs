//! Where a history is, and how it is opened.

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

/// A database of PostgreSQL.
#[derive(Clone)]
pub struct Address {
    /// The server's name or address.
    pub host: String,
    /// Its port.
    pub port: u16,
    /// As whom we come.
    pub user: String,
    /// The database.
    pub database: String,
    /// The user's password, if it has one.
    pub password: Option<String>,
    /// Whom an encrypted connection trusts; none: it is not encrypted.
    pub tls: Option<Trust>,
}

/// Whom an encrypted connection trusts.
#[derive(Clone, Debug, Default)]
pub struct Trust {
    /// The authority that has signed the server's certificate, in PEM; none: those that the system trusts.
    pub ca: Option<Vec<u8>>,
}

impl std::fmt::Debug for Address {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Address {
            host,
            port,
            user,
            database,
            ..
        } = self;
        write!(f, "postgres://{user}@{host}:{port}/{database}")
    }
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
