//! LD as the S7-200 has it: it pushes the result before it, for ALD, OLD and counters to pop. PUSH and POP of the board.

use super::accumulator::Accumulator;
use super::{Acc, Frame, MOST_FRAMES, Machine, Waiting};
use crate::operators::Op;
use std::collections::HashSet;
use unoclp_core::Cause;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::Expr;

/// Results on the stack of an S7-200.
const DEEPEST: usize = 9;

/// The loads whose push something pops, by their lines. All others just load.
#[derive(Default)]
pub(super) struct Pushes {
    pub lines: HashSet<usize>,
    /// Those whose results are on the stack, the top last.
    loads: Vec<usize>,
}

impl Pushes {
    /// A line loads.
    pub fn load(&mut self, line: usize) {
        self.loads.push(line);
        if self.loads.len() > DEEPEST {
            self.loads.remove(0);
        }
    }

    /// A line takes so many results below the top.
    pub fn pop(&mut self, results: usize) {
        for _ in 0..results {
            // The first result has nothing below it.
            if self.loads.len() > 1 {
                self.lines.extend(self.loads.pop());
            }
        }
    }
}

impl<'t, 'f, M: Machine<'t, 'f>> Stack<'t, 'f> for M {}

/// What pushes and pops.
pub(crate) trait Stack<'t, 'f>: Machine<'t, 'f> {
    /// An LD whose result before it is still needed.
    fn push_result(&mut self, span: Span) {
        self.undecided();
        let run = self.run_mut();
        run.unused = None;
        let acc = std::mem::take(&mut run.acc);
        if !matches!(acc, Acc::Empty) {
            run.frames.push(Frame {
                acc,
                waiting: Waiting::Pushed,
                operator: span,
                span,
                links: run.links,
            });
        }
    }

    /// ALD, OLD.
    fn pop_result(&mut self, op: Op, span: Span) {
        let (name, op) = match op {
            Op::AndBlock => ("ALD", Op::And),
            _ => ("OLD", Op::Or),
        };
        let right = self.take(name, span);
        let Some(left) = self.run_mut().popped() else {
            return self.tell(Code::NothingLoaded, span, [name.into()]);
        };
        let made = match (left, right) {
            (Acc::Value(left), Some(right)) => {
                let waiting = Waiting::Deferred(op, false);
                self.joined(waiting, left, right, [span, span])
            }
            _ => None,
        };
        self.hold(made);
        self.link();
    }

    /// PUSH: the number of the accumulator waits, and stays where it is.
    fn push_number(&mut self, number: Expr, span: Span) {
        if self.run().pushed.len() >= MOST_FRAMES {
            return self.refused(Cause::PushedTooDeep, span);
        }
        self.hold(Some(number));
        if self.needed() {
            self.settle_costly();
        }
        let run = self.run_mut();
        if let Acc::Value(held) = run.acc.clone() {
            run.pushed.push((held, span));
        }
        // Nothing needs to be done with it but to take it again.
        run.unused = None;
    }

    /// The number that was pushed last; told where there is none.
    fn popped_number(&mut self, span: Span) -> Option<Expr> {
        let popped = self.run_mut().pushed.pop();
        if popped.is_none() {
            self.refused(Cause::NothingPushed, span);
        }
        popped.map(|(expr, _)| expr)
    }

    /// What is left pushed where the body ends.
    fn end_of_pushed(&mut self) {
        if let Some((_, span)) = self.run_mut().pushed.pop() {
            self.refused(Cause::ValueLeftPushed, span);
        }
    }

    fn refused(&mut self, cause: Cause, span: Span) {
        let words = [cause.number().to_string().into(), cause.text().into()];
        self.tell(Code::Refused, span, words);
    }
}
