//! The colours of a text in Instruction List.
//!
//! Owns where Instruction List has its operators. Must not know colours.

use crate::lexer::{self, Kind, SECTIONS};
use crate::operators;
use unoclp_text::colour::{Colour, is_point};
use unoclp_text::diagnostics::Found;
use unoclp_text::outline::{self, Labels, Outline};
use unoclp_tree::Painted;

/// What a text declares, and where.
pub fn outline(text: &str) -> Outline {
    outline::norm(text, &colours(text), Labels::Are)
}

/// The words of a text, and what each is.
pub fn colours(text: &str) -> Painted {
    let words = lexer::words(text, &mut Found::default());
    let mut declares = false;
    let mut begins = true;
    let tokens = words.tokens.iter();
    let painted = tokens.map(|token| {
        let written = text.get(token.span.range()).unwrap_or_default();
        let word = written.to_ascii_uppercase();
        let first = begins;
        begins = matches!(token.kind, Kind::NewLine | Kind::Colon);
        if SECTIONS.contains(&word.as_str()) {
            declares = true;
        } else if word == "END_VAR" {
            declares = false;
        }
        let colour = match token.kind {
            Kind::Number | Kind::Literal => Some(Colour::Number),
            Kind::Name if first && !declares && operators::find(&word).is_some() => {
                Some(Colour::Word)
            }
            Kind::Name if unoclp_st::is_word(&word) => Some(Colour::Word),
            Kind::Name => is_point(&word).then_some(Colour::Point),
            _ => None,
        };
        (token.span, colour)
    });
    painted.collect()
}
