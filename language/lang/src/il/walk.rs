//! A run through a body on expressions: what it holds on its way.

use super::front::Front;
use crate::ast::{Instr, Operand, Stmt};
use crate::diagnostics::{Code, Span, Word};
use crate::jumps::{If, Labels};
use crate::operators::Op;
use crate::typed::build::Target;
use crate::typed::{Expr, Standard, Stmt as Made};
use std::collections::HashSet;

/// What the accumulator holds.
#[derive(Clone, Debug)]
pub(super) enum Acc {
    Empty,
    /// What is wrong has been told.
    Wrong,
    Value(Expr),
}

/// What a result waits for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Waiting {
    /// For `)`, with N where the result is inverted.
    Deferred(Op, bool),
    /// For ALD, OLD, or a counter with more than one input.
    Pushed,
}

/// A result that waits.
#[derive(Debug)]
pub(super) struct Frame {
    pub acc: Acc,
    pub waiting: Waiting,
    pub span: Span,
    pub links: u32,
}

/// A block whose inputs are being connected.
pub(super) struct Block {
    pub operand: Operand,
    pub block: Option<(Target, Standard)>,
    pub name: String,
    pub span: Span,
    /// IN, or CU.
    pub start: Option<Expr>,
    pub down: Option<Expr>,
    pub reset: Option<Expr>,
    pub set: Option<Expr>,
    /// It stands in the program; what follows uses its outputs.
    pub written: bool,
}

pub(super) struct Walk<'w, 'a, 'f> {
    pub front: &'w mut Front<'a, 'f>,
    pub body: &'a [Stmt],
    pub unit: usize,
    pub instance: usize,
    /// Whether the accumulator is needed before each line, and after the last.
    pub needs: Vec<bool>,
    /// The loads that push the result before them.
    pub pushed: HashSet<usize>,
    pub acc: Acc,
    /// Operations in the accumulator's expression.
    pub links: u32,
    pub frames: Vec<Frame>,
    /// Parentheses whose operations are lost to an error.
    pub lost: usize,
    /// What MPS has kept, and where.
    pub kept: Vec<(Acc, Span)>,
    /// What PUSH has pushed, and where.
    pub pushed_numbers: Vec<(Expr, Span)>,
    pub block: Option<Block>,
    /// N after a parenthesis: the load that follows is inverted.
    pub inverts: bool,
    /// The result that nothing has used yet.
    pub unused: Option<Span>,
    pub unreachable: bool,
    /// The line that is run.
    pub at: usize,
    /// Whether the accumulator is the condition of the IF that was made last, or its opposite.
    pub decided: Option<bool>,
    /// The parenthesis of which it has been told that something cannot stand in it.
    pub told_open: Option<Span>,
    pub labels: Labels,
    /// Whether the body jumps, wherever to.
    pub jumps: bool,
    pub ifs: Vec<If>,
    /// The statements: of the body, and of each IF that is open.
    pub made: Vec<Vec<Made>>,
    /// Variables of the compiler's own so far.
    pub own: u32,
}

impl<'a> Walk<'_, 'a, '_> {
    pub(super) fn tell<const N: usize>(&mut self, code: Code, at: Span, words: [Word; N]) {
        self.front.builder.found.tell(code, at, words);
    }

    /// What no operator of this reader comes to.
    pub(super) fn not_yet(&mut self, at: Span) {
        self.unused = None;
        self.acc = Acc::Wrong;
        let word = self.front.names.written(at);
        self.tell(Code::StUnsupported, at, [word.into(), "".into()]);
    }

    /// Adds a statement that changes nothing which the accumulator reads.
    pub(super) fn push(&mut self, statement: Made) {
        self.undecided();
        if let Some(made) = self.made.last_mut() {
            made.push(statement);
        }
    }

    pub(super) fn warn_unused(&mut self) {
        if let Some(span) = self.unused.take() {
            self.tell(Code::ResultUnused, span, []);
        }
    }

    /// Whether the accumulator is used after the line that is run.
    pub(super) fn needed(&self) -> bool {
        self.needs.get(self.at + 1).copied().unwrap_or_default()
    }

    pub(super) fn next(&self) -> Option<&'a Stmt> {
        self.body.get(self.at + 1)
    }

    /// An instruction takes so many operands, and no more.
    pub(super) fn only(&mut self, instr: &Instr, most: usize) {
        if let Some(more) = instr.operands.get(most) {
            let text = self.spelled(more);
            self.tell(Code::Unexpected, more.span, [text.into()]);
        }
    }

    pub(super) fn missing(&mut self, what: &str, span: Span) {
        let example: (&str, &str) = match what {
            "ST" | "S" | "R" => ("Q1 or M1", "Q1 ou M1"),
            "JMP" => ("the name of a label", "o nome de um rótulo"),
            "CAL" | "BLK" | "IN" | "TON" | "TOF" | "TP" | "TONR" => ("T1 or C1", "T1 ou C1"),
            "CU" | "CD" | "CTU" | "CTD" | "CTUD" => ("C1", "C1"),
            "CLK" => ("the name of an R_TRIG", "o nome de um R_TRIG"),
            "CODE" => ("827301", "827301"),
            _ => ("I1, Q1 or M1", "I1, Q1 ou M1"),
        };
        self.tell(Code::OperandMissing, span, [what.into(), example.into()]);
    }
}

/// Whether a load comes next, so that the accumulator is needed no more.
pub(super) fn loads(next: Option<&Stmt>) -> bool {
    matches!(next, Some(Stmt::Instr(instr)) if instr.op == Op::Load)
}
