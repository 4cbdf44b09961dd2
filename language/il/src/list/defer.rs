//! Operations that are deferred: from `(` to `)`.

use super::accumulator::Accumulator;
use super::{Acc, Frame, MOST_FRAMES, Machine, Waiting};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Expr, ExprKind};

/// A parenthesis that opens.
pub(crate) struct Opens<'o> {
    /// What messages call the operator.
    pub what: &'o str,
    pub operator: Span,
    pub at: Span,
    /// N after it: the first operand is inverted.
    pub negated: bool,
    /// Its first operand is loaded by the line that follows.
    pub loads: bool,
}

impl<'t, 'f, M: Machine<'t, 'f>> Defers<'t, 'f> for M {}

/// What waits for its `)`.
pub(crate) trait Defers<'t, 'f>: Machine<'t, 'f> {
    /// `AND(`: the accumulator and the operation wait; `first` is its operand.
    fn defer(
        &mut self,
        waiting: Waiting,
        opens: &Opens,
        first: Option<impl FnOnce(&mut Self) -> Option<Expr>>,
    ) {
        if self.run().lost > 0 || self.run().frames.len() >= MOST_FRAMES {
            return self.lose(opens);
        }
        let mut left = self.take(opens.what, opens.operator);
        let links = self.run().links;
        let mut inner = match first {
            Some(first) => first(self).map_or(Acc::Wrong, Acc::Value),
            // N inverts what is loaded.
            None if opens.loads => {
                self.run_mut().inverts = opens.negated;
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
            inner = Acc::Value(self.inverted(expr, opens.at));
        }
        let run = self.run_mut();
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
        if self.run().lost == 0 {
            self.tell(Code::TooDeep, opens.at, []);
        }
        self.take(opens.what, opens.operator);
        self.run_mut().acc = Acc::Wrong;
        self.run_mut().lost += 1;
    }

    /// `)`: the operation that was deferred last is done.
    fn close(&mut self, span: Span) {
        let run = self.run_mut();
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
            (Acc::Value(left), Some(right)) => {
                self.joined(frame.waiting, left, right, [frame.operator, span])
            }
            _ => None,
        };
        self.hold(made);
        self.run_mut().links += frame.links;
        self.link();
    }

    /// Tells what is left open where a body ends.
    fn end_of_frames(&mut self) {
        let told = self.run().told_open;
        let frames = self.run().frames.iter();
        let mut open = frames.filter(|frame| !matches!(frame.waiting, Waiting::Pushed));
        // Of more than one the first is told, since what closes it may close the others.
        if let Some(span) = open.next().map(|frame| frame.span)
            && told.is_none()
        {
            self.tell(Code::LeftOpen, span, []);
        }
    }
}
