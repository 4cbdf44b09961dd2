//! Instruction List: from lines to the statements of the typed tree.
//!
//! The lines are run once on expressions in place of values, so that `LD a`, `ADD b`, `ST c` come to `c := a + b`.
//!
//! - `walk`: what is held on the way
//! - `accumulator`: what the accumulator holds, and what is put aside of it
//! - `flow`: jumps, labels, IF; what the accumulator is needed for behind a line
//! - `operators`: what each line does
//! - `calls`: functions, blocks, timers, counters, edges; `undeclared`: timers and counters by the board's names

mod accumulator;
mod calls;
mod flow;
mod operators;
mod undeclared;
mod walk;

use super::super::ast::Line;
use super::Checker;
use crate::diagnostics::{Code, Span};
use crate::jumps::Labels;
use crate::operators::Op;
use crate::typed::Stmt;
use unoclp_point::{Kind, Maker, read};
use walk::{Acc, Walk};

/// Operations in one expression, before a part of it is put aside.
const MOST_LINKS: u32 = 40;
/// Operations that wait in one another.
const MOST_FRAMES: usize = 8;

impl Checker<'_, '_, '_> {
    /// The name of a variable, or the address that it is where nothing declares it: `I1` is `%I1`.
    pub(super) fn address(&self, name: &str) -> String {
        let list = self.file.is_list && !name.starts_with('%') && self.builder.find(name).is_none();
        let upper = name.to_uppercase();
        let point = list.then(|| read(&upper, Maker::Iec)).flatten();
        match point.map(|written| written.kind) {
            Some(Kind::Timer | Kind::Counter) | None => name.to_owned(),
            Some(_) => format!("%{name}"),
        }
    }

    /// What lines do.
    pub(super) fn list(&mut self, lines: &[Line]) -> Vec<Stmt> {
        let mut walk = Walk {
            needs: Vec::new(),
            labels: Labels::default(),
            own: 0,
            c: self,
            lines,
            line: 0,
            edges: 0,
            acc: Acc::Empty,
            links: 0,
            frames: Vec::new(),
            lost: false,
            kept: Vec::new(),
            inverts: false,
            unused: None,
            unreachable: false,
            ifs: Vec::new(),
            made: vec![Vec::new()],
        };
        walk.find_labels();
        walk.find_needs();
        for (at, line) in lines.iter().enumerate() {
            (walk.line, walk.edges) = (at, 0);
            match line {
                Line::Label(name) => walk.label(name, at),
                Line::Close(span) => walk.close(*span),
                Line::Wrong => {
                    walk.unreachable = false;
                    walk.unused = None;
                    walk.lost = true;
                    walk.acc = Acc::Wrong;
                }
                Line::Does(instruction) => walk.instruction(instruction, at),
            }
        }
        walk.finish()
    }
}

impl Walk<'_, '_, '_, '_> {
    fn tell<const N: usize>(&mut self, code: Code, at: Span, words: [crate::Word; N]) {
        if code.severity() == crate::Severity::Error {
            self.unused = None;
        }
        self.c.builder.tell(code, at, words);
    }

    /// Adds a statement that changes nothing which the accumulator reads.
    fn push(&mut self, statement: Stmt) {
        if let Some(statements) = self.made.last_mut() {
            statements.push(statement);
        }
    }

    fn warn_unused(&mut self) {
        if let Some(span) = self.unused.take() {
            self.tell(Code::ResultUnused, span, []);
        }
    }

    fn finish(mut self) -> Vec<Stmt> {
        self.warn_unused();
        // Of more than one the first is told, since what closes it may close the others.
        if let Some(frame) = self.frames.first() {
            self.tell(Code::LeftOpen, frame.at, []);
        }
        self.end_of_ifs();
        self.labels.settle(&mut self.made);
        self.made.swap_remove(0)
    }
}

/// Whether this operator loads.
fn is_load(line: Option<&Line>) -> bool {
    matches!(line, Some(Line::Does(one)) if one.spelling.is_some_and(|s| s.op == Op::Load))
}
