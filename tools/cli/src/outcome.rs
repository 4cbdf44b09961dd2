//! The outcome of a command.

/// Whether what the command was asked about is well.
pub type Outcome = anyhow::Result<bool>;
