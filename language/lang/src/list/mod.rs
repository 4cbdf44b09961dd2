//! The machine of Instruction List: a run through a body on expressions in place of values, so that `LD a`, `ADD b`,
//! `ST c` come to `c := a + b`.
//!
//! - `run`: what is held on the way: the accumulator, what waits, and the statements made
//! - `machine`: what a reader of Instruction List tells of itself
//! - `accumulator`: the accumulator, and what is put aside of it
//! - `branches`: MPS, MRD, MPP; `decide`: S, R and what else is done where the accumulator is 1
//! - `flow`: jumps, labels, RET, IF; `labels`: where they lead, and which lines need the accumulator
//!
//! Owns how lines become statements. Must not know what an operand or an operator means: its readers tell that.

mod accumulator;
mod branches;
mod decide;
mod flow;
mod labels;
mod machine;
mod run;

pub(crate) use accumulator::{Accumulator, Changes};
pub(crate) use branches::Branches;
pub(crate) use decide::Decides;
pub(crate) use flow::{Flow, Jump};
pub(crate) use labels::{Passes, needed};
pub(crate) use machine::Machine;
pub(crate) use run::{Acc, Frame, Run, Waiting};

/// Operations and results that wait in one another.
pub(crate) const MOST_FRAMES: usize = unoclp_core::isa::DEEPEST as usize;
