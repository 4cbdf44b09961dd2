//! What the readers of the two small languages, InterSCL and LCE, share.
//!
//! - `rules`: the signs that a language says it has; `lexer`: bytes → words by them
//! - `cursor`: where a parser stands in the words, and what it tells is missing there
//!
//! Owns the way through the words of a text by the signs that a language has. Must not know a keyword or a rule of either
//! language.

#![forbid(unsafe_code)]

pub mod cursor;
mod lexer;
pub mod rules;

use cursor::Keywords;
use rules::{Rules, Sign, Token};
use unoclp_text::colour::{Colour, is_point};
use unoclp_text::diagnostics::{Found, Span};

/// The words of a text, and what each is.
pub fn colours<K: Keywords>(text: &str, rules: &Rules) -> Vec<(Span, Option<Colour>)> {
    let tokens = lexer::tokens(text, rules, &mut Found::default());
    let colour = |token: &Token| match token.sign {
        Sign::Address => Some(Colour::Point),
        Sign::Number => Some(Colour::Number),
        Sign::Text | Sign::Title => Some(Colour::Text),
        Sign::Word => {
            let word = text.get(token.span.range()).unwrap_or_default();
            let is_point = || rules.points && is_point(&word.to_ascii_uppercase());
            match K::of(word) == K::NONE {
                false => Some(Colour::Word),
                true => is_point().then_some(Colour::Point),
            }
        }
        _ => None,
    };
    tokens
        .iter()
        .map(|token| (token.span, colour(token)))
        .collect()
}
