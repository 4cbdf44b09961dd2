//! What a name stands for.
//!
//! Owns the kinds of declarations. Must not know how one is made.

use crate::diagnostics::Span;
use crate::typed::{Initial, Place, Root, TypeId, Value};
use std::sync::Arc;
use unoclp_point::Address;

/// The kind of a declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Section {
    Var,
    Input,
    Output,
    InOut,
    Temp,
    /// VAR_GLOBAL, and what is declared outside of all units.
    Global,
    /// Names a global.
    External,
}

/// What else a declaration says.
#[derive(Clone, Debug, Default)]
pub(crate) struct Traits {
    pub initial: Option<Arc<Initial>>,
    pub constant: bool,
    pub retain: bool,
    /// It is the front end's own, and no symbol; VAR_TEMP of it is stored on every way before it is read.
    pub unseen: bool,
    pub point: Option<Address>,
}

/// A variable, and where it is.
#[derive(Clone, Debug)]
pub(crate) struct Variable {
    pub name: String,
    pub ty: TypeId,
    pub root: Root,
    pub offset: u32,
    pub section: Section,
    pub constant: bool,
    pub at: Span,
}

impl Variable {
    /// As a place.
    pub fn place(&self, at: Span) -> Place {
        Place {
            root: self.root,
            offset: self.offset,
            indices: Vec::new(),
            at,
        }
    }
}

/// Whether letters of both cases are the same in names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Letters {
    /// `Motor` is `MOTOR`.
    Alike,
    /// They are two names.
    Apart,
}

/// Why nothing can be stored in a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lock {
    Constant,
    /// An output of a block.
    Output,
    /// An input of the board.
    Sensor,
}

/// What a name stands for.
#[derive(Clone, Debug)]
pub(crate) enum Named {
    Variable(Variable),
    /// A value of an enumeration, or VAR CONSTANT.
    Constant(Value, TypeId),
    /// A value of more than one enumeration; of this one too.
    Ambiguous(TypeId),
    Type(TypeId),
    Unit(u32),
}

/// What a unit takes and gives.
#[derive(Clone, Debug)]
pub(crate) struct Param {
    pub name: String,
    pub section: Section,
    pub ty: TypeId,
    /// Its first cell, or of VAR_IN_OUT its number.
    pub offset: u32,
}

/// A turn of a loop, while its body is made.
pub(crate) struct Turn {
    pub variable: (Root, u32),
    pub value: i128,
    /// Whether the value has picked an instance.
    pub picks: bool,
    /// Whether it is known that it does.
    pub is_written: bool,
}
