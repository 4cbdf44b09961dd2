//! A moment of a plant as a drawing (SVG), the same in the page, in a report and in the docs.
//!
//! - `brush`: what a symbol is drawn with; `picture`: the elements, as text and as what has changed
//! - `style`: colours and strokes, said once
//! - `layout`: where parts stand, and the panel
//! - `symbols`: which symbol each kind has; the others: the symbols, by the groups of parts
//!
//! Owns how things look. Must not know what makes them move, nor who shows them.

mod brush;
mod electric;
mod fluid;
mod heat;
mod layout;
mod motion;
mod panel;
mod picture;
mod style;
mod symbols;
mod traffic;
mod transport;

pub use layout::{live, picture, symbol};
pub use picture::{Change, Live, Picture};
