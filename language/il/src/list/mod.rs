//! The machine of Instruction List: a run through a body on expressions in place of values, so that `LD a`, `ADD b`,
//! `ST c` come to `c := a + b`.
//!
//! - `run`: what is held on the way: the accumulator, what waits, and the statements made
//! - `machine`: what a reader of Instruction List tells of itself
//! - `accumulator`: the accumulator, and what is put aside of it
//! - `lines`: the run from line to line; `says`: what a line is to it
//! - `defer`: what waits from `(` to `)`; `edges`: bits that rise or fall
//! - `stack`: ALD, OLD, PUSH, POP; `tables`: TABLE_LD, TABLE_ST; `codes`: CODE; `branches`: MPS, MRD, MPP;
//!   `decide`: S, R and what else is done where the accumulator is 1
//! - `flow`: jumps, labels, RET, IF; `labels`: where they lead, and which lines need the accumulator
//!
//! Owns how lines become statements. Must not know what an operand or an operator means: its readers tell that.

mod accumulator;
mod branches;
mod codes;
mod decide;
mod defer;
mod edges;
mod flow;
mod labels;
mod lines;
mod machine;
mod run;
mod says;
mod stack;
mod tables;

pub(crate) use accumulator::Accumulator;
pub(crate) use branches::Branches;
pub(crate) use codes::Verbatim;
pub(crate) use decide::Decides;
pub(crate) use defer::{Defers, Opens};
pub(crate) use edges::{Edges, declare_edge, named};
pub(crate) use flow::{Flow, Jump};
pub(crate) use lines::Lines;
pub(crate) use machine::Machine;
pub(crate) use run::{Acc, Changes, Frame, Run, Waiting};
pub(crate) use says::{Does, Says};
pub(crate) use stack::Stack;
pub(crate) use tables::{Tables, row};

/// Operations and results that wait in one another.
pub(crate) const MOST_FRAMES: usize = unoclp_core::isa::DEEPEST as usize;
