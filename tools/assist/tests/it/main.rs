//! What an editor is offered and told.

mod forms;
mod names;
mod projects;
mod remedies;
mod texts;
mod twins;
