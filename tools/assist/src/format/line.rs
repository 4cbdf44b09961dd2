//! A line of a text that is formed.

use crate::reader::Word;

/// A line of a text.
pub(crate) struct Line<'r, 't> {
    /// As it is written.
    pub text: &'t str,
    /// The words that begin in it.
    pub words: &'r [Word<'t>],
    /// Its first byte.
    pub start: usize,
    /// Whether it begins within a comment, so that it stays as it is.
    pub is_within: bool,
}
