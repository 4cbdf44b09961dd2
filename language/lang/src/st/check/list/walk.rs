//! A run of the lines on expressions: what it holds on its way.

use super::super::super::ast::Line;
use super::super::Checker;
use crate::diagnostics::Span;
use crate::jumps::{If, Labels};
use crate::typed::build::Target;
use crate::typed::{Expr, Stmt};

/// What the accumulator holds.
#[derive(Clone, Debug)]
pub(super) enum Acc {
    Empty,
    /// What is wrong has been told.
    Wrong,
    Value(Expr),
    /// An array or a structure.
    Whole(Target),
}

/// An operation that waits for its `)`.
pub(super) struct Frame {
    pub(super) name: String,
    pub(super) acc: Acc,
    pub(super) negated: bool,
    pub(super) at: Span,
}

pub(super) struct Walk<'c, 'a, 't, 'f> {
    pub(super) c: &'c mut Checker<'a, 't, 'f>,
    pub(super) lines: &'c [Line],
    /// Whether the accumulator is needed before each line, and after the last.
    pub(super) needs: Vec<bool>,
    /// The line that is run, and how many edges it has had.
    pub(super) line: usize,
    pub(super) edges: usize,
    pub(super) acc: Acc,
    /// Operations in the accumulator's expression.
    pub(super) links: u32,
    pub(super) frames: Vec<Frame>,
    /// Operations that waited may be lost to an error.
    pub(super) lost: bool,
    /// What MPS has kept.
    pub(super) kept: Vec<Acc>,
    /// `(N`: the load that follows is inverted.
    pub(super) inverts: bool,
    /// The result that nothing has used yet.
    pub(super) unused: Option<Span>,
    /// Nothing comes here.
    pub(super) unreachable: bool,
    pub(super) labels: Labels,
    /// Variables of the compiler's own so far.
    pub(super) own: u32,
    pub(super) ifs: Vec<If>,
    /// The statements, of the unit and of each IF that is open.
    pub(super) made: Vec<Vec<Stmt>>,
}
