//! The severity of a message.

/// Whether a text can be compiled all the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// There is no program.
    Error,
    /// There is one, but it may not be what was meant.
    Warning,
}
