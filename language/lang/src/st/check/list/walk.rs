//! A run of the lines on expressions, with the variables and types of a typed text.

use super::super::super::ast::Line;
use super::super::Checker;
use crate::diagnostics::{Code, Severity, Span, Word};
use crate::list::{Acc, Defers, Does, Machine, Run, Says, Waiting};
use crate::operators::Op;
use crate::typed::build::{Argument, Builder, Given, Target};
use crate::typed::{Expr, ExprKind, Stmt};

pub(super) struct Walk<'c, 'a, 't, 'f> {
    pub(super) c: &'c mut Checker<'a, 't, 'f>,
    pub(super) lines: &'c [Line],
    pub(super) run: Run,
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

    fn inverted(&mut self, expr: Expr, at: Span) -> Expr {
        self.c.builder.not(expr, at)
    }

    fn joined(&mut self, of: Waiting, left: Expr, right: Expr, from: [Span; 2]) -> Option<Expr> {
        let (name, negated) = match of {
            Waiting::Function(name, negated) => (name, negated),
            Waiting::Deferred(Op::And, negated) => ("AND".to_owned(), negated),
            Waiting::Deferred(Op::Or, negated) => ("OR".to_owned(), negated),
            _ => return None,
        };
        let right = match negated {
            true => self.c.builder.not(right, from[1]),
            false => right,
        };
        let all = vec![accumulated(left), accumulated(right)];
        let at = from[0].to(from[1]);
        Some(self.c.builder.function(&name, all, at))
    }

    fn lines(&self) -> usize {
        self.lines.len()
    }

    fn says(&self, at: usize) -> Says<'_> {
        match &self.lines[at] {
            Line::Label(name) => Says::Label(name.text.to_uppercase().into(), name.span),
            Line::Close(span) => Says::Close(*span),
            Line::Wrong => Says::Wrong(None),
            Line::Does(one) => Says::Does(Does {
                op: one.spelling.map(|spelling| spelling.op),
                conditional: one.jump().conditional,
                label: one.label().map(|name| name.text.to_uppercase().into()),
                pops: match one.spelling.map(|spelling| spelling.op) {
                    Some(Op::AndBlock | Op::OrBlock) => 1,
                    _ => 0,
                },
                span: one.word.span,
                whole: one.span,
            }),
        }
    }

    fn reads(&self, at: usize) -> bool {
        let Line::Does(one) = &self.lines[at] else {
            return false;
        };
        match one.spelling {
            Some(_) if self.own_function(one).is_none() => one.given.is_none(),
            _ => self.takes_accumulator(one),
        }
    }

    fn line(&mut self, at: usize) {
        let lines = self.lines;
        if let Some(Line::Does(one)) = lines.get(at) {
            self.instruction(one);
        }
    }

    fn close_line(&mut self, span: Span) {
        self.close(span);
        if let Acc::Value(expr) = &self.run.acc {
            self.run.unused = Some(expr.at);
        }
    }
}

/// What an operation takes from the accumulator.
pub(super) fn accumulated(expr: Expr) -> Argument {
    Argument {
        name: None,
        out: false,
        at: expr.at,
        given: Given::Value(expr),
    }
}
