//! What a line of a body is to the machine.

use crate::operators::Op;
use std::borrow::Cow;
use unoclp_text::diagnostics::Span;

/// What a line is to the machine.
pub(crate) enum Says<'l> {
    /// A label, by the name that jumps have for it.
    Label(Cow<'l, str>, Span),
    /// `)`
    Close(Span),
    /// What is wrong has been told; so many parentheses are lost with it.
    Wrong(usize),
    Does(Does<'l>),
}

/// An instruction.
pub(crate) struct Does<'l> {
    /// None of a function or a block by its name.
    pub op: Option<Op>,
    pub conditional: bool,
    /// The label that it may go to.
    pub label: Option<Cow<'l, str>>,
    /// How many results below the top of the stack it takes.
    pub pops: usize,
    /// The operator with its modifiers, and the whole line.
    pub span: Span,
    pub whole: Span,
}
