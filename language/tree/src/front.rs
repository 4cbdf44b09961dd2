//! What a language is to all who take texts.

use crate::Tree;
use unoclp_core::Board;
use unoclp_text::colour::Colour;
use unoclp_text::diagnostics::{Found, Span};

/// The words of a text in the order of their places, and what each is.
pub type Painted = Vec<(Span, Option<Colour>)>;

/// A typed language: all that commands, pages and tests ask of it.
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
    /// The tree of a text for a board; none where something is wrong, which is told.
    pub tree: fn(text: &str, board: Board, found: &mut Found) -> Option<Tree>,
}
