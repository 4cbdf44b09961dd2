//! Statements of the typed tree.
//!
//! What they do is said here; in what order, by the unit that they stand in.

use super::base::Base;
use super::expression::{Call, Expr, Place, Store};
use super::standard::Standard;
use unoclp_text::diagnostics::Span;

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
    /// Runs a block of the standard, whose inputs have been stored.
    Standard(Standard, Place),
    /// Does to a timer or a counter what an instruction of the board does beside its call.
    Order(Order, Standard, Place),
    /// Shows a variable on a PC; marks it as watched on a board.
    Print(String, Expr),
    /// An instruction of the board as it is.
    Codes(Box<Codes>),
    /// Goes to the statement of this number in the unit's body, if the condition holds. It stands in the body
    /// itself, in no other statement.
    Jump(Option<Expr>, u32),
}

/// What is done to a timer or a counter beside its call. A counter's outputs follow at once.
#[derive(Clone, Debug)]
pub enum Order {
    /// A counter is 0, a timer as if it had never been started.
    Reset,
    /// A counter becomes its preset, or 0 where that is less.
    Load,
    /// Its preset, of the type of that.
    Preset(Expr),
    /// A counter's number, of the type of that.
    Number(Expr),
    /// ET becomes the time that the board shows at this moment (NC-14).
    Look,
}

impl Order {
    /// What it computes.
    pub const fn value(&self) -> Option<&Expr> {
        match self {
            Order::Preset(value) | Order::Number(value) => Some(value),
            Order::Reset | Order::Load | Order::Look => None,
        }
    }
}

/// An instruction of the board by its codes. Only a board does it, and it may do anything there.
#[derive(Clone, Debug)]
pub struct Codes {
    /// What the board's accumulator is before it, a BOOL; what it happens to be where this is none.
    pub before: Option<Expr>,
    /// The code and its operand lines, and where each stands.
    pub codes: Vec<(i32, Span)>,
    /// The cell of a BOOL that the accumulator goes to behind it, if anything reads that.
    pub behind: Option<Place>,
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
