//! A document with its cursor and what was copied.

use super::clip::Clip;
use super::cursor::Cursor;
use super::document::{Document, Id};
use std::sync::Arc;

/// What operations work on: a document, where its cursor is, and what was copied. Copies share what they have in common.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct State {
    /// The document.
    pub document: Document,
    /// What is selected.
    pub cursor: Cursor,
    /// What was copied last.
    pub clip: Option<Arc<Clip>>,
}

impl State {
    /// A document with the cursor at its first rung; one without rungs gets one.
    pub fn new(mut document: Document) -> State {
        if document.rungs.is_empty() {
            document.insert_empty(0);
        }
        let cursor = Cursor::at(document.rungs.first().map_or(Id(0), |rung| rung.id));
        State {
            document,
            cursor,
            clip: None,
        }
    }
}
