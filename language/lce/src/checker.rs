//! What a program is checked with: its names, its variables and where they live.

use std::collections::HashMap;
use unoclp_point::Address;
use unoclp_text::diagnostics::Span;
use unoclp_tree::Base;
use unoclp_tree::build::Builder;

pub(super) struct Checker<'t, 'f> {
    pub builder: Builder<'t, 'f>,
    /// What each name stands for; none of a name that has been reported.
    pub names: HashMap<String, Option<Slot>>,
    pub variables: Vec<Variable>,
    pub shown: Vec<Shown>,
    pub asked: u32,
    /// Where each coil stands.
    pub coils: HashMap<Slot, Span>,
    /// How many statements turn off the coils of what is not reached.
    pub resets: usize,
}

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Slot {
    /// A variable, by its number here.
    Variable(usize),
    /// A point of the board.
    Point(Address),
}

/// What is written to a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Written {
    Bit,
    Whole,
    Real,
}

/// A variable: the types it is written with, and where it lives.
#[derive(Clone, Debug, Default)]
pub(super) struct Variable {
    pub bit: bool,
    pub whole: bool,
    pub real: bool,
    pub cells: Option<Cells>,
}

/// The cells of a variable.
#[derive(Clone, Copy, Debug)]
pub(super) enum Cells {
    /// It is written with one type only.
    One(u32, Base),
    /// Mixed kinds: a marker says which of two cells holds what was last written.
    Two { flag: u32, real: u32, whole: u32 },
}

/// A name that is shown.
pub(super) struct Shown {
    pub name: String,
    pub slot: Slot,
    pub at: Span,
}
