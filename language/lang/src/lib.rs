//! The languages behind one door: which there are, and what tools ask of a text in any of them.
//!
//! - `languages`: the registry, and a text in one of its rows checked, compiled, coloured; `adapt`: a text of another PLC
//!   with its points on this board
//! - all else is named here and made elsewhere: `unoclp-st`, `unoclp-il`, `unoclp-iscl` and `unoclp-lce` read texts to the
//!   typed tree, `unoclp-codegen` takes it to a program, `unoclp-reverse` writes texts from programs
//!
//! Owns the registry. Must not know what a word of a language means, files, screens. No text makes it panic.

#![forbid(unsafe_code)]

mod adapt;
mod languages;

use unoclp_text::{colour, diagnostics};

pub use adapt::{adapt, written_points};
pub use colour::Colour;
pub use diagnostics::{Code, Diagnostic, Lang, Lines, Severity, Span, Told, Word};
pub use languages::{
    CheckedText, TextLanguage, check, check_placed, colours, compile, compile_text, register,
};
pub use unoclp_codegen::{CodeLine, CompiledText, Held, Holding, Shows, Trace, Variable, literal};
pub use unoclp_il::{Declared, DeclaredPoint, declared, is_operator};
pub use unoclp_reverse::{instructions_to_il, spelled, to_il, to_st};
pub use unoclp_st::parts;
pub use unoclp_st::{Condition, Judge, brought, condition, is_brought, is_name};
pub use unoclp_text::literal::duration;
pub use unoclp_text::moved::{Adapted, adapt_at};
pub use unoclp_text::outline;
pub use unoclp_text::points::{no_such_point, point};
pub use unoclp_text::{Dialect, lacking, show};
pub use unoclp_tree::{self as typed, Options, given, run};
