//! A program as a person has written it, in numeric code or Instruction List.
//!
//! - [`Written`]: a file as it was read, unchecked
//! - [`Source`]: its text, the checked program, and the map from one to the other
//! - [`diagnosis`]: all faults of a program file, each shown in its source line
//! - [`drawn`]: a program that is drawn, and its text
//! - [`lacks()`]: what a board lacks for a program of another
//! - [`list`]: a program as a ladder diagram or as numeric code with its meaning
//! - [`units()`]: what a project is made of
//! - [`used`]: what a program uses of the board and its memory
//!
//! Owns the way from a file's bytes to a checked program, and what a person is shown of it. Must not know files, a
//! terminal, how a program runs.

#![forbid(unsafe_code)]

mod colours;
pub mod diagnosis;
pub mod drawn;
mod effect;
mod first;
mod kept;
mod lacks;
mod language;
pub mod list;
mod seal;
mod shown;
mod size;
mod source;
mod text;
mod units;
pub mod used;
mod words;
mod written;
mod written_in;

pub use kept::Kept;
pub use lacks::{lacks, not_sent};
pub use language::{NoProgram, is_numeric};
pub use seal::{Seal, is_ours, sealed};
pub use shown::{harmless, harmless_lines, shown};
pub use size::Size;
pub use source::{Language, Source, load, names, point_names, symbols};
pub use text::decode;
pub use units::units;
pub use written::{Refused, Written};
pub use written_in::WrittenIn;

pub use unoclp_lang::{Diagnostic, Dialect, Holding, Lang, Shows, Trace, Variable, literal};
