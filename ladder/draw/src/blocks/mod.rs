//! A rung as a block diagram: series is AND, parallel is OR, boxes are boxes.
//!
//! - `graph`: which blocks there are and what leads to each; `place`: in which column and row each stands; `text`: drawn in
//!   characters
//!
//! Both looks show the same elements and the same nets, so what is live, selected or wrong is so in both. Power on a wire is
//! acc there, as in a ladder; a contact becomes a value at the left, which shows its point.

mod graph;
#[cfg(test)]
mod meaning;
mod place;
mod text;

pub(crate) use graph::{Graph, Kind, Vertex};
pub(crate) use place::Placed;
pub(crate) use text::picture;

/// How a rung looks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Look {
    /// Contacts and coils between rails.
    #[default]
    Ladder,
    /// Blocks with wires between them.
    Blocks,
}
