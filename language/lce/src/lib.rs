//! LCE, the language of SimuPLC: from a text to the typed tree.
//!
//! `words` (its signs and keywords), `parser` (words → `ast`), `check` (what names stand for, and as what each value
//! is taken, on what `checker` holds).
//!
//! Owns what each word of LCE means. Must not know other languages, boards' instructions, files. No text makes it panic.

#![forbid(unsafe_code)]

mod ast;
mod check;
mod checker;
mod coils;
mod command;
mod expression;
mod kinds;
mod outline;
mod parser;
mod slots;
mod values;
mod var;
mod words;

use unoclp_core::Board;
use unoclp_small::cursor::Keywords;
use unoclp_text::colour::Colour;
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_text::outline::Outline;
use unoclp_tree::Tree;
use words::{RULES, Word};

/// The words of a text, and what each is.
pub fn colours(text: &str) -> Vec<(Span, Option<Colour>)> {
    unoclp_small::colours::<Word>(text, &RULES)
}

/// What a text declares, and where.
pub fn outline(text: &str) -> Outline {
    outline::outline(text, &colours(text))
}

/// The keywords.
pub fn vocabulary() -> Vec<&'static str> {
    Word::WORDS.iter().map(|(word, _)| *word).collect()
}

/// The tree of a text; none, with a message, where something is wrong.
pub fn check(text: &str, board: Board, found: &mut Found) -> Option<Tree> {
    let program = parser::parse(text, board, found);
    if let Some(open) = found.place_of(Code::StCommentOpen) {
        // It swallows the rest; what is missing there follows from it.
        found.keep(|d| d.code == Code::StCommentOpen && d.span == open);
        return None;
    }
    check::check(text, &program?, board, found)
}
