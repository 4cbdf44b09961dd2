//! IF, ELSE and END_IF: parts of a program that one condition decides on.

use super::{Acc, Lower};
use crate::ast::Instr;
use crate::diagnostics::Code;
use crate::rung::{Holds, Written};
use unoclp_core::isa::Opcode;

impl Lower<'_, '_> {
    pub(super) fn part(&mut self, instr: &Instr, opcode: Opcode) {
        let span = instr.span;
        let word = self.names.written(span);
        self.not_deferred(&word, span);
        self.kept.clear();
        if opcode == Opcode::If {
            let Some(condition) = self.take_condition("IF", span) else {
                return;
            };
            self.bring(condition, span);
            self.ifs.push((span, false));
        } else {
            self.warn_unused();
            let open = match self.ifs.last_mut() {
                Some((_, other)) if opcode == Opcode::Else => !std::mem::replace(other, true),
                Some(_) => self.ifs.pop().is_some(),
                None => false,
            };
            if !open {
                let why = (
                    "write IF before it, with one ELSE at most",
                    "escreva IF antes, com um só ELSE no máximo",
                );
                self.found
                    .tell(Code::Structure, span, [word.into(), why.into()]);
                return;
            }
        }
        self.rungs.write(Written::Plain(opcode), span);
        self.rungs.holds = Holds::One;
        self.rungs.head = true;
        self.acc = Acc::Empty;
    }

    /// Tells which IFs have no END_IF.
    pub(super) fn end_of_ifs(&mut self) {
        for (span, _) in std::mem::take(&mut self.ifs) {
            let word = self.names.written(span);
            let why = ("write END_IF after it", "escreva END_IF depois dele");
            self.found
                .tell(Code::Structure, span, [word.into(), why.into()]);
        }
    }
}
