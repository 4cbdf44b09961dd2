//! What the readers of the two small languages, InterSCL and LCE, share.
//!
//! - `lexer`: bytes → words, by the signs that a language says it has
//! - `cursor`: where a parser stands in the words, and what it tells is missing there
//!
//! It must not know a keyword or a rule of either language.

pub(crate) mod cursor;
pub(crate) mod lexer;
