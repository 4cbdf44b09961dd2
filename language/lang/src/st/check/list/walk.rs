//! A run of the lines on expressions, with the variables and types of a typed text.

use super::super::super::ast::Line;
use super::super::Checker;
use crate::diagnostics::{Code, Severity, Span, Word};
use crate::list::{Machine, Run};
use crate::typed::build::{Builder, Target};
use crate::typed::{Expr, ExprKind, Stmt};

pub(super) struct Walk<'c, 'a, 't, 'f> {
    pub(super) c: &'c mut Checker<'a, 't, 'f>,
    pub(super) lines: &'c [Line],
    pub(super) run: Run,
    /// How many edges the line that is run has had.
    pub(super) edges: usize,
    /// Operations that waited may be lost to an error.
    pub(super) lost: bool,
    /// `(N`: the load that follows is inverted.
    pub(super) inverts: bool,
}

impl<'t, 'f> Machine<'t, 'f> for Walk<'_, '_, 't, 'f> {
    fn run(&self) -> &Run {
        &self.run
    }

    fn run_mut(&mut self) -> &mut Run {
        &mut self.run
    }

    fn builder(&mut self) -> &mut Builder<'t, 'f> {
        &mut self.c.builder
    }

    fn built(&self) -> &Builder<'t, 'f> {
        &self.c.builder
    }

    fn tell<const N: usize>(&mut self, code: Code, at: Span, words: [Word; N]) {
        if code.severity() == Severity::Error {
            self.run.unused = None;
        }
        self.c.builder.tell(code, at, words);
    }

    fn tested(&mut self, expr: Expr, _: Span) -> Option<Expr> {
        let expr = self.c.builder.condition(expr);
        (!matches!(expr.kind, ExprKind::Wrong)).then_some(expr)
    }

    fn carries(&mut self, expr: Expr, _: Option<&Target>, _: Span) -> Option<Expr> {
        Some(self.c.builder.settled(expr))
    }

    fn assigned(&mut self, target: &Target, value: Expr, at: Span) -> Option<Stmt> {
        self.c.builder.assign(target.clone(), value, at)
    }
}
