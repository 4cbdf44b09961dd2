//! What the readers of the two small languages, InterSCL and LCE, share.
//!
//! - `rules`: the signs that a language says it has; `lexer`: bytes → words by them
//! - `cursor`: where a parser stands in the words, and what it tells is missing there
//!
//! It must not know a keyword or a rule of either language.

pub(crate) mod cursor;
mod lexer;
pub(crate) mod rules;
