//! The colours of a program as a person has written it.
//!
//! Owns those of numeric code; of a text the lexer of its language says them.

use unoclp_lang::{Colour, Span};

/// The codes and comments of a file in numeric code.
pub(crate) fn numeric(text: &str) -> Vec<(Span, Colour)> {
    let mut parts = Vec::new();
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let (codes, comment) = line.split_at(line.find('/').unwrap_or(line.len()));
        for (from, part, colour) in [
            (at, codes, Colour::Number),
            (at + codes.len(), comment, Colour::Comment),
        ] {
            let start = from + part.len() - part.trim_start().len();
            let end = start + part.trim().len();
            if start < end {
                let [start, end] = [start, end].map(|at| at as u32);
                parts.push((Span { start, end }, colour));
            }
        }
        at += line.len();
    }
    parts
}
