//! The same drawing as vector graphics: on paper, for a report, or on a screen that shows it live.
//!
//! - `picture`: one picture of the whole; `report`: pages of paper
//! - `blocks`: a rung as a block diagram
//! - `screen`: a drawing that shows power; `sheet`: a rung that is edited
//! - `node`: an element of SVG; `named`: what a symbol is known by; `page`: what they are all drawn on; `symbol`: the elements; `wires`: what leads to them

mod area;
mod blocks;
mod named;
mod node;
mod page;
mod picture;
mod report;
mod screen;
mod sheet;
mod symbol;
mod wires;

pub use area::Area;
pub use picture::{to_picture, to_svg, to_svg_of_blocks};
pub use report::{Paper, Report, to_report};
pub use screen::{to_blocks, to_screen};
pub(crate) use sheet::{Labels, OnSheet, Shape, tops};

/// A column of the drawing, in units of the page.
const COLUMN: f32 = 9.0;
/// A row with a wire: symbols, and what they are called above them.
const WIRE_ROW: f32 = 40.0;
/// A row with text alone.
const TEXT_ROW: f32 = 17.0;
/// A line of a heading.
const HEADING: f32 = 17.0;
/// Between rungs.
const GAP: f32 = 22.0;
/// Around all.
const MARGIN: f32 = 24.0;
/// The wire's distance from the upper edge of its row.
/// At a half, so that a line of three pixels covers them whole.
const AXIS: f32 = 26.5;
/// The height of the symbols, from the wire up and down.
const HALF: f32 = 9.0;
/// The width of wires on paper, and of what is drawn as they are.
const WIRE: f32 = 1.8;
/// The width of contacts, coils and boxes.
const SYMBOL: f32 = 2.2;
/// The width of rails on paper.
const RAIL: f32 = 3.4;
/// Millimetres of a unit: 80 columns go on a page of A4 with its margins.
const MILLIMETRES: f32 = 0.225;

/// The left edge of a column.
fn x(column: f32) -> f32 {
    MARGIN + column * COLUMN
}
