//! CODE: an instruction of the board by its numeric codes, with its operand lines.

use super::walk::Walk;
use crate::ast::{Instr, Stmt};
use crate::code::begins;
use crate::diagnostics::Code;
use crate::list::{Acc, Accumulator, Changes, Machine};
use crate::operators::Op;
use crate::typed::{Base, Codes, Stmt as Made, StmtKind, TypeId};
use unoclp_core::isa::{Kind, Row, TABLE};

impl Walk<'_, '_, '_> {
    pub(super) fn code(&mut self, instr: &Instr) {
        let span = instr.whole;
        self.undecided();
        self.run.unused = None;
        self.front.writes = true;
        let before = match std::mem::replace(&mut self.run.acc, Acc::Empty) {
            Acc::Value(expr) if expr.base == Base::Bool => Some(expr),
            _ => None,
        };
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
        let Some(&(first, _)) = codes.first() else {
            return;
        };
        self.front.names.inputs_read |= inputs_read(first);
        self.before(&Changes::Anything, false);
        // What the board's accumulator is goes on to the next code as it is.
        let goes_on = matches!(self.next(), Some(Stmt::Instr(next)) if next.op == Op::Code);
        let mut target = None;
        if !goes_on && self.needed() && !begins(first) {
            target = self.own(TypeId::BOOL, span);
        }
        let behind = target.as_ref().map(|target| target.place.clone());
        let codes = Codes {
            before,
            codes,
            behind,
        };
        let kind = StmtKind::Codes(Box::new(codes));
        self.push(Made { kind, at: span });
        self.run.links = 0;
        let held = match target {
            Some(target) => Some(self.read(target, span)),
            None if begins(first) => Some(self.truth(true, span)),
            None => None,
        };
        self.run.acc = held.map_or(Acc::Empty, Acc::Value);
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
