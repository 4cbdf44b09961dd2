//! Why a file cannot be used.

use rusqlite::ErrorCode;

/// Why a file, or a database, cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// It is something else.
    Foreign,
    /// Another version has written it.
    Version(i64),
    /// The disk is full.
    Full,
    /// It may only be read.
    ReadOnly,
    /// Another process holds it.
    Busy,
    /// What SQLite, or the database, says.
    Other(String),
}

impl From<rusqlite::Error> for Failure {
    fn from(error: rusqlite::Error) -> Failure {
        match error.sqlite_error_code() {
            Some(ErrorCode::DiskFull) => Failure::Full,
            Some(ErrorCode::ReadOnly) => Failure::ReadOnly,
            Some(ErrorCode::NotADatabase) => Failure::Foreign,
            Some(ErrorCode::DatabaseBusy | ErrorCode::DatabaseLocked) => Failure::Busy,
            _ => Failure::Other(error.to_string()),
        }
    }
}
