//! What a server says, as a reason.

use ::postgres::Error;
use ::postgres::error::SqlState;
use std::error::Error as _;
use unoclp_journal::Failure;

/// Why a statement was not carried out.
pub(crate) fn failure(error: Error) -> Failure {
    if let Some(told) = error.as_db_error() {
        return match *told.code() {
            SqlState::DISK_FULL => Failure::Full,
            SqlState::READ_ONLY_SQL_TRANSACTION => Failure::ReadOnly,
            _ => Failure::Other(told.message().to_owned()),
        };
    }
    match error.source() {
        Some(why) => Failure::Other(why.to_string()),
        None => Failure::Other(error.to_string()),
    }
}
