//! Where a line of a program file comes from.

use crate::diagnostics::Span;

/// What of the text a line of the program file comes from.
#[derive(Default)]
pub(crate) struct Origin {
    pub span: Span,
    /// What the text calls the point of the instruction.
    pub name: Option<String>,
}
