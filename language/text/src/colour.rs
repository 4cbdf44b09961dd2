//! What a part of a text is, for an editor that colours it.
//!
//! Owns which parts there are to tell apart. Must not know where a word ends: the lexers say so. What a lexer passes
//! over between two words is a comment, or means nothing.

use crate::diagnostics::Span;
use unoclp_point::{Maker, read};

/// What a part of a text is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// A comment, with what begins and ends it.
    Comment,
    /// A text in quotation marks, or the title of a network.
    Text,
    /// An input, output, marker or other point, by its address.
    Point,
    /// A number or time.
    Number,
    /// An operator of Instruction List, a keyword, or a type.
    Word,
}

/// Whether this is the address of a point, in upper case.
pub fn is_point(word: &str) -> bool {
    let word: String = word.chars().filter(|c| !c.is_whitespace()).collect();
    read(&word, Maker::Iec).is_some()
}

/// How a comment begins, in one language or another.
const COMMENTS: [&str; 5] = ["(*", "//", "/*", ";", "{"];

/// Words with what they are, and the comments between them.
pub fn painted(
    text: &str,
    words: impl IntoIterator<Item = (Span, Option<Colour>)>,
) -> Vec<(Span, Colour)> {
    let mut parts = Vec::new();
    let mut behind = 0;
    for (span, colour) in words {
        let gap = text.get(behind..span.start as usize).unwrap_or_default();
        let begins = COMMENTS.iter().filter_map(|sign| gap.find(sign)).min();
        if let Some(begins) = begins {
            let comment = Span {
                start: (behind + begins) as u32,
                end: (behind + gap.trim_end().len()) as u32,
            };
            parts.push((comment, Colour::Comment));
        }
        if let Some(colour) = colour.filter(|_| span.start < span.end) {
            parts.push((span, colour));
        }
        behind = behind.max(span.end as usize);
    }
    parts
}
