//! Operations that are deferred: from `(` to `)`.

use super::bits::name;
use super::walk::Walk;
use crate::ast::{Instr, Open, Stmt};
use crate::list::{Defers, Opens, Waiting};
use crate::operators::Op;

impl Walk<'_, '_, '_> {
    /// `AND(`
    pub(super) fn open(&mut self, instr: &Instr, open: Open) {
        let next = self.next();
        let opens = Opens {
            what: name(instr.op),
            operator: instr.span,
            at: open.span,
            negated: open.negated,
            loads: matches!(next, Some(Stmt::Instr(next)) if next.op == Op::Load),
        };
        let waiting = Waiting::Deferred(instr.op, instr.negated);
        let first = instr.operands.first().map(|operand| {
            move |walk: &mut Self| {
                walk.only(instr, 1);
                walk.run.unused = Some(instr.whole);
                walk.value(operand)
            }
        });
        self.defer(waiting, &opens, first);
    }
}
