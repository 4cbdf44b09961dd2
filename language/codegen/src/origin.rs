//! Where a line of a program file comes from.

use unoclp_text::diagnostics::Span;

/// What of the text a line of the program file comes from.
#[derive(Default)]
pub(crate) struct Origin {
    /// The part of the text.
    pub span: Span,
    /// What the text calls the point of the instruction.
    pub name: Option<String>,
}
