//! Operations that are deferred: from `(` to `)`.

use super::said::name;
use super::{Acc, Frame, Lower, MOST_FRAMES, Waiting, loads};
use crate::ast::{Instr, Open, Stmt};
use crate::diagnostics::{Code, Span};
use crate::tree::{Expr, Number};

impl Lower<'_, '_> {
    /// `AND(`: the accumulator and the operation wait on the stack.
    pub(super) fn defer(&mut self, instr: &Instr, open: Open, next: Option<&Stmt>) {
        if self.lost > 0 || self.frames.len() >= MOST_FRAMES {
            return self.lose(instr, open);
        }
        let mut left = self.take_acc(name(instr.op), instr.span);
        self.only(instr, 1);
        let mut inner = match instr.operands.first() {
            Some(operand) => {
                self.unused = Some(instr.whole);
                self.value(operand)
            }
            // Its load follows, and N inverts that.
            None if loads(next) => {
                self.invert_load = open.negated;
                Acc::Empty
            }
            // The accumulator keeps its value: both need it.
            None => {
                if !matches!(
                    left,
                    Acc::Bit(Expr::Lit { .. }) | Acc::Number(Number::Leaf(..))
                ) {
                    self.freeze(instr.span);
                    left = self.fixed(left, instr.span);
                }
                left.clone()
            }
        };
        if open.negated && inner != Acc::Empty {
            inner = self.inverted(inner, open.span);
        }
        // What the board's value holds must be there when the next number has been worked out.
        if let Acc::Number(number) = &left
            && number.has_live()
        {
            left = self.fixed(left, instr.span);
        }
        self.frames.push(Frame {
            acc: left,
            waiting: Waiting::Deferred(instr.op, instr.negated),
            span: open.span,
            links: self.links,
        });
        self.acc = inner;
        self.links = 0;
    }

    /// A parenthesis too many is told once; what stands in it comes to nothing.
    fn lose(&mut self, instr: &Instr, open: Open) {
        if self.lost == 0 {
            self.found.tell(Code::TooDeep, open.span, []);
        }
        self.take_acc(name(instr.op), instr.span);
        self.acc = Acc::Unknown;
        self.lost += 1;
    }

    /// `)`: the operation that was deferred last is done.
    pub(super) fn close(&mut self, span: Span) {
        if self.lost > 0 {
            self.lost -= 1;
            self.unused = None;
            self.acc = Acc::Unknown;
            return;
        }
        // Results that an LD has pushed within the parentheses are lost.
        while self.popped().is_some() {}
        let Some(frame) = self.frames.pop() else {
            self.found.tell(Code::CloseWithoutOpen, span, []);
            return;
        };
        let Waiting::Deferred(op, negated) = frame.waiting else {
            return;
        };
        self.invert_load = false;
        let right = self.take_acc(")", span);
        self.acc = self.apply(op, negated, frame.acc, right, frame.span);
        self.links += frame.links;
        self.link(span);
    }
}
