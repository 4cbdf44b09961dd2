//! What is done where the accumulator is 1.

use super::run::{Acc, Changes};
use super::walk::Walk;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Stmt, StmtKind};

impl Walk<'_, '_, '_> {
    /// Statements where the accumulator is 1: with those before them, where these are decided by the same.
    pub(super) fn decide(&mut self, mut body: Vec<Stmt>, span: Span) {
        for statement in &body {
            match &statement.kind {
                StmtKind::Assign(place, ..) => self.before_others(&Changes::Cells(place, 1)),
                StmtKind::Order(_, block, place) => {
                    self.before_others(&Changes::Cells(place, block.cells()));
                }
                _ => self.before_others(&Changes::Anything),
            }
        }
        let needed = self.needed();
        let run = &mut self.run;
        if let Some(state) = run.decided.take() {
            if let Some(Stmt {
                kind: StmtKind::If(arms, otherwise),
                ..
            }) = run.made.last_mut().and_then(|made| made.last_mut())
            {
                match (state, arms.first_mut()) {
                    (true, Some((_, then))) if otherwise.is_empty() => then.append(&mut body),
                    _ => otherwise.append(&mut body),
                }
            }
            run.decided = Some(state).filter(|_| needed);
            return;
        }
        let Acc::Value(condition) = run.acc.clone() else {
            return;
        };
        let kind = StmtKind::If(vec![(condition, body)], Vec::new());
        self.push(Stmt { kind, at: span });
        self.run.decided = Some(true).filter(|_| needed);
    }
}
