//! CODE: an instruction of the board by its numeric codes, with its operand lines.

use super::walk::Walk;
use crate::ast::Instr;
use crate::list::{Machine, Verbatim};
use unoclp_core::isa::{Kind, Row, TABLE};
use unoclp_text::diagnostics::Code;

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
