//! Undo and redo without end.

use super::apply::apply;
use super::cursor::Cursor;
use super::document::Document;
use super::operation::Operation;
use super::refusal::Refusal;
use super::state::State;

/// A document that is being edited, with all that it has been.
#[derive(Clone, Debug)]
pub struct Editor {
    state: State,
    /// The documents before, the last one last.
    past: Vec<(Document, Cursor)>,
    /// Those that were undone, the next one last.
    future: Vec<(Document, Cursor)>,
}

impl Editor {
    /// An editor of this document.
    pub fn new(document: Document) -> Editor {
        Editor {
            state: State::new(document),
            past: Vec::new(),
            future: Vec::new(),
        }
    }

    /// The document, its cursor and what was copied.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// The document.
    pub fn document(&self) -> &Document {
        &self.state.document
    }

    /// What is selected.
    pub fn cursor(&self) -> Cursor {
        self.state.cursor
    }

    /// Makes an operation. One that changes the document can be undone, and nothing that was undone before it can be
    /// done again.
    ///
    /// # Errors
    /// Why it is refused; then nothing has changed.
    pub fn apply(&mut self, operation: &Operation) -> Result<(), Refusal> {
        self.apply_all(std::slice::from_ref(operation))
    }

    /// Makes operations, one after another, as one change.
    ///
    /// # Errors
    /// Why one of them is refused; then nothing has changed.
    pub fn apply_all(&mut self, operations: &[Operation]) -> Result<(), Refusal> {
        let mut next = self.state.clone();
        for operation in operations {
            next = apply(&next, operation)?;
        }
        self.go_on_as(next);
        Ok(())
    }

    /// Puts another document in the place of this one, as a change that can be undone. What was copied stays.
    pub fn replace(&mut self, document: Document) {
        let clip = self.state.clip.clone();
        let next = State::new(document);
        self.go_on_as(State { clip, ..next });
    }

    fn go_on_as(&mut self, next: State) {
        let before = std::mem::replace(&mut self.state, next);
        if before.document != self.state.document {
            self.past.push((before.document, before.cursor));
            self.future.clear();
        }
    }

    /// Takes back the last change.
    ///
    /// # Errors
    /// [`Refusal::NothingToUndo`]
    pub fn undo(&mut self) -> Result<(), Refusal> {
        let before = self.past.pop().ok_or(Refusal::NothingToUndo)?;
        let now = self.go(before);
        self.future.push(now);
        Ok(())
    }

    /// Makes again the change that was taken back last.
    ///
    /// # Errors
    /// [`Refusal::NothingToRedo`]
    pub fn redo(&mut self) -> Result<(), Refusal> {
        let next = self.future.pop().ok_or(Refusal::NothingToRedo)?;
        let now = self.go(next);
        self.past.push(now);
        Ok(())
    }

    /// How many changes can be taken back, and made again.
    pub fn depth(&self) -> (usize, usize) {
        (self.past.len(), self.future.len())
    }

    fn go(&mut self, (document, cursor): (Document, Cursor)) -> (Document, Cursor) {
        let document = std::mem::replace(&mut self.state.document, document);
        (document, std::mem::replace(&mut self.state.cursor, cursor))
    }
}
