//! CODE: an instruction of the board by its numeric codes, with its operand lines.

use super::run::{Acc, Changes};
use super::walk::Walk;
use crate::ast::{Instr, Stmt as Line};
use crate::operators::Op;
use unoclp_core::isa::{Kind, Row, TABLE};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::codes::begins;
use unoclp_tree::{Base, Codes, Stmt, StmtKind, TypeId, Value};

impl Walk<'_, '_, '_> {
    pub(super) fn code(&mut self, instr: &Instr) {
        let span = instr.whole;
        self.front.writes = true;
        if instr.operands.is_empty() {
            return self.missing("CODE", span);
        }
        let mut codes = Vec::new();
        for operand in &instr.operands {
            match operand.number() {
                Some(code) => codes.push((code, operand.span)),
                None => {
                    let text = self.spelled(operand);
                    let range = ("a numeric code", "um código numérico");
                    self.tell(Code::BadValue, operand.span, [text.into(), range.into()]);
                }
            }
        }
        if let Some(&(first, _)) = codes.first() {
            self.front.names.inputs_read |= inputs_read(first);
        }
        self.codes(codes, span);
    }

    /// An instruction of the board, each of its codes with its place in the text.
    fn codes(&mut self, codes: Vec<(i32, Span)>, at: Span) {
        self.undecided();
        let run = &mut self.run;
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
        let goes_on = matches!(self.next(), Some(Line::Instr(next)) if next.op == Op::Code);
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
        let run = &mut self.run;
        run.links = 0;
        run.acc = held.map_or(Acc::Empty, Acc::Value);
    }
}

/// The inputs that a code of the text reads: bit 0 is input 01.
fn inputs_read(code: i32) -> u128 {
    let reads = |row: &&Row| {
        let number = code.unsigned_abs().wrapping_sub(row.code.unsigned_abs());
        row.kind == Kind::Input && row.code.signum() == code.signum() && number < 100
    };
    let Some(row) = TABLE.iter().find(reads) else {
        return 0;
    };
    let number = code.unsigned_abs() - row.code.unsigned_abs();
    let bit = number.checked_sub(1).and_then(|bit| 1u128.checked_shl(bit));
    bit.unwrap_or(0)
}
