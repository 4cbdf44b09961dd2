//! A ladder editor without a screen.
//!
//! It owns documents: what a person draws, complete or not, and each step from one document to the next. It must not
//! know files, screens, forms of exchange such as JSON, nor any language of people: what it refuses and what is wrong
//! has a name, and others put it into words.
//!
//! `document` is what is edited; `read` makes one of codes, `emit` and `check` make codes of one again; `draw` hands it
//! to the drawing. `operation` says what can be done, `apply` does it, and `history` can take it back.

mod apply;
mod check;
mod clip;
mod cursor;
mod document;
mod draft;
mod draw;
mod emit;
mod grid;
mod history;
mod made;
mod operation;
mod places;
mod read;
mod refusal;
mod shown;
mod state;
mod step;
mod table;
mod timers;
mod which;

pub use apply::apply;
pub use check::{Mistake, Wrong};
pub use clip::Clip;
pub use cursor::Cursor;
pub use document::{
    Begin, Block, Document, Element, Gate, Id, Node, Parallel, Path, Rung, Series, Store, visit,
};
pub use draft::Draft;
pub use draw::Drawn;
pub use emit::Emitted;
pub use history::Editor;
pub use operation::{Along, Direction, Edge, Operation, Place, Way};
pub use places::{Canvas, Opening, RungDrawing, Spot, Strip};
pub use refusal::Refusal;
pub use state::State;
pub use step::Step;
pub use table::{Row, Table};
pub use which::Coil;
