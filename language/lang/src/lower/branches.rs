//! MPS, MRD, MPP, and LPS, LRD, LPP: one result for several branches.

use super::{Acc, Lower, MOST_FRAMES};
use crate::ast::Instr;
use crate::diagnostics::{Code, Span};
use crate::operators::Op;
use crate::tree::{Bit, Expr, Number};
use unoclp_point::Address;

impl Lower<'_, '_> {
    /// MPS: the accumulator is kept, and stays what it is.
    pub(super) fn keep_result(&mut self, span: Span) {
        let acc = self.take_acc("MPS", span);
        if self.kept.len() >= MOST_FRAMES {
            self.found.tell(Code::TooDeep, span, []);
            return;
        }
        // What takes more than one code is worked out once.
        let simple = matches!(
            acc,
            Acc::Bit(Expr::Lit { .. } | Expr::Const(_))
                | Acc::Number(Number::Leaf(..))
                | Acc::Unknown
        );
        if !simple {
            self.freeze(span);
        }
        let acc = if simple { acc } else { self.fixed(acc, span) };
        self.kept.push((acc.clone(), span));
        self.acc = acc;
    }

    /// MRD and MPP: what was kept last; MPP keeps it no longer.
    pub(super) fn recall_result(&mut self, instr: &Instr) {
        self.warn_unused();
        let kept = match instr.op {
            Op::Release => self.kept.pop(),
            _ => self.kept.last().cloned(),
        };
        let Some((acc, _)) = kept else {
            let word = self.names.written(instr.span);
            let why = (
                "write MPS, or LPS, where the branches begin",
                "escreva MPS, ou LPS, onde as ramificações começam",
            );
            self.found
                .tell(Code::Structure, instr.span, [word.into(), why.into()]);
            self.acc = Acc::Unknown;
            return;
        };
        self.unused = Some(instr.whole);
        self.links = 0;
        self.acc = acc;
    }

    /// Before anything changes. Inputs stay what they are throughout a scan.
    pub(super) fn freeze_branches(&mut self) {
        let mut kept = std::mem::take(&mut self.kept);
        for (acc, span) in &mut kept {
            let input = matches!(
                acc,
                Acc::Bit(Expr::Lit {
                    bit: Bit::At(Address::Input(_)),
                    ..
                })
            );
            if !input {
                *acc = self.fixed(std::mem::replace(acc, Acc::Unknown), *span);
            }
        }
        self.kept = kept;
    }

    /// Where a body ends.
    pub(super) fn end_of_branches(&mut self) {
        for (_, span) in std::mem::take(&mut self.kept) {
            let word = self.names.written(span);
            let why = (
                "write MPP, or LPP, before the last branch",
                "escreva MPP, ou LPP, antes da última ramificação",
            );
            self.found
                .tell(Code::Structure, span, [word.into(), why.into()]);
        }
    }
}
