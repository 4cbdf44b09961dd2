//! The typed tree itself: units, their cells, statements and expressions.
//!
//! Nothing in it is open: each expression has its type, each conversion is a node, each variable a place.

use super::base::Base;
use super::enumeration::Enumeration;
use super::statement::Stmt;
use super::types::{TypeId, Types};
use super::value::Value;
use std::sync::Arc;
use unoclp_point::Address;
use unoclp_text::diagnostics::Span;

/// A program as any of the languages has written it.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// The types of its variables.
    pub types: Types,
    /// What lives as long as the program: globals, variables of programs, instances in them, points.
    pub cells: Vec<Cell>,
    /// Its functions, blocks and programs; a call names one by its number here.
    pub units: Vec<Unit>,
    /// The programs among them, in the order in which a scan runs them.
    pub programs: Vec<u32>,
    /// What lives as long as the program, by its names, for whoever shows it.
    pub symbols: Vec<Symbol>,
    /// The cells that are points of the board. One that is eight bits as one number has no value of its own: it is read
    /// from their cells, and stored there. The cell of a counter's number says which counter it is.
    pub points: Vec<(u32, Address)>,
    /// The cells among those that are kept whose first value the text states: they are given it though it is 0.
    pub begun: Vec<u32>,
    /// What the text declares, in the order of the declarations.
    pub declared: Vec<Declared>,
}

/// A variable as a text declares it, wherever it lives; a function's result among them.
#[derive(Clone, Debug)]
pub struct Declared {
    /// The unit that has it; none of what all have.
    pub unit: Option<u32>,
    /// As it is written.
    pub name: String,
    /// Its type.
    pub ty: TypeId,
    /// Its name in the text.
    pub at: Span,
}

/// A cell: it holds one value of an elementary type.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Of what type.
    pub base: Base,
    /// With what it begins.
    pub initial: Value,
    /// Whether it is kept over a power cut.
    pub retain: bool,
    /// The front end's own, stored on every way before it is read: its first value is never seen.
    pub scratch: bool,
}

impl Cell {
    /// One of the compiler's own, which begins with 0.
    pub fn own(base: Base) -> Cell {
        Cell {
            base,
            initial: Value::zero(base),
            retain: false,
            scratch: false,
        }
    }
}

/// A variable that lives as long as the program, for whoever shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Symbol {
    /// As it was declared; a member and an element are symbols of their own, `q.x` and `a[1,0]`.
    pub name: String,
    /// Its type, as a person writes it.
    pub type_name: String,
    /// What its value is. Its cell may be of another type, where it stands at a point that other names have too.
    pub base: Base,
    /// Where it is.
    pub holds: Holds,
    /// Its declaration.
    pub at: Span,
    /// Its values, if it is of an enumeration.
    pub values: Arc<Enumeration>,
}

/// Where the value of a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holds {
    /// In this cell.
    Cell(u32),
    /// In one of two cells, as a third says: a variable that holds what was last written.
    Either {
        /// The cell that says which.
        flag: u32,
        /// The one that is meant if it is 1.
        set: u32,
        /// And if it is 0.
        clear: u32,
    },
}

/// What a unit is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitKind {
    /// Runs in each scan.
    Program,
    /// Its instances keep their cells.
    Block,
    /// Its cells are new at each call.
    Function,
}

/// A program, a function block or a function.
#[derive(Clone, Debug)]
pub struct Unit {
    /// As it was declared.
    pub name: String,
    /// What it is.
    pub kind: UnitKind,
    /// The cells of an instance of a block; empty of others.
    pub own: Vec<Cell>,
    /// The cells of one call: a function's result first, what it takes, and its variables; VAR_TEMP of others.
    pub locals: Vec<Cell>,
    /// How many places a caller lends it, for VAR_IN_OUT.
    pub references: u32,
    /// What it does.
    pub body: Vec<Stmt>,
    /// Its name; of a unit that does not stand in the text, the empty span.
    pub at: Span,
}
