//! Operations that are deferred: from `(` to `)`.

use super::bits::name;
use super::run::{Acc, Frame, MOST_FRAMES, Waiting};
use super::walk::Walk;
use crate::ast::{Instr, Open, Stmt};
use crate::operators::Op;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Expr, ExprKind};

/// A parenthesis that opens.
struct Opens<'o> {
    /// What messages call the operator.
    what: &'o str,
    operator: Span,
    at: Span,
    /// N after it: the first operand is inverted.
    negated: bool,
    /// Its first operand is loaded by the line that follows.
    loads: bool,
}

impl Walk<'_, '_, '_> {
    /// `AND(`
    pub(super) fn open(&mut self, instr: &Instr, open: Open) {
        let next = self.next();
        let opens = Opens {
            what: name(instr.op),
            operator: instr.span,
            at: open.span,
            negated: open.negated,
            loads: matches!(next, Some(Stmt::Instr(next)) if next.op == Op::Load),
        };
        let waiting = Waiting::Deferred(instr.op, instr.negated);
        let first = instr.operands.first().map(|operand| {
            move |walk: &mut Self| {
                walk.only(instr, 1);
                walk.run.unused = Some(instr.whole);
                walk.value(operand)
            }
        });
        self.defer(waiting, &opens, first);
    }

    /// `AND(`: the accumulator and the operation wait; `first` is its operand.
    fn defer(
        &mut self,
        waiting: Waiting,
        opens: &Opens,
        first: Option<impl FnOnce(&mut Self) -> Option<Expr>>,
    ) {
        if self.run.lost > 0 || self.run.frames.len() >= MOST_FRAMES {
            return self.lose(opens);
        }
        let mut left = self.take(opens.what, opens.operator);
        let links = self.run.links;
        let mut inner = match first {
            Some(first) => first(self).map_or(Acc::Wrong, Acc::Value),
            // N inverts what is loaded.
            None if opens.loads => {
                self.run.inverts = opens.negated;
                Acc::Empty
            }
            // The accumulator keeps its value: both need it.
            None => {
                let is_simple =
                    |expr: &Expr| matches!(expr.kind, ExprKind::Read(_) | ExprKind::Constant(_));
                if let Some(expr) = left.take() {
                    left = Some(match is_simple(&expr) {
                        true => expr,
                        false => self.aside(expr),
                    });
                }
                left.clone().map_or(Acc::Wrong, Acc::Value)
            }
        };
        if opens.negated
            && let Acc::Value(expr) = inner
        {
            inner = Acc::Value(self.opposite(expr, opens.at));
        }
        let run = &mut self.run;
        run.frames.push(Frame {
            acc: left.map_or(Acc::Wrong, Acc::Value),
            waiting,
            operator: opens.operator,
            span: opens.at,
            links,
        });
        run.acc = inner;
        run.links = 0;
    }

    /// A parenthesis too many is told once; what stands in it comes to nothing.
    fn lose(&mut self, opens: &Opens) {
        if self.run.lost == 0 {
            self.tell(Code::TooDeep, opens.at, []);
        }
        self.take(opens.what, opens.operator);
        self.run.acc = Acc::Wrong;
        self.run.lost += 1;
    }

    /// `)`: the operation that was deferred last is done.
    pub(super) fn close(&mut self, span: Span) {
        let run = &mut self.run;
        if run.lost > 0 {
            run.lost -= 1;
            run.unused = None;
            run.acc = Acc::Wrong;
            return;
        }
        // Results that an LD has pushed within the parentheses are lost.
        while run.popped().is_some() {}
        let Some(frame) = run.frames.pop() else {
            return self.tell(Code::CloseWithoutOpen, span, []);
        };
        run.inverts = false;
        let right = self.take(")", span);
        let made = match (frame.acc, right) {
            (Acc::Value(left), Some(right)) => match frame.waiting {
                Waiting::Deferred(op, negated) => {
                    self.apply(op, negated, left, right, frame.operator)
                }
                Waiting::Pushed => None,
            },
            _ => None,
        };
        self.hold(made);
        self.run.links += frame.links;
        self.link();
    }

    /// Tells what is left open where a body ends.
    pub(super) fn end_of_frames(&mut self) {
        let told = self.run.told_open;
        let frames = self.run.frames.iter();
        let mut open = frames.filter(|frame| !matches!(frame.waiting, Waiting::Pushed));
        // Of more than one the first is told, since what closes it may close the others.
        if let Some(span) = open.next().map(|frame| frame.span)
            && told.is_none()
        {
            self.tell(Code::LeftOpen, span, []);
        }
    }
}
