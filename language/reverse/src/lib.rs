//! From the numeric code back to texts: [`to_il`] to Instruction List, [`to_st()`] to Structured Text.
//!
//! - `back`: each rung as Instruction List, where that compiles to the same codes again; `spell`: how a rung is said
//! - `to_st`: the run of a program on expressions, and what is written of it
//!
//! Owns how a checked program is said in a language. Must not know how a text is compiled beyond asking for it, files,
//! screens. No program makes it panic.

#![forbid(unsafe_code)]

mod back;
mod spell;
mod to_st;

pub use back::{instructions_to_il, spelled, to_il};
pub use to_st::to_st;
