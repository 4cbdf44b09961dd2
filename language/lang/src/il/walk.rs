//! A run through a body on expressions: what it holds on its way.

use super::Front;
use super::blocks::Block;
use super::stack::pushes;
use crate::ast::{Instr, Stmt};
use crate::diagnostics::{Code, Span, Word};
use crate::operators::Op;
use crate::typed::build::Target;
use crate::typed::{Expr, Stmt as Made};
use std::collections::{HashMap, HashSet};
use unoclp_core::isa::Opcode;

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

/// The labels of a body.
#[derive(Debug, Default)]
pub(super) struct Labels {
    /// Where each stands that a jump leads to, by its name.
    pub lines: HashMap<String, usize>,
    /// The statement that each leads to; those behind the body's own are of IF.
    pub places: HashMap<usize, usize>,
    /// Where the accumulator waits that is needed behind a label.
    pub carried: HashMap<usize, Target>,
    /// Jumps whose statement is not known yet, and their labels.
    pub open: Vec<(usize, usize)>,
    pub of_ifs: usize,
    /// Whether the body jumps, wherever to.
    pub wanted: bool,
}

/// An IF that is open.
#[derive(Debug)]
pub(super) struct If {
    pub span: Span,
    pub condition: Option<Expr>,
    /// What is done where the condition holds, once ELSE has come.
    pub first: Option<Vec<Made>>,
    /// With jumps: the labels behind its first part, and behind it.
    pub labels: Option<(usize, usize)>,
    pub other: bool,
}

pub(super) struct Walk<'w, 'a, 'f> {
    pub front: &'w mut Front<'a, 'f>,
    pub body: &'a [Stmt],
    pub unit: usize,
    pub instance: usize,
    /// Whether the accumulator is needed before each line, and behind the last.
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
    pub block: Option<Block>,
    /// N behind a parenthesis: the load that follows is inverted.
    pub inverts: bool,
    /// The result that nothing has used yet.
    pub unused: Option<Span>,
    pub unreachable: bool,
    /// The parenthesis of which it has been told that something cannot stand in it.
    pub told_open: Option<Span>,
    pub labels: Labels,
    pub ifs: Vec<If>,
    /// The statements: of the body, and of each IF that is open.
    pub made: Vec<Vec<Made>>,
    /// Variables of the compiler's own so far.
    pub own: u32,
}

impl<'a> Front<'a, '_> {
    /// What a unit does.
    pub(super) fn body(&mut self, unit: usize) {
        let number = self.numbers[unit];
        let body = &self.units[unit].body;
        self.builder.enter(number);
        let pushed = pushes(body, self.names.dialect);
        let mut walk = Walk {
            unit,
            instance: self.instances[unit],
            body,
            needs: Vec::new(),
            pushed,
            acc: Acc::Empty,
            links: 0,
            frames: Vec::new(),
            lost: 0,
            kept: Vec::new(),
            block: None,
            inverts: false,
            unused: None,
            unreachable: false,
            told_open: None,
            labels: Labels::default(),
            ifs: Vec::new(),
            made: vec![Vec::new()],
            own: 0,
            front: self,
        };
        walk.find_labels();
        walk.find_needs();
        for (at, stmt) in body.iter().enumerate() {
            match stmt {
                Stmt::Label(word) => walk.label(word, at),
                Stmt::Close(span) => walk.close(*span),
                Stmt::Wrong { open, .. } => {
                    walk.unused = None;
                    walk.unreachable = false;
                    walk.acc = Acc::Wrong;
                    walk.lost += open;
                }
                Stmt::Instr(instr) => {
                    walk.reachable(instr);
                    if walk.pushed.contains(&at) {
                        walk.push_result(instr.span);
                    }
                    walk.instr(instr, at);
                }
            }
        }
        let made = walk.finish();
        self.builder.body(number, made);
        self.builder.leave();
    }
}

impl<'a> Walk<'_, 'a, '_> {
    pub(super) fn tell<const N: usize>(&mut self, code: Code, at: Span, words: [Word; N]) {
        self.front.builder.found.tell(code, at, words);
    }

    fn reachable(&mut self, instr: &Instr) {
        // What begins a part or stands behind it is reached in another way.
        let part = matches!(instr.op, Op::Part(Opcode::Else | Opcode::EndIf));
        if std::mem::take(&mut self.unreachable) && !part {
            self.tell(Code::Unreachable, instr.whole, []);
        }
    }

    fn instr(&mut self, instr: &'a Instr, at: usize) {
        match instr.op {
            Op::Load => self.load(instr),
            Op::Store => self.store(instr, at),
            Op::OmronTimer => self.omron_timer(instr, at),
            Op::OmronCounter => self.omron_counter(instr),
            Op::Keep => self.keep_result(instr.whole),
            Op::Recall | Op::Release => self.recall_result(instr),
            Op::Differentiate(_) => self.differentiate(instr, at),
            Op::Set | Op::Reset => self.set_or_reset(instr, at),
            Op::Not => self.not(instr),
            Op::And | Op::Or | Op::Xor | Op::Number(_) | Op::Compare(_) => self.operate(instr, at),
            Op::Shift(opcode) => self.shift(instr, opcode),
            Op::Unary(opcode) => self.unary(instr, opcode),
            Op::Part(opcode) => self.part(instr, opcode),
            Op::Edge(opcode) => self.edge(instr, opcode),
            Op::Jump => self.jump(instr, at),
            Op::Return => self.ret(instr, at),
            Op::End => self.end(instr, at),
            Op::Call => self.call(instr),
            Op::Function => self.function(instr),
            Op::Timer(opcode) => self.timer_operator(instr, opcode, at),
            Op::CountUp | Op::CountDown | Op::CountUpDown => self.count_operator(instr),
            Op::AndBlock | Op::OrBlock => self.pop_result(instr),
            Op::Block => self.begin_block(instr),
            Op::OutBlock => self.out_block(instr),
            Op::EndBlock => self.end_block(instr),
            // The parser has made a store of it.
            Op::Preset => {}
            Op::Input(opcode) => self.input_operator(instr, opcode),
            Op::Push | Op::Table(_) | Op::Code => self.not_yet(instr.span),
        }
    }

    /// What the tree cannot say yet.
    pub(super) fn not_yet(&mut self, at: Span) {
        self.unused = None;
        self.acc = Acc::Wrong;
        let word = self.front.names.written(at);
        self.tell(Code::StUnsupported, at, [word.into(), "".into()]);
    }

    /// Adds a statement that changes nothing which the accumulator reads.
    pub(super) fn push(&mut self, statement: Made) {
        if let Some(made) = self.made.last_mut() {
            made.push(statement);
        }
    }

    pub(super) fn warn_unused(&mut self) {
        if let Some(span) = self.unused.take() {
            self.tell(Code::ResultUnused, span, []);
        }
    }

    fn finish(mut self) -> Vec<Made> {
        self.warn_unused();
        for frame in std::mem::take(&mut self.frames) {
            let told = self.told_open == Some(frame.span);
            if matches!(frame.waiting, Waiting::Deferred(..)) && !told {
                self.tell(Code::LeftOpen, frame.span, []);
            }
        }
        self.end_of_blocks();
        self.end_of_branches();
        self.end_of_ifs();
        self.settle_jumps();
        self.made.swap_remove(0)
    }

    pub(super) fn next(&self, at: usize) -> Option<&'a Stmt> {
        self.body.get(at + 1)
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
