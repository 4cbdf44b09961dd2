//! Structured Text (IEC 61131-3, B.3), SCL, and pieces of Instruction List that are written so: from a text to the typed tree.
//!
//! `lexer` (bytes → words, `token`; `comments` and `bounds` of literals), `typed::literal` (what they are worth), `parser` (words → `ast`;
//! `pieces` of a list too), `library` (blocks that others bring), `check` (names and types, by the builder that all typed
//! languages share). [`condition()`]: an expression alone, asked again and again. [`mod@parts`]: what stands where.
//!
//! Owns what each word of Structured Text means. Must not know other languages, instructions of a board, files. No text makes
//! it panic. What a chart does, `unoclp-chart` knows.

#![forbid(unsafe_code)]

mod ast;
mod bounds;
mod check;
mod comments;
mod condition;
mod lexer;
mod library;
mod parser;
pub mod parts;
pub mod pieces;
mod token;
mod words;

pub use check::{Checker, Of};
pub use condition::{Condition, Judge, condition, is_name};
pub use library::{brought, is_brought};
pub use token::Dialect;

use unoclp_text::colour::Colour;

use token::{Kind, Token};
use unoclp_core::Board;
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_text::outline::{Labels, Outline, norm};
use unoclp_tree::{Base, Standard, Tree};
use words::Keyword;

/// What has a meaning of its own in a chart, and is a name elsewhere.
const IN_CHARTS: [&str; 5] = ["STEP", "TRANSITION", "ACTION", "FROM", "PRIORITY"];

/// The words of a text, and what each is.
pub fn colours(text: &str, dialect: Dialect) -> Vec<(Span, Option<Colour>)> {
    let tokens = lexer::tokens(text, 0, dialect, &mut Found::default());
    let written = |token: &Token| text.get(token.span.range()).unwrap_or_default();
    let begins = |token: &Token| Keyword::of(written(token)) == Keyword::InitialStep;
    let is_chart = tokens.iter().any(begins);
    let colour = |token: &Token| match token.kind {
        Kind::Address => Some(Colour::Point),
        Kind::Number | Kind::Typed => Some(Colour::Number),
        Kind::Text | Kind::Wide => Some(Colour::Text),
        Kind::Word => {
            let word = written(token).to_ascii_uppercase();
            let is_word = is_word(&word) || is_chart && IN_CHARTS.contains(&&*word);
            is_word.then_some(Colour::Word)
        }
        _ => None,
    };
    tokens
        .iter()
        .map(|token| (token.span, colour(token)))
        .collect()
}

/// What a text declares, and where.
pub fn outline(text: &str, dialect: Dialect) -> Outline {
    norm(text, &colours(text, dialect), Labels::AreNot)
}

/// The keywords, those of a chart among them.
pub fn vocabulary() -> Vec<&'static str> {
    let keywords = Keyword::ALL.iter().map(|keyword| keyword.name());
    keywords.chain(IN_CHARTS).collect()
}

/// Whether this is a keyword, or a type of the standard, in upper case.
pub fn is_word(word: &str) -> bool {
    Keyword::of(word) != Keyword::None
        || Base::named(word).is_some()
        || Standard::named(word).is_some()
}

/// Whether a word has a meaning of its own in Structured Text.
pub fn is_keyword(word: &str) -> bool {
    words::Keyword::of(word) != words::Keyword::None
}

/// The tree of a text; none where something is wrong, which is told.
pub fn check(text: &str, dialect: Dialect, board: Board, found: &mut Found) -> Option<Tree> {
    let (file, trusted) = parser::parse(text, dialect, found);
    if let Some(open) = found.place_of(Code::StCommentOpen) {
        // It swallows the rest; what is missing there follows from it.
        found.keep(|d| d.code == Code::StCommentOpen && d.span == open);
        return None;
    }
    if let Some(stray) = found.place_of(Code::StStray) {
        // What a sign that means nothing stands for is not known, and what is told after it may follow from that.
        found.keep(|d| d.code == Code::StStray || d.span.start < stray.start);
        return None;
    }
    if !trusted {
        return None;
    }
    let missing = match dialect {
        Dialect::Iec => library::missing(&file),
        Dialect::Scl | Dialect::Il => String::new(),
    };
    if missing.is_empty() {
        return check::check(text, &file, board, found);
    }
    let whole = format!("{text}\n{missing}");
    let (file, _) = parser::parse(&whole, dialect, &mut Found::default());
    let mut tree = check::check(&whole, &file, board, found)?;
    for unit in &mut tree.units {
        if unit.at.start as usize > text.len() {
            unit.at = Span::default();
        }
    }
    Some(tree)
}
