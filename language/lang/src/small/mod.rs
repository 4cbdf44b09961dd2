//! What the readers of the two small languages, InterSCL and LCE, share.
//!
//! - `rules`: the signs that a language says it has; `lexer`: bytes → words by them
//! - `cursor`: where a parser stands in the words, and what it tells is missing there
//!
//! It must not know a keyword or a rule of either language.

pub(crate) mod cursor;
mod lexer;
pub(crate) mod rules;

use crate::colour::{Colour, is_point};
use crate::diagnostics::{Found, Span};
use cursor::Keywords;
use rules::{Rules, Sign, Token};

/// The words of a text, and what each is.
pub(crate) fn colours<K: Keywords>(text: &str, rules: &Rules) -> Vec<(Span, Option<Colour>)> {
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
