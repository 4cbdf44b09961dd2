//! Statements of the typed tree.
//!
//! What they do is said here; in what order, by the unit that they stand in.

use super::base::Base;
use super::expression::{Call, Expr, Place, Store};
use super::standard::Standard;
use crate::diagnostics::Span;

/// A statement.
#[derive(Clone, Debug)]
pub struct Stmt {
    /// What it does.
    pub kind: StmtKind,
    /// Where it stands.
    pub at: Span,
}

/// What a statement does.
#[derive(Clone, Debug)]
pub enum StmtKind {
    /// Stores a value.
    Assign(Place, Expr, Store),
    /// Copies cells of the same types: from the second place to the first.
    Copy(Place, Place, u32),
    /// The first arm whose condition holds, or what is after ELSE.
    If(Vec<(Expr, Vec<Stmt>)>, Vec<Stmt>),
    /// The arm that has the number between two of its bounds, or what is after ELSE.
    Case(Expr, Vec<Arm>, Vec<Stmt>),
    /// While the condition holds.
    While(Expr, Vec<Stmt>),
    /// At least once, until the condition holds.
    Repeat(Vec<Stmt>, Expr),
    /// Counts.
    For(Box<For>),
    /// Leaves the innermost loop.
    Exit,
    /// Goes on with the next turn of the innermost loop.
    Continue,
    /// Leaves the unit.
    Return,
    /// Calls a function without its result, or a block.
    Call(Call),
    /// Runs a block of the norm, whose inputs have been stored.
    Standard(Standard, Place),
    /// Shows a variable on a PC; marks it as watched on a board.
    Print(String, Expr),
    /// Goes to the statement of this number in the unit's body, if the condition holds. It stands in the body
    /// itself, in no other statement.
    Jump(Option<Expr>, u32),
}

/// An arm of CASE: the first and the last number of each of its ranges, and what is done.
pub type Arm = (Vec<(i128, i128)>, Vec<Stmt>);

/// A loop that counts. The three expressions are computed once; a step of 0 does nothing, and sets S 04.
#[derive(Clone, Debug)]
pub struct For {
    /// The variable, of an integer type, without computed subscripts.
    pub variable: Place,
    /// Its type.
    pub base: Base,
    /// Its first value.
    pub from: Expr,
    /// Its last one.
    pub to: Expr,
    /// By how much.
    pub step: Expr,
    /// What is done.
    pub body: Vec<Stmt>,
}
