//! Instruction List: from a text to the typed tree, in the standard's words and in those of the makers.
//!
//! The way of a text: `lexer` (bytes → words), `parser` (words → `ast`), `names` (what names mean), `check` (what each
//! line does, to the typed tree).
//!
//! - `operators`: what operators there are; [`words`]: how they say each instruction
//! - `tree`: points as the text names them; `temps`: those that it does not name
//! - `whole`: what is wrong with a text as a whole; `colours`; `declared`: what declarations say of points;
//!   `written`: how a text is written
//!
//! Owns what each word of Instruction List means. Must not know pins, files, clocks, screens. No text makes it panic.

#![forbid(unsafe_code)]

mod ast;
mod check;
mod colours;
mod declared;
mod lexer;
mod names;
mod operators;
mod parser;
mod temps;
mod tree;
mod whole;
pub mod words;
mod written;

pub use check::read;
pub use colours::{colours, outline};
pub use declared::{Declared, DeclaredPoint, declared};
pub use operators::{is_operator, vocabulary};
