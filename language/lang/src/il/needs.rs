//! Where the accumulator is used that a line leaves.

use super::walk::Walk;
use crate::ast::{Instr, Stmt};
use crate::list::Passes;
use crate::operators::Op;
use unoclp_core::isa::Opcode;

impl Walk<'_, '_, '_> {
    /// What each line does with the accumulator, and where it leads.
    pub(super) fn passes(&self) -> impl ExactSizeIterator<Item = Passes> {
        self.body.iter().enumerate().map(|(at, stmt)| {
            let (goes_on, jumps) = match stmt {
                Stmt::Instr(instr) => self.leads(instr),
                _ => (true, None),
            };
            Passes {
                reads: self.reads(stmt, at),
                fills: fills(stmt),
                goes_on,
                jumps,
            }
        })
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
        let label = name.and_then(|name| self.run.labels.lines.get(name).copied());
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
