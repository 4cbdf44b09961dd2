//! What is known of the document that a page has.

use unoclp_core::Board;
use unoclp_draw::Look;
use unoclp_draw::edit::{Document, Drawn, Mistake};
use unoclp_program::Lang;
use unoclp_program::drawn::Lost;
use unoclp_workspace::Version;

/// A document as a page has it.
pub struct Shown {
    pub document: Document,
    pub board: Board,
    /// What its file is called.
    pub name: String,
    pub drawn: Drawn,
    /// How a page has the drawing; none: it has not.
    pub drawn_as: Option<(usize, Look, Lang)>,
    /// Its text, and the version of that; none where it is not a program.
    pub text: Option<(Version, String)>,
    pub mistakes: Vec<Mistake>,
    /// What its text, as a person has written it, loses by a change.
    pub loses: Option<Lost>,
}

impl Shown {
    /// Whether it is of this document, for this board, in a file of this name.
    pub fn is_of(&self, document: &Document, board: Board, name: &str) -> bool {
        self.board == board && self.name == name && self.document == *document
    }
}
