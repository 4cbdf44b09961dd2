//! Operations: each from a document to a document, or a reason why not.
//!
//! Owns that a chart stays one in which steps and transitions alternate. What it means, nobody here asks.
//!
//! - `operation`: what can be done, and why not; `insert`: steps, transitions, branches, actions; `remove`: what goes with what is removed
//! - `alter`: names, conditions, qualifiers, the ends of transitions; `words`: names within conditions and bodies

mod alter;
mod insert;
mod operation;
mod remove;
mod words;

pub use operation::{Operation, Refusal, Side};

use crate::document::Document;
use crate::sheet::Id;

/// A document after an operation, and what is selected then.
pub type Done = Result<(Document, Id), Refusal>;

impl Document {
    /// The document after an operation.
    ///
    /// # Errors
    /// Why nothing is done.
    pub fn after(&self, operation: &Operation) -> Done {
        let mut document = self.clone();
        let id = document.apply(operation)?;
        // What is written has to be read as it is meant, whatever a person has put in a field.
        let text = document.text();
        let read = Document::all(&text);
        let own = read.iter().find(|read| read.unit == document.unit);
        match own.is_some_and(|own| own.says_as(&document)) {
            true => Ok((document, id)),
            false => Err(Refusal::NotOnePart),
        }
    }

    fn apply(&mut self, operation: &Operation) -> Result<Id, Refusal> {
        match operation {
            Operation::StepAfter(id) => self.step_after(*id),
            Operation::StepBefore(id) => self.step_before(*id),
            Operation::Branch(id) => self.branch(*id),
            Operation::Beside(id) => self.beside(*id),
            Operation::Jump(id, to) => self.jump(*id, to),
            Operation::Act(id) => self.act(*id),
            Operation::Remove(id) => self.remove(*id),
            Operation::Move(id, side) => self.moved(*id, *side),
            Operation::Rename(id, name) => self.rename(*id, name),
            Operation::Condition(id, condition) => self.condition(*id, condition),
            Operation::Lead(id, to) => self.lead(*id, to),
            Operation::Priority(id, priority) => self.priority(*id, *priority),
            Operation::Initial(id) => self.initial(*id),
            Operation::Does(id, action, qualifier, time) => {
                self.does(*id, action, *qualifier, time.as_deref())
            }
            Operation::Body(action, body) => self.body(action, body),
        }
    }

    /// Whether both are the same chart, part by part, as far as it is read.
    fn says_as(&self, other: &Document) -> bool {
        let steps = self.steps.iter().zip(&other.steps);
        let mut steps = steps.map(|(a, b)| a.name == b.name && a.does == b.does);
        let transitions = self.transitions.iter().zip(&other.transitions);
        let mut transitions = transitions.map(|(a, b)| {
            a.from == b.from && a.to == b.to && a.condition.trim() == b.condition.trim()
        });
        let actions = self.actions.iter().zip(&other.actions);
        let mut actions = actions.map(|(a, b)| a.name == b.name);
        let counts = |of: &Document| (of.steps.len(), of.transitions.len(), of.actions.len());
        counts(self) == counts(other)
            && steps.all(|same| same)
            && transitions.all(|same| same)
            && actions.all(|same| same)
    }
}
