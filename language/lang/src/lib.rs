//! The languages: Instruction List to the numeric code and back, the typed languages to the typed tree.
//!
//! The way of a text in Instruction List through this crate: `lexer` (bytes → words), `parser` (words → syntax
//! tree), `names` (what names mean), `il` (what each line does on the machine of `list`, from whose run on
//! expressions the typed tree is made). [`to_il`] and [`to_st()`] go the other way.
//!
//! The way of a text in a typed language ([`check`]): `st` (Structured Text), `iscl` (InterSCL) and `lce` (LCE), the last
//! two on `small` (bytes → words → syntax tree → names and types), each to the tree of `unoclp-tree`, which
//! `unoclp-codegen` takes to a program. What can be wrong with a text, `unoclp-text` says.
//!
//! Owns the languages: what each word of them means. Must not know pins, files, clocks, screens, the instructions that a
//! tree comes to. No text makes it panic.

#![forbid(unsafe_code)]

mod adapt;
mod ast;
mod back;
mod colours;
mod compile;
mod condition;
mod declared;
mod il;
mod iscl;
mod languages;
mod lce;
mod lexer;
mod list;
mod moved;
mod names;
mod operators;
mod parser;
mod small;
mod spell;
mod st;
mod temps;
mod to_st;
mod tree;
mod whole;
mod words;

use unoclp_text::{colour, comments, diagnostics, dialect, literal, points, scanner};

pub use adapt::{adapt, written_points};
pub use back::{instructions_to_il, spelled, to_il};
pub use colour::Colour;
pub use colours::colours_of_list;
pub use compile::{Compiled, Options, compile, compile_text};
pub use condition::{Condition, Judge, condition, is_name};
pub use declared::{Declared, DeclaredPoint, declared};
pub use diagnostics::{Code, Diagnostic, Lang, Lines, Severity, Span, Told, Word};
pub use dialect::Dialect;
pub use languages::{CheckedText, TextLanguage, check, colours, register};
pub use literal::duration;
pub use moved::{Adapted, adapt_at};
pub use operators::is_operator;
pub use points::{no_such_point, point};
pub use st::{brought, is_brought};
pub use to_st::to_st;
pub use unoclp_codegen::{CodeLine, CompiledText, Held, Holding, Shows, Trace, Variable, literal};
pub use unoclp_text::{lacking, show};
pub use unoclp_tree::{self as typed, given, run};
