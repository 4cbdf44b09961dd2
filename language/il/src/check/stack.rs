//! LD as the S7-200 has it: it pushes the result before it, for ALD, OLD and counters to pop. PUSH and POP of the board.

use super::run::{Acc, Frame, MOST_FRAMES, Waiting};
use super::walk::Walk;
use crate::ast::Instr;
use crate::operators::Op;
use std::collections::HashSet;
use unoclp_core::Cause;
use unoclp_text::Dialect;
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

/// How many results below the top an instruction takes: a counter in the S7-200's form, `CTU C2, 20`, more than one.
pub(super) fn pops(instr: &Instr, dialect: Dialect) -> usize {
    match instr.op {
        Op::AndBlock | Op::OrBlock => 1,
        Op::OmronCounter => 1,
        _ if dialect != Dialect::S7200 => 0,
        Op::CountUp | Op::CountDown if instr.operands.len() == 2 => 1,
        Op::CountUpDown if instr.operands.len() == 2 => 2,
        _ => 0,
    }
}

impl Walk<'_, '_, '_> {
    /// An LD whose result before it is still needed.
    pub(super) fn push_result(&mut self, span: Span) {
        self.undecided();
        let run = &mut self.run;
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
    pub(super) fn pop_result(&mut self, op: Op, span: Span) {
        let (name, op) = match op {
            Op::AndBlock => ("ALD", Op::And),
            _ => ("OLD", Op::Or),
        };
        let right = self.take(name, span);
        let Some(left) = self.run.popped() else {
            return self.tell(Code::NothingLoaded, span, [name.into()]);
        };
        let made = match (left, right) {
            (Acc::Value(left), Some(right)) => self.apply(op, false, left, right, span),
            _ => None,
        };
        self.hold(made);
        self.link();
    }

    /// PUSH: the number of the accumulator waits, and stays where it is.
    pub(super) fn push_number(&mut self, number: Expr, span: Span) {
        if self.run.pushed.len() >= MOST_FRAMES {
            return self.refused(Cause::PushedTooDeep, span);
        }
        self.hold(Some(number));
        if self.needed() {
            self.settle_costly();
        }
        let run = &mut self.run;
        if let Acc::Value(held) = run.acc.clone() {
            run.pushed.push((held, span));
        }
        // Nothing needs to be done with it but to take it again.
        run.unused = None;
    }

    /// The number that was pushed last; told where there is none.
    pub(super) fn popped_number(&mut self, span: Span) -> Option<Expr> {
        let popped = self.run.pushed.pop();
        if popped.is_none() {
            self.refused(Cause::NothingPushed, span);
        }
        popped.map(|(expr, _)| expr)
    }

    /// What is left pushed where the body ends.
    pub(super) fn end_of_pushed(&mut self) {
        if let Some((_, span)) = self.run.pushed.pop() {
            self.refused(Cause::ValueLeftPushed, span);
        }
    }

    fn refused(&mut self, cause: Cause, span: Span) {
        let words = [cause.number().to_string().into(), cause.text().into()];
        self.tell(Code::Refused, span, words);
    }
}
