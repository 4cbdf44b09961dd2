//! The languages: Instruction List to the numeric code and back, the typed languages to the typed tree.
//!
//! The way of a text in Instruction List through this crate: `lexer` (bytes → words), `parser` (words → syntax
//! tree), `names` and `points` (what names mean), `il` (what each line does on the machine of `list`, from whose run on
//! expressions the typed tree is made). [`to_il`] and [`to_st()`] go the other way.
//!
//! The way of a text in a typed language ([`check`]): `st` (Structured Text), `iscl` (InterSCL) and `lce` (LCE), the last
//! two on `small` (bytes → words → syntax tree → names and types), [`typed`]
//! (the tree that all of them come to, Instruction List too), [`run`] (the interpreter on the PC), `code` (from the tree to
//! instructions), `emit` (lines of a program file, checked as the board checks them), `places` and `comments` (where its
//! steps stand in the text). What can be wrong with a text is said
//! once, in `messages`.
//!
//! Owns the languages, what can be wrong with a text, and the words for it. Must not know pins, files, clocks, screens. No
//! text makes it panic.

#![forbid(unsafe_code)]

mod adapt;
mod ast;
mod back;
mod code;
mod colour;
mod colours;
mod comments;
mod compile;
mod condition;
mod decimal;
mod declared;
mod diagnostics;
mod dialect;
mod emit;
mod given;
mod il;
mod iscl;
mod lacking;
mod languages;
mod lce;
mod lexer;
mod list;
mod literal;
mod messages;
mod names;
mod operators;
mod origin;
mod parser;
mod places;
mod points;
pub mod run;
mod scanner;
mod severity;
mod show;
mod small;
mod spell;
mod st;
mod temps;
mod to_st;
mod tree;
pub mod typed;
mod whole;
mod words;

pub use adapt::{Adapted, adapt, adapt_at, written_points};
pub use back::{instructions_to_il, to_il};
pub use code::{CompiledText, Held, Holding, Shows, Trace, Variable, literal};
pub use colour::Colour;
pub use colours::{colours, colours_of_list};
pub use compile::{Compiled, Options, compile, compile_text};
pub use condition::{Condition, Judge, condition, is_name};
pub use declared::{Declared, DeclaredPoint, declared};
pub use diagnostics::{Code, Diagnostic, Lang, Lines, Severity, Span, Told, Word};
pub use dialect::Dialect;
pub use emit::CodeLine;
pub use given::given;
pub use lacking::lacking;
pub use languages::{CheckedText, TextLanguage, check};
pub use literal::duration;
pub use operators::is_operator;
pub use points::{no_such_point, point};
pub use show::show;
pub use to_st::to_st;
