//! Instructions that the text says by their codes.
//!
//! Owns what is known of the board behind one. Must not know how a text writes them.

use super::coder::Coder;
use super::flat::Step;
use super::pen::Acc;
use crate::diagnostics::Span;
use crate::typed::Expr;
use unoclp_core::isa::{Class, Opcode, Row, TABLE};

/// The row of a code that has this class.
fn is(code: i32, class: Class) -> bool {
    let of = |row: &Row| row.class == class && row.code == code;
    TABLE.iter().any(of)
}

/// Whether a timer's block begins with this code, so that it takes a number.
pub(super) fn is_timer(code: i32) -> bool {
    is(code, Class::Timer)
}

/// The number of the label that this code is.
pub(super) fn label(code: i32) -> Option<u8> {
    let number = code - Opcode::Label.row().code;
    u8::try_from(number)
        .ok()
        .filter(|number| (1..=99).contains(number))
}

/// Whether acc is 1 behind this code, and a label may stand there.
fn begins(code: i32) -> bool {
    let opcodes = [Opcode::NewRung, Opcode::If, Opcode::Else, Opcode::EndIf];
    opcodes.iter().any(|opcode| opcode.row().code == code) || label(code).is_some()
}

impl Coder<'_, '_> {
    pub(super) fn codes(
        &mut self,
        before: Option<&Expr>,
        codes: &[(i32, Span)],
        behind: Option<u32>,
        next: Option<&Step>,
    ) {
        if let Some(before) = before {
            let before = self.prepare(before.clone());
            self.bit(&before, false);
        }
        let Some((first, _)) = codes.first() else {
            return;
        };
        self.pen.codes(codes, begins(*first));
        let Some(cell) = behind.filter(|cell| self.uses.get(*cell).is_some_and(|of| of.reads > 0))
        else {
            return;
        };
        if let Some(seat) = self.seats.of.get(&cell).copied() {
            match self.takes(next, cell, seat) {
                true => self.pen.acc = Acc::Bit(seat),
                false => self.drive_any(seat, cell),
            }
        }
    }
}
