//! A moment of a plant as a drawing (SVG), the same in the page, in a report and in the docs.
//!
//! - `brush`: what a symbol is drawn with; `picture`: the elements, as text and as what has changed
//! - `style`: colours and strokes, said once
//! - `layout`: where parts stand, and the panel
//! - the others: the symbols, by the groups of parts
//!
//! Owns how things look. Must not know what makes them move, nor who shows them.

mod brush;
pub(crate) mod electric;
pub(crate) mod fluid;
pub(crate) mod heat;
mod layout;
pub(crate) mod motion;
pub(crate) mod panel;
mod picture;
mod style;
pub(crate) mod traffic;
pub(crate) mod transport;

pub(crate) use brush::Brush;
pub use layout::{picture, symbol};
pub use picture::{Change, Picture};
