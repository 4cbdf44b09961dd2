//! A run of the lines on expressions: what it holds on its way.

use super::super::super::ast::Line;
use super::super::Checker;
use crate::diagnostics::Span;
use crate::typed::build::Target;
use crate::typed::{Expr, Stmt};
use std::collections::HashMap;

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
    pub(super) ifs: Vec<If>,
    /// The statements, of the unit and of each IF that is open.
    pub(super) made: Vec<Vec<Stmt>>,
}

/// The labels of a unit.
#[derive(Default)]
pub(super) struct Labels {
    /// In which line each stands, by its name in upper case.
    pub(super) lines: HashMap<String, usize>,
    /// The statement that each leads to; those after the text's own labels are of IF.
    pub(super) places: HashMap<usize, usize>,
    /// Where the accumulator waits that is needed after a label.
    pub(super) carried: HashMap<usize, Target>,
    /// Jumps whose statement is not known yet: the jump, and the label.
    pub(super) open: Vec<(usize, usize)>,
    /// Labels of IF so far.
    pub(super) of_ifs: usize,
    /// Variables of the compiler's own so far.
    pub(super) own: u32,
}

/// An IF that is open.
pub(super) struct If {
    pub(super) span: Span,
    pub(super) condition: Option<Expr>,
    /// What is done where the condition holds, once ELSE has come.
    pub(super) first: Option<Vec<Stmt>>,
    /// With jumps: the labels after its first part, and after it.
    pub(super) labels: Option<(usize, usize)>,
    pub(super) other: bool,
}
