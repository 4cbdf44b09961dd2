//! Instruction List: from lines to the statements of the typed tree.
//!
//! - `walk`: the machine that the lines are run on, with the types of the text
//! - `flow`: which lines read the accumulator, and where they lead
//! - `operators`: what each line does
//! - `calls`: functions, blocks, timers, counters, edges; `undeclared`: timers and counters by the board's names

mod calls;
mod flow;
mod operators;
mod undeclared;
mod walk;

use super::super::ast::Line;
use super::Checker;
use crate::diagnostics::Code;
use crate::list::{Acc, Accumulator, Flow, Machine, Run, needed};
use crate::operators::Op;
use crate::typed::Stmt;
use unoclp_point::{Kind, Maker, read};
use walk::Walk;

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
            c: self,
            lines,
            run: Run::new(),
            edges: 0,
            lost: false,
            inverts: false,
        };
        walk.labels_of_body();
        walk.run.needs = needed(walk.passes());
        for (at, line) in lines.iter().enumerate() {
            (walk.run.at, walk.edges) = (at, 0);
            match line {
                Line::Label(name) => walk.label(&name.text.to_uppercase(), name.span),
                Line::Close(span) => walk.close(*span),
                Line::Wrong => {
                    walk.run.unreachable = false;
                    walk.run.unused = None;
                    walk.lost = true;
                    walk.run.acc = Acc::Wrong;
                }
                Line::Does(instruction) => walk.instruction(instruction),
            }
        }
        walk.finish()
    }
}

impl Walk<'_, '_, '_, '_> {
    fn finish(mut self) -> Vec<Stmt> {
        self.warn_unused();
        // Of more than one the first is told, since what closes it may close the others.
        let open = self.run.frames.first().map(|frame| frame.span);
        if let Some(open) = open.filter(|_| self.run.told_open.is_none()) {
            self.tell(Code::LeftOpen, open, []);
        }
        self.end_of_ifs();
        self.statements()
    }
}

/// Whether this operator loads.
fn is_load(line: Option<&Line>) -> bool {
    matches!(line, Some(Line::Does(one)) if one.spelling.is_some_and(|s| s.op == Op::Load))
}
