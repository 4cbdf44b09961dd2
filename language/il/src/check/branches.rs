//! MPS, MRD, MPP, and LPS, LRD, LPP: one result for several branches.

use super::run::{Acc, MOST_FRAMES};
use super::walk::Walk;
use crate::operators::Op;
use unoclp_text::diagnostics::{Code, Span};

impl Walk<'_, '_, '_> {
    /// MPS: the accumulator is kept, and stays what it is.
    pub(super) fn keep_result(&mut self, span: Span) {
        let expr = self.take("MPS", span);
        let deep = self.run.kept.len();
        // Told once.
        if deep == MOST_FRAMES {
            self.tell(Code::TooDeep, span, []);
            self.run.kept.push((Acc::Wrong, span));
        }
        if deep >= MOST_FRAMES {
            return;
        }
        self.hold(expr);
        // What takes more than one code is worked out once.
        self.settle_costly();
        let acc = self.run.acc.clone();
        self.run.kept.push((acc, span));
    }

    /// MRD and MPP: what was kept last; MPP keeps it no longer.
    pub(super) fn recall_result(&mut self, op: Op, span: Span, whole: Span) {
        self.warn_unused();
        let run = &mut self.run;
        let kept = match op {
            Op::Release => run.kept.pop(),
            _ => run.kept.last().cloned(),
        };
        let Some((acc, _)) = kept else {
            run.acc = Acc::Wrong;
            let why = (
                "write MPS, or LPS, where the branches begin",
                "escreva MPS, ou LPS, onde as ramificações começam",
            );
            let word = self.built().written(span);
            return self.tell(Code::Structure, span, [word.into(), why.into()]);
        };
        run.unused = Some(whole);
        run.links = 0;
        run.acc = acc;
    }

    /// Where a body ends.
    pub(super) fn end_of_branches(&mut self) {
        let kept = std::mem::take(&mut self.run.kept);
        // That they are too many has been told.
        let kept = if kept.len() > MOST_FRAMES {
            Vec::new()
        } else {
            kept
        };
        for (_, span) in kept {
            let why = (
                "write MPP, or LPP, before the last branch",
                "escreva MPP, ou LPP, antes da última ramificação",
            );
            let word = self.built().written(span);
            self.tell(Code::Structure, span, [word.into(), why.into()]);
        }
    }
}
