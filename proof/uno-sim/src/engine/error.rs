//! What can go wrong on an engine.

use crate::{Error, Halt};

/// Why the board did not do its work.
#[derive(Debug, thiserror::Error)]
pub enum EngineError {
    /// The simulation could not be set up.
    #[error(transparent)]
    Setup(#[from] Error),
    /// The firmware went no further.
    #[error("{0}; the serial port said {1:?}")]
    Halt(Halt, String),
    /// The firmware lacks a symbol that a simulation stops at or writes to.
    #[error("the firmware has no symbol `{0}`; is it an unoclp firmware?")]
    NoSymbol(&'static str),
    /// The card image could not be made.
    #[error("no card image: {0}")]
    Image(#[from] std::io::Error),
    /// An output moved before the first scan or at a fault (NC-7).
    #[error("output {} moved though no program ran", .0 + 1)]
    OutputMoved(u8),
    /// The serial port did not say what it must.
    #[error("the serial port said {0:?}")]
    Serial(String),
    /// A scan was asked for without a program.
    #[error("no program has been loaded")]
    NoProgram,
}
