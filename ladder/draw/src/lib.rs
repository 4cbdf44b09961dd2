//! From a checked program to a ladder diagram: as text, live in a terminal, and as vector graphics.
//!
//! The way of a program through this crate: `symbols` says what each instruction looks like; `build` makes a
//! tree of each rung's elements; `fork` and `stores` arrange it, `energise` gives every wire its net; `wrap`
//! breaks what is too wide; `layout` makes cells of it. Text, terminals and SVG all show those cells. `blocks` makes a
//! block diagram of the same tree, for SVG and in characters.
//!
//! Owns the ladder diagram of a program and its block diagram, their pictures, and the editor that draws one. Must not know files, terminals, texts.
//!
//! # Rules
//!
//! Numeric code is one accumulator, acc, and a stack (NC-6, NC-8); a ladder diagram is wires. Power on a wire is
//! acc there, so:
//!
//! - **Contacts and comparisons** stand in series. A load right before a comparison is drawn with it:
//!   `[ A0 >= 500 ]`. Where the source of the value is not known, it is called `V`.
//! - **`40` … `41`** is a path beside all that its rung, or the branch around it, holds so far; with a recall,
//!   beside what follows the stored point. Paths of one beginning and one end are one join, however they
//!   were nested.
//! - **`6540` … `41`** is its contents in series. Where they look at what stands before them – an edge, a NOT, a
//!   timer, a recalled point – the two results meet in a box, `[ AND ]`, the second from below. **`8840` …
//!   `41`** always is such a box, `[ XOR ]`.
//! - **A path that begins where no wire leads without crossing another** begins by name: at `•1`, a point of the same
//!   name, or at a left rail of its own, `├`. `•1.2` is point 01 as the rung has stored it the second time.
//!   A point at which nothing begins is named too, so that nothing is lost.
//! - **NOT, edges and `XI`** stand in series and act on all that stands before them in their path.
//! - **Coils, jumps and returns** leave acc as it is. One that is not the last of its rung gets a branch of its
//!   own, one below the other at the right rail; but between other elements of a path it stands in series.
//!   Paths that end a rung and all end in outputs do not come together again.
//! - **A timer** is its box, and after it the coil that it drives, which is the same step. In a picture timers and counters
//!   are boxes with pins: `IN`, `PT`, `Q`, `ET`; `CU` or `CD`, `PV`, `Q`, `CV`. In characters they are `[ TON T1 5000 ms ]`.
//! - **Functions** of numbers stand in series, as boxes in the order in which they are done.
//! - **A rung that is too wide** goes on in another line: `→a`, `a→`. Ends of the same name join.
//!
//! Each step of a program is shown exactly once: as a symbol, as a joint of wires, or at the head of its rung. The
//! power of a wire is found from acc after the steps of a scan ([`Nets::power`]); it flows to the right, and up
//! and down, never back.

#![forbid(unsafe_code)]

mod block;
mod blocks;
mod build;
mod drawing;
pub mod edit;
mod element;
mod energise;
mod face;
mod fork;
mod ladder;
mod layout;
mod listing;
mod pins;
mod power;
mod stores;
mod style;
mod svg_page;
mod symbols;
mod tree;
mod value;
mod words;
mod wrap;

pub use block::Cell;
pub use blocks::Look;
pub use drawing::{Drawing, Picture};
pub use element::{Element, Symbol};
pub use ladder::{Ladder, Rung};
pub use listing::{Title, listing, listing_of_blocks};
pub use pins::time;
pub use power::{Net, Nets, Power};
pub use style::{Medium, NARROWEST, Style};
pub use svg_page::{
    Area, Paper, Report, to_blocks, to_picture, to_report, to_screen, to_svg, to_svg_of_blocks,
};
pub use words::picture;

use std::collections::BTreeMap;
use unoclp_point::Address;

/// What the points of a program are called; those without a name are shown by number alone.
pub type Names = BTreeMap<Address, String>;
