//! Operations that are deferred: from `(` to `)`.

use super::bits::name;
use super::walk::{Walk, loads};
use crate::ast::{Instr, Open};
use crate::diagnostics::{Code, Span};
use crate::list::{Acc, Accumulator, Frame, MOST_FRAMES, Machine, Waiting};
use crate::typed::ExprKind;

impl Walk<'_, '_, '_> {
    /// `AND(`: the accumulator and the operation wait on the stack.
    pub(super) fn defer(&mut self, instr: &Instr, open: Open) {
        if self.lost > 0 || self.run.frames.len() >= MOST_FRAMES {
            return self.lose(instr, open);
        }
        let mut left = self.take(name(instr.op), instr.span);
        self.only(instr, 1);
        let links = self.run.links;
        let mut inner = match instr.operands.first() {
            Some(operand) => {
                self.run.unused = Some(instr.whole);
                self.value(operand).map_or(Acc::Wrong, Acc::Value)
            }
            // Its load follows, and N inverts that.
            None if loads(self.next()) => {
                self.inverts = open.negated;
                Acc::Empty
            }
            // The accumulator keeps its value: both need it.
            None => {
                let is_simple = |expr: &crate::typed::Expr| {
                    matches!(expr.kind, ExprKind::Read(_) | ExprKind::Constant(_))
                };
                if let Some(expr) = left.take() {
                    left = Some(match is_simple(&expr) {
                        true => expr,
                        false => self.aside(expr),
                    });
                }
                left.clone().map_or(Acc::Wrong, Acc::Value)
            }
        };
        if open.negated
            && let Acc::Value(expr) = inner
        {
            inner = Acc::Value(self.inverted(expr, open.span));
        }
        self.run.frames.push(Frame {
            acc: left.map_or(Acc::Wrong, Acc::Value),
            waiting: Waiting::Deferred(instr.op, instr.negated),
            span: open.span,
            links,
        });
        self.run.acc = inner;
        self.run.links = 0;
    }

    /// A parenthesis too many is told once; what stands in it comes to nothing.
    fn lose(&mut self, instr: &Instr, open: Open) {
        if self.lost == 0 {
            self.tell(Code::TooDeep, open.span, []);
        }
        self.take(name(instr.op), instr.span);
        self.run.acc = Acc::Wrong;
        self.lost += 1;
    }

    /// `)`: the operation that was deferred last is done.
    pub(super) fn close(&mut self, span: Span) {
        if self.lost > 0 {
            self.lost -= 1;
            self.run.unused = None;
            self.run.acc = Acc::Wrong;
            return;
        }
        // Results that an LD has pushed within the parentheses are lost.
        while self.popped().is_some() {}
        let Some(frame) = self.run.frames.pop() else {
            return self.tell(Code::CloseWithoutOpen, span, []);
        };
        let Waiting::Deferred(op, negated) = frame.waiting else {
            return;
        };
        self.inverts = false;
        let right = self.take(")", span);
        let made = match (frame.acc, right) {
            (Acc::Value(left), Some(right)) => self.apply(op, negated, left, right, frame.span),
            _ => None,
        };
        self.hold(made);
        self.run.links += frame.links;
        self.link();
    }
}
