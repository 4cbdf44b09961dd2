//! Instruction List: from lines to the statements of the typed tree.
//!
//! - `walk`: the machine that the lines are run on, with the types of the text
//! - `flow`: jumps and RET
//! - `operators`: what each line does
//! - `board`: the board's own words
//! - `calls`: functions, blocks, timers, counters, edges; `undeclared`: timers and counters by the board's names

mod board;
mod calls;
mod flow;
mod operators;
mod undeclared;
mod walk;

use super::super::ast::Line;
use super::Checker;
use crate::list::{Flow, Lines, Run, Stack};
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
        };
        walk.run_lines();
        walk.end_of_pushed();
        walk.end_of_ifs();
        walk.statements()
    }
}
