//! Charts as diagrams.

mod drawn;
mod edited;
mod looks;
