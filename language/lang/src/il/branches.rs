//! MPS, MRD, MPP, and LPS, LRD, LPP: one result for several branches.

use super::defer::MOST_FRAMES;
use super::walk::{Acc, Walk};
use crate::ast::Instr;
use crate::diagnostics::{Code, Span};
use crate::operators::Op;

impl Walk<'_, '_, '_> {
    /// MPS: the accumulator is kept, and stays what it is.
    pub(super) fn keep_result(&mut self, span: Span) {
        let expr = self.take("MPS", span);
        if self.kept.len() >= MOST_FRAMES {
            return self.tell(Code::TooDeep, span, []);
        }
        self.hold(expr);
        // What takes more than one code is worked out once.
        self.settle_costly();
        self.kept.push((self.acc.clone(), span));
    }

    /// MRD and MPP: what was kept last; MPP keeps it no longer.
    pub(super) fn recall_result(&mut self, instr: &Instr) {
        self.warn_unused();
        let kept = match instr.op {
            Op::Release => self.kept.pop(),
            _ => self.kept.last().cloned(),
        };
        let Some((acc, _)) = kept else {
            let word = self.front.names.written(instr.span);
            let why = (
                "write MPS, or LPS, where the branches begin",
                "escreva MPS, ou LPS, onde as ramificações começam",
            );
            self.tell(Code::Structure, instr.span, [word.into(), why.into()]);
            self.acc = Acc::Wrong;
            return;
        };
        self.unused = Some(instr.whole);
        self.links = 0;
        self.acc = acc;
    }

    /// Where a body ends.
    pub(super) fn end_of_branches(&mut self) {
        for (_, span) in std::mem::take(&mut self.kept) {
            let word = self.front.names.written(span);
            let why = (
                "write MPP, or LPP, before the last branch",
                "escreva MPP, ou LPP, antes da última ramificação",
            );
            self.tell(Code::Structure, span, [word.into(), why.into()]);
        }
    }
}
