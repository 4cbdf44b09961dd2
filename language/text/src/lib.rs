//! What all languages share about texts, whatever they mean.
//!
//! - [`diagnostics`]: places in a text, what can be said about one, and in which order; `messages` is the table of it
//! - [`show()`]: diagnostics for a terminal
//! - [`scanner`]: a text byte by byte; [`comments`] and [`colour`]: what its parts are
//! - [`literal`] and [`decimal`]: what numbers and times are worth
//! - [`points`] and [`dialect`]: which points a board has, and how makers write them; [`moved`]: which take the place of others
//! - [`outline`]: what a text declares, and where
//! - [`near`]: slips of the hand; [`lacking()`]: how much a program is too long
//!
//! Owns what is told about texts, in both languages. Must not know types, trees, what a word does.

#![forbid(unsafe_code)]

pub mod colour;
pub mod comments;
pub mod decimal;
pub mod diagnostics;
pub mod dialect;
mod lacking;
pub mod literal;
mod messages;
pub mod moved;
pub mod near;
pub mod outline;
pub mod points;
pub mod scanner;
mod severity;
mod show;

pub use dialect::Dialect;
pub use lacking::lacking;
pub use show::show;
