//! A machine to control: a plant is read from a file, checked, stepped a millisecond at a time, judged by its rules and drawn.
//!
//! - [`read`]: from the text of a file to a [`Plant`], or to all its [`Mistake`]s
//! - [`Run`]: a plant in motion: outputs in, inputs out, 1 ms a step, whole numbers only, seeded
//! - [`Verdict`]: which rules broke when, and which goals were met
//! - [`KINDS`]: every kind of part: what the reader, the checks and the pages are made from
//! - [`picture`]: a moment of it as a drawing; [`live`]: what changes of that
//!
//! The way of a file: `keys` (values with their places), `read`, `fields` (what a part is given), `order` (what needs
//! what), `rules`, `sentence` (a rule in words). `kind` is the form of the table; `parts/` are its rows, by groups, each with what it does in a
//! `moment`; `draw/` their symbols.
//!
//! Owns machines. Must not know a PLC, a program, a board at a line, a file, a clock, a screen, a page.

#![forbid(unsafe_code)]

mod draw;
mod fields;
mod guide;
mod keys;
mod kind;
mod mistake;
mod moment;
mod names;
mod order;
mod outputs;
mod parts;
mod plant;
mod read;
mod rules;
mod run;
mod sentence;
mod signal;
mod text;
mod unit;
mod verdict;
mod words;

pub use draw::{Change, Live, Picture, live, picture, symbol};
pub use guide::guide;
pub use kind::{Fault, Field, Form, Group, Kind, Limit, Slot};
pub use mistake::{Mistake, Wrong};
pub use outputs::Outputs;
pub use parts::KINDS;
pub use plant::{Decoration, Part, Plant, Step, Trouble};
pub use read::{MOST_PARTS, read};
pub use rules::{Goal, Never};
pub use run::Run;
pub use text::Text;
pub use unit::Unit;
pub use verdict::{Broken, Missed, Verdict};
