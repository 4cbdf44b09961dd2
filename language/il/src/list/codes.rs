//! CODE: an instruction of the board by its numeric codes, with its operand lines.

use super::accumulator::Accumulator;
use super::{Acc, Changes, Machine, Says};
use crate::operators::Op;
use unoclp_codegen::begins;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Codes, Stmt, StmtKind, TypeId, Value};

impl<'t, 'f, M: Machine<'t, 'f>> Verbatim<'t, 'f> for M {}

/// What the text says by its codes.
pub(crate) trait Verbatim<'t, 'f>: Machine<'t, 'f> {
    /// An instruction of the board, each of its codes with its place in the text.
    fn codes(&mut self, codes: Vec<(i32, Span)>, at: Span) {
        self.undecided();
        let run = self.run_mut();
        run.unused = None;
        let before = match std::mem::take(&mut run.acc) {
            Acc::Value(expr) if expr.base == Base::Bool => Some(expr),
            _ => None,
        };
        let Some(&(first, _)) = codes.first() else {
            return;
        };
        self.before(&Changes::Anything, false);
        // What the board's accumulator is goes on to the next code as it is.
        let next = self.run().at + 1;
        let next = (next < self.lines()).then(|| self.says(next));
        let goes_on = matches!(next, Some(Says::Does(next)) if next.op == Some(Op::Code));
        let mut target = None;
        if !goes_on && self.needed() && !begins(first) {
            target = self.own(TypeId::BOOL, at);
        }
        let behind = target.as_ref().map(|target| target.place.clone());
        let codes = Codes {
            before,
            codes,
            behind,
        };
        let kind = StmtKind::Codes(Box::new(codes));
        self.push(Stmt { kind, at });
        let held = match target {
            Some(target) => Some(self.builder().read(Some(target), at)),
            None if begins(first) => {
                let one = Value::truth(true);
                Some(self.builder().literal(Base::Bool, one, at))
            }
            None => None,
        };
        let run = self.run_mut();
        run.links = 0;
        run.acc = held.map_or(Acc::Empty, Acc::Value);
    }
}
