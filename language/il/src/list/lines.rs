//! The run through a body, line by line.

use super::accumulator::Accumulator;
use super::defer::Defers;
use super::flow::Flow;
use super::labels::{Passes, needed};
use super::says::Says;
use super::stack::{Pushes, Stack};
use super::{Acc, Machine};
use crate::operators::Op;
use std::borrow::Cow;
use std::collections::HashSet;
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::Code;

impl<'t, 'f, M: Machine<'t, 'f>> Lines<'t, 'f> for M {}

/// What is done with all lines.
pub(crate) trait Lines<'t, 'f>: Machine<'t, 'f> {
    /// Runs the body.
    fn run_lines(&mut self) {
        self.prepare();
        for at in 0..self.lines() {
            self.run_mut().at = at;
            match self.says(at) {
                Says::Label(key, span) => {
                    let key = key.into_owned();
                    self.label(&key, span);
                }
                Says::Close(span) => self.close(span),
                Says::Wrong(open) => {
                    let run = self.run_mut();
                    run.unused = None;
                    run.unreachable = false;
                    run.acc = Acc::Wrong;
                    run.lost += open;
                }
                Says::Does(does) => {
                    // What begins a part or stands after it is reached in another way.
                    let part = matches!(does.op, Some(Op::Part(Opcode::Else | Opcode::EndIf)));
                    let (span, whole) = (does.span, does.whole);
                    if std::mem::take(&mut self.run_mut().unreachable) && !part {
                        self.tell(Code::Unreachable, whole, []);
                    }
                    if self.run().pushes.contains(&at) {
                        self.push_result(span);
                    }
                    self.line(at);
                }
            }
        }
        self.warn_unused();
        self.end_of_frames();
    }

    /// Finds the labels, and the lines that need what the one before leaves.
    fn prepare(&mut self) {
        let mut labels = Vec::new();
        let mut wanted = HashSet::new();
        let mut pushes = Pushes::default();
        for at in 0..self.lines() {
            match self.says(at) {
                Says::Label(key, span) => labels.push((at, key.into_owned(), span)),
                Says::Does(does) => {
                    if does.op == Some(Op::Load) {
                        pushes.load(at);
                    }
                    pushes.pop(does.pops);
                    let label = does.label.filter(|_| does.op == Some(Op::Jump));
                    wanted.extend(label.map(Cow::into_owned));
                }
                Says::Close(_) | Says::Wrong(_) => {}
            }
        }
        self.run_mut().jumps = !wanted.is_empty();
        self.run_mut().pushes = pushes.lines;
        self.find_labels(labels, &wanted);
        self.run_mut().needs = needed((0..self.lines()).map(|at| self.passes(at)));
    }

    fn passes(&self, at: usize) -> Passes {
        let all = Passes {
            reads: false,
            fills: false,
            goes_on: true,
            jumps: None,
        };
        let does = match self.says(at) {
            Says::Label(..) => return all,
            Says::Close(_) => return Passes { reads: true, ..all },
            Says::Wrong(_) => return Passes { fills: true, ..all },
            Says::Does(does) => does,
        };
        let leads = matches!(does.op, Some(Op::Jump | Op::Return | Op::End));
        let label = does.label.filter(|_| does.op == Some(Op::Jump));
        Passes {
            reads: match does.op {
                Some(Op::Jump | Op::Return | Op::Call) => does.conditional,
                Some(Op::Load) => self.run().pushes.contains(&at),
                Some(Op::Recall | Op::Release | Op::End) => false,
                Some(Op::Part(opcode)) => opcode == Opcode::If,
                _ => self.reads(at),
            },
            fills: !leads,
            goes_on: !leads || does.conditional,
            jumps: label.and_then(|key| self.run().labels.lines.get(&*key).copied()),
        }
    }
}
