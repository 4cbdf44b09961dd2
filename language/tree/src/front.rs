//! What a language is to all who take texts.

use crate::Tree;
use std::collections::HashSet;
use std::ops::Range;
use std::sync::Arc;
use unoclp_core::Board;
use unoclp_text::Dialect;
use unoclp_text::colour::Colour;
use unoclp_text::diagnostics::{Found, Span};
#[cfg(feature = "assist")]
use unoclp_text::outline::Outline;

/// The words of a text in the order of their places, and what each is.
pub type Painted = Vec<(Span, Option<Colour>)>;

/// The functions and function blocks of a text: where they stand, in that order, and what they are called.
pub type Units = Vec<(Range<u32>, Arc<str>)>;

/// A language: all that commands, pages and tests ask of it.
#[derive(Debug)]
pub struct FrontEnd {
    /// Its name on a command line, by which the names of its files end too: `st`.
    pub name: &'static str,
    /// What people call it, in English and in Portuguese.
    pub title: [&'static str; 2],
    /// Whether a text begins like one in it.
    pub begins: fn(text: &str) -> bool,
    /// The words of a text. What stands between two of them is a comment, or means nothing.
    pub colours: fn(text: &str) -> Painted,
    /// What a text declares, and where: of one with mistakes too.
    #[cfg(feature = "assist")]
    pub outline: fn(text: &str) -> Outline,
    /// The words that have a meaning of their own, as one writes them.
    #[cfg(feature = "assist")]
    pub vocabulary: fn() -> Vec<&'static str>,
    /// What a text means; what is wrong with it is told.
    pub read: fn(text: &str, options: &Options, found: &mut Found) -> Read,
}

/// How to read a text.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Whose words it is written in, in a language that makers write in their own; none: whose they look like.
    pub dialect: Option<Dialect>,
    /// What the program must fit.
    pub board: Board,
}

impl Options {
    /// For this board, in what its words look like.
    pub fn on(board: Board) -> Options {
        Options {
            dialect: None,
            board,
        }
    }
}

/// What has been read of a text.
#[derive(Debug)]
pub struct Read {
    /// What it means; none where something is wrong, which is told.
    pub tree: Option<Tree>,
    /// How it is written, where its signs do not say so.
    pub written: Option<Written>,
}

impl From<Option<Tree>> for Read {
    fn from(tree: Option<Tree>) -> Read {
        Read {
            tree,
            written: None,
        }
    }
}

/// How a text is written.
#[derive(Debug)]
pub struct Written {
    /// Where its comments are.
    pub comments: Vec<Span>,
    /// Where its functions and function blocks stand; none: where the tree has them.
    pub units: Option<Units>,
    /// Where its instructions begin. The comments above one that takes no step go to the step that follows.
    pub instructions: Vec<u32>,
    /// Whose words it is written in.
    pub dialect: Option<Dialect>,
    /// Where each IF begins that is drawn as one, in a text that says what the board has: rungs begin where it loads, and
    /// points are called as it writes them. None in all others.
    pub drawn: Option<HashSet<u32>>,
}
