//! Where the accumulator is used that a line leaves.

use super::walk::Walk;
use crate::ast::{Instr, Stmt};
use crate::operators::Op;
use std::collections::HashMap;
use unoclp_core::isa::Opcode;

impl Walk<'_, '_, '_> {
    /// Walks back from each line that uses the accumulator to those that fill it.
    pub(super) fn find_needs(&mut self) {
        let count = self.body.len();
        let mut goes_on = vec![true; count];
        let mut jumps: HashMap<usize, Vec<usize>> = HashMap::new();
        let mut filled = vec![false; count];
        let mut todo = Vec::new();
        for (at, stmt) in self.body.iter().enumerate() {
            if self.reads(stmt, at) {
                todo.push(at);
            } else {
                filled[at] = fills(stmt);
            }
            if let Stmt::Instr(instr) = stmt {
                let (next, label) = self.leads(instr);
                goes_on[at] = next;
                if let Some(label) = label {
                    jumps.entry(label).or_default().push(at);
                }
            }
        }
        self.needs = vec![false; count + 1];
        while let Some(at) = todo.pop() {
            if std::mem::replace(&mut self.needs[at], true) {
                continue;
            }
            let before = at.checked_sub(1).filter(|&before| goes_on[before]);
            let jumps = jumps.get(&at).into_iter().flatten().copied();
            todo.extend(before.into_iter().chain(jumps).filter(|&one| !filled[one]));
        }
    }

    /// Whether a line begins with what the accumulator holds.
    fn reads(&self, stmt: &Stmt, at: usize) -> bool {
        let instr = match stmt {
            Stmt::Instr(instr) => instr,
            Stmt::Close(_) => return true,
            Stmt::Label(_) | Stmt::Wrong { .. } => return false,
        };
        match instr.op {
            Op::Load => self.pushed.contains(&at),
            Op::Recall | Op::Release | Op::End | Op::Block | Op::OutBlock | Op::EndBlock => false,
            Op::Jump | Op::Return | Op::Call => instr.conditional,
            Op::Part(opcode) => opcode == Opcode::If,
            Op::Function => self.takes_accumulator(instr),
            _ => true,
        }
    }

    /// Whether the next line comes after this, and the line of the label that it may go to.
    fn leads(&self, instr: &Instr) -> (bool, Option<usize>) {
        let name = instr.operands.first().and_then(|operand| operand.name());
        let label = name.and_then(|name| self.labels.lines.get(name).copied());
        match instr.op {
            Op::Jump => (instr.conditional, label),
            Op::Return => (instr.conditional, None),
            Op::End => (false, None),
            _ => (true, None),
        }
    }
}

/// Whether a line that does not read the accumulator fills or forgets it.
fn fills(stmt: &Stmt) -> bool {
    match stmt {
        Stmt::Instr(instr) => !matches!(instr.op, Op::Jump | Op::Return | Op::End),
        Stmt::Close(_) | Stmt::Label(_) => false,
        Stmt::Wrong { .. } => true,
    }
}
