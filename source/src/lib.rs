//! A program as a person has written it, in numeric code or Instruction List.
//!
//! - [`Written`]: a file as it was read, unchecked
//! - [`Source`]: its text, the checked program, and the map from one to the other
//! - [`diagnosis`]: all faults of a program file, each shown in its source line
//! - [`list`]: a program as a ladder diagram or as numeric code with its meaning
//! - [`used`]: what a program uses of the board and its memory
//!
//! It owns the way from a file's bytes to a checked program, and what a person is shown of it. It knows
//! no files, no terminal, and nothing of how a program runs.

pub mod diagnosis;
pub mod list;
mod size;
mod source;
mod text;
pub mod used;
mod written;

pub use size::{Size, kept_en, kept_pt};
pub use source::{Language, Source, load, names};
pub use text::{decode, is_il};
pub use written::{Refused, Written};

use unoclp_core::Profile;

/// The board that every tool of this version checks and simulates for.
pub const BOARD: Profile = Profile::UNO;
