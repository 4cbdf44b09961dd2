//! What a name stands for.
//!
//! Owns the kinds of declarations. Must not know how one is made.

use crate::{Initial, Place, Root, TypeId, Value};
use std::sync::Arc;
use unoclp_point::Address;
use unoclp_text::diagnostics::Span;

/// The kind of a declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// A variable of the unit.
    Var,
    /// VAR_INPUT.
    Input,
    /// VAR_OUTPUT.
    Output,
    /// VAR_IN_OUT.
    InOut,
    /// VAR_TEMP.
    Temp,
    /// VAR_GLOBAL, and what is declared outside of all units.
    Global,
    /// Names a global.
    External,
    /// A step or an action of a chart, which the chart alone changes.
    Chart,
}

/// What else a declaration says.
#[derive(Clone, Debug, Default)]
pub struct Traits {
    /// Its first value.
    pub initial: Option<Arc<Initial>>,
    /// Nothing may be stored in it.
    pub constant: bool,
    /// RETAIN: it outlasts a power failure.
    pub retain: bool,
    /// It is the front end's own, and no symbol; VAR_TEMP of it is stored on every way before it is read.
    pub unseen: bool,
    /// The point of the board that it is.
    pub point: Option<Address>,
}

/// A variable, and where it is.
#[derive(Clone, Debug)]
pub struct Variable {
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
pub enum Letters {
    /// `Motor` is `MOTOR`.
    Alike,
    /// They are two names.
    Apart,
}

/// Why nothing can be stored in a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lock {
    Constant,
    /// An output of a block.
    Output,
    /// An input of the board.
    Sensor,
    /// A step or an action of a chart.
    Chart,
}

/// What a name stands for.
#[derive(Clone, Debug)]
pub enum Named {
    /// Its value is fixed.
    Variable(Variable),
    /// A value of an enumeration, or VAR CONSTANT.
    Constant(Value, TypeId),
    /// A value of more than one enumeration; of this one too.
    Ambiguous(TypeId),
    /// A type.
    Type(TypeId),
    /// A unit, by its number.
    Unit(u32),
}

/// What a unit takes and gives.
#[derive(Clone, Debug)]
pub struct Param {
    pub name: String,
    pub section: Section,
    pub ty: TypeId,
    /// Its first cell, or of VAR_IN_OUT its number.
    pub offset: u32,
}

/// A turn of a loop, while its body is made.
pub struct Turn {
    pub variable: (Root, u32),
    pub value: i128,
    /// Whether the value has picked an instance.
    pub picks: bool,
    /// Whether it is known that it does.
    pub is_written: bool,
}
