//! What a run through a body holds on its way.

use super::labels::{If, Labels};
use crate::operators::Op;
use std::collections::HashSet;
use unoclp_text::diagnostics::Span;
use unoclp_tree::build::Target;
use unoclp_tree::{Expr, Place, Stmt};

/// Operations and results that wait in one another.
pub(super) const MOST_FRAMES: usize = unoclp_core::isa::DEEPEST as usize;

/// What the accumulator holds.
#[derive(Clone, Debug, Default)]
pub(super) enum Acc {
    #[default]
    Empty,
    /// What is wrong has been told.
    Wrong,
    Value(Expr),
    /// An array or a structure.
    Whole(Target),
}

/// What a result waits for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Waiting {
    /// For `)`, with N where the result is inverted.
    Deferred(Op, bool),
    /// For ALD, OLD, or a counter with more than one input.
    Pushed,
}

/// What a statement may change.
pub(super) enum Changes<'p> {
    /// So many cells from this one on.
    Cells(&'p Place, u32),
    Anything,
}

/// A result that waits.
#[derive(Debug)]
pub(super) struct Frame {
    pub acc: Acc,
    pub waiting: Waiting,
    /// The operator that it waits for.
    pub operator: Span,
    pub span: Span,
    pub links: u32,
}

/// What a run through a body holds on its way.
#[derive(Debug)]
pub(super) struct Run {
    /// Whether the accumulator is needed before each line, and after the last.
    pub needs: Vec<bool>,
    /// The line that is run.
    pub at: usize,
    pub acc: Acc,
    /// Operations in the accumulator's expression.
    pub links: u32,
    pub frames: Vec<Frame>,
    /// The loads that push the result before them, by their lines.
    pub pushes: HashSet<usize>,
    /// What MPS has kept, and where.
    pub kept: Vec<(Acc, Span)>,
    /// What PUSH has pushed, and where.
    pub pushed: Vec<(Expr, Span)>,
    /// Whether the accumulator is the condition of the IF that was made last, or its opposite.
    pub decided: Option<bool>,
    /// Parentheses whose operations are lost to an error.
    pub lost: usize,
    /// N after a parenthesis: the load that follows is inverted.
    pub inverts: bool,
    /// The result that nothing has used yet.
    pub unused: Option<Span>,
    /// Nothing comes here.
    pub unreachable: bool,
    /// The parenthesis of which it has been told that something cannot stand in it.
    pub told_open: Option<Span>,
    /// Whether the body jumps, wherever to.
    pub jumps: bool,
    pub labels: Labels,
    pub ifs: Vec<If>,
    /// The statements: of the body, and of each IF that is open.
    pub made: Vec<Vec<Stmt>>,
    /// Variables of the compiler's own so far.
    pub own: u32,
}

impl Run {
    /// Where nothing has been run.
    pub fn new() -> Run {
        Run {
            needs: Vec::new(),
            at: 0,
            acc: Acc::Empty,
            links: 0,
            frames: Vec::new(),
            pushes: HashSet::new(),
            kept: Vec::new(),
            pushed: Vec::new(),
            decided: None,
            lost: 0,
            inverts: false,
            unused: None,
            unreachable: false,
            told_open: None,
            jumps: false,
            labels: Labels::default(),
            ifs: Vec::new(),
            made: vec![Vec::new()],
            own: 0,
        }
    }

    /// Whether the accumulator is used after the line that is run.
    pub fn needed(&self) -> bool {
        self.needs.get(self.at + 1).copied().unwrap_or_default()
    }

    /// The result that was pushed last.
    pub fn popped(&mut self) -> Option<Acc> {
        let pushed = |frame: &mut Frame| matches!(frame.waiting, Waiting::Pushed);
        let frame = self.frames.pop_if(pushed)?;
        self.links += frame.links;
        Some(frame.acc)
    }

    /// Puts a new value into the accumulator.
    pub fn hold(&mut self, expr: Option<Expr>) {
        self.acc = match expr {
            Some(expr) if !matches!(expr.kind, unoclp_tree::ExprKind::Wrong) => Acc::Value(expr),
            _ => Acc::Wrong,
        };
    }

    /// A value that no operation of this expression has made.
    pub fn load(&mut self, expr: Option<Expr>) {
        self.links = 0;
        self.decided = None;
        self.hold(expr);
    }
}
