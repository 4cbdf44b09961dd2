//! LD as the S7-200 has it: it pushes the result before it, for ALD, OLD and counters to pop.

use super::walk::Walk;
use crate::Dialect;
use crate::ast::{Instr, Stmt};
use crate::diagnostics::{Code, Span};
use crate::list::{Acc, Accumulator, Frame, Machine, Waiting};
use crate::operators::Op;
use std::collections::HashSet;

/// Results on the stack of an S7-200.
const DEEPEST: usize = 9;

/// The indices of the loads whose push something pops. All others just load.
pub(super) fn pushes(body: &[Stmt], dialect: Dialect) -> HashSet<usize> {
    let mut pushes = HashSet::new();
    // The loads whose results are on the stack, the top last.
    let mut loads: Vec<usize> = Vec::new();
    for (index, stmt) in body.iter().enumerate() {
        let Stmt::Instr(instr) = stmt else { continue };
        let pops = match instr.op {
            Op::Load => {
                loads.push(index);
                if loads.len() > DEEPEST {
                    loads.remove(0);
                }
                0
            }
            Op::AndBlock | Op::OrBlock => 1,
            op => more_inputs(op, instr, dialect),
        };
        for _ in 0..pops {
            // The first result has nothing below it.
            if loads.len() > 1 {
                pushes.extend(loads.pop());
            }
        }
    }
    pushes
}

/// How many results below the top a counter takes in the S7-200's form, `CTU C2, 20`.
pub(super) fn more_inputs(op: Op, instr: &Instr, dialect: Dialect) -> usize {
    match op {
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
        self.run.unused = None;
        let acc = std::mem::replace(&mut self.run.acc, Acc::Empty);
        if matches!(acc, Acc::Empty) {
            return;
        }
        self.run.frames.push(Frame {
            acc,
            waiting: Waiting::Pushed,
            span,
            links: self.run.links,
        });
    }

    /// The result that was pushed last.
    pub(super) fn popped(&mut self) -> Option<Acc> {
        match self.run.frames.last() {
            Some(Frame {
                waiting: Waiting::Pushed,
                ..
            }) => self.run.frames.pop().map(|frame| {
                self.run.links += frame.links;
                frame.acc
            }),
            _ => None,
        }
    }

    /// ALD, OLD.
    pub(super) fn pop_result(&mut self, instr: &Instr) {
        let (name, op) = match instr.op {
            Op::AndBlock => ("ALD", Op::And),
            _ => ("OLD", Op::Or),
        };
        let right = self.take(name, instr.span);
        let Some(left) = self.popped() else {
            return self.tell(Code::NothingLoaded, instr.span, [name.into()]);
        };
        let made = match (left, right) {
            (Acc::Value(left), Some(right)) => self.apply(op, false, left, right, instr.span),
            _ => None,
        };
        self.hold(made);
        self.link();
    }
}
