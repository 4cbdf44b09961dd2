//! A ladder editor without a screen.
//!
//! It owns documents: what a person draws, complete or not, and each step from one document to the next. It must not
//! know files, screens, forms of exchange such as JSON, nor any language of people: what it refuses and what is wrong
//! has a name, and others put it into words.
//!
//! `document` is what is edited; `read` makes one of codes, `emit` and `check` make codes of one again; `draw` hands it
//! to the drawing.

mod check;
mod document;
mod draw;
mod emit;
mod read;
mod shown;
mod step;
mod table;

pub use check::{Mistake, Wrong};
pub use document::{
    Begin, Block, Document, Element, Gate, Id, Node, Parallel, Path, Rung, Series, Store, visit,
};
pub use draw::Drawn;
pub use step::Step;
pub use table::{Row, Table};
