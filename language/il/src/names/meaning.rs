//! What names stand for, as far as a text has been read.

use super::near::Near;
use crate::ast::Init;
use crate::temps::Temps;
use crate::tree::{Bit, Num};
use std::collections::{HashMap, HashSet};
use unoclp_core::isa::Opcode;
use unoclp_core::{Board, Number};
use unoclp_text::Dialect;
use unoclp_text::diagnostics::Span;
use unoclp_text::points::Spellings;
use unoclp_tree::Base;

/// What an operand means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Bit(Bit),
    Always(bool),
    Number(Num),
    /// A timer as a whole, by its index.
    Timer(usize),
    /// A counter as a whole, by its index.
    Counter(usize),
    /// R_TRIG or F_TRIG: its Q.
    Trigger(Opcode, u8),
    /// SR, where to set wins, or RS: its Q1.
    Latch(bool, u8),
    /// An instance of a function block of the file, by its index.
    Instance(usize),
    /// What has a type that is none of bits, whole numbers of the board, or blocks, or a part of it.
    Typed,
    /// Something was wrong with it, and has been told.
    Unknown,
}

/// A timer of the text.
#[derive(Debug)]
pub(crate) struct Timer {
    pub name: String,
    pub kind: Option<Opcode>,
    pub preset: Option<i32>,
    /// The calls that led to its first call, the innermost first.
    pub called: Option<Vec<Span>>,
    /// Where its Q or its time is first read.
    pub read: Option<Span>,
}

/// A counter of the text.
#[derive(Debug)]
pub(crate) struct Counter {
    pub name: String,
    /// C 01 to C 16.
    pub number: u8,
    pub kind: Option<Opcode>,
    pub preset: Option<i32>,
}

/// An instance of a function block of the file, or what its functions keep.
#[derive(Debug)]
pub(crate) struct Instance {
    /// The unit's index.
    pub unit: usize,
    pub names: HashMap<String, Place>,
    /// The instance that it is declared in.
    pub within: Option<usize>,
    /// Where it is declared, and the first values that its declaration gives its inputs.
    pub span: Span,
    pub inits: Vec<Init>,
}

/// An input that has been declared.
#[derive(Debug)]
pub(crate) struct DeclaredInput {
    pub name: String,
    pub span: Span,
    pub input: u8,
}

pub(crate) struct Names<'t> {
    pub text: &'t str,
    pub dialect: Dialect,
    pub board: Board,
    pub timers: Vec<Timer>,
    pub counters: Vec<Counter>,
    pub instances: Vec<Instance>,
    pub inputs: Vec<DeclaredInput>,
    /// How many variables begin with another value than 0, so far as nothing keeps them.
    pub initials: usize,
    pub retained: Retained,
    pub temps: Temps,
    /// Names that hold in the whole file: those that nothing declares, timers and counters.
    pub(super) global: HashMap<String, Place>,
    /// What VAR_GLOBAL declares somewhere in the file.
    pub(super) globals: HashSet<String>,
    /// Function blocks of the file.
    pub(super) blocks: HashMap<String, usize>,
    /// The inputs of each unit that may begin with a value of an instance's own.
    pub(super) inputs_of: HashSet<(usize, String)>,
    /// The markers of inputs that the text stores to: `T1.IN`.
    pub(super) block_inputs: HashMap<Input, u8>,
    pub(super) counters_used: u128,
    /// Bit 0 is input 01.
    pub inputs_read: u128,
    /// How each point of the board is written where it is first named.
    pub(super) points: Spellings,
    pub(super) near: Near,
    pub(super) widths: Widths,
}

/// What a text keeps.
#[derive(Debug, Default)]
pub(crate) struct Retained {
    /// Registers and counters, each once, and where they are declared.
    pub numbers: Vec<(Number, Span)>,
    /// Whether a register is kept that says whether anything has been.
    pub begun: bool,
}

/// The types of names that are narrower than the board's numbers.
#[derive(Debug, Default)]
pub(crate) struct Widths {
    /// By the instance that has the name, or none, and the name.
    pub(super) of: HashMap<(Option<usize>, String), Base>,
}

/// A block and one of its inputs.
pub(super) type Input = (Block, &'static str);

/// What has inputs: a timer or counter by its index, an edge or a latch by its marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Block {
    Timer(usize),
    Counter(usize),
    Edge(u8),
    Latch(u8),
}
