//! What an editor is offered and told.

mod forms;
mod names;
mod remedies;
mod texts;
