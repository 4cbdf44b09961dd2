//! InterSCL, a small SCL for teaching: from a text to the typed tree.
//!
//! `words` (its signs and keywords), `parser` (words → `ast`), `check` (names and types, by the builder that all
//! typed languages share). It knows no board and no files, and no text makes it panic.

mod ast;
mod check;
mod expression;
mod operands;
mod parser;
mod recovery;
mod statement;
mod words;

use crate::colour::Colour;
use crate::diagnostics::{Code, Found, Span};
use crate::small;
use crate::typed::Tree;
use unoclp_core::Board;
use words::{RULES, Word};

/// The words of a text, and what each is.
pub(crate) fn colours(text: &str) -> Vec<(Span, Option<Colour>)> {
    small::colours::<Word>(text, &RULES)
}

/// The tree of a text; none where something is wrong, which is told.
pub(crate) fn check(text: &str, board: Board, found: &mut Found) -> Option<Tree> {
    let program = parser::parse(text, found);
    if let Some(open) = found.place_of(Code::StCommentOpen) {
        // It swallows the rest; what is missing there follows from it.
        found.keep(|d| d.code == Code::StCommentOpen && d.span == open);
        return None;
    }
    check::check(text, &program?, board, found)
}
