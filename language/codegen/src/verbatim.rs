//! Instructions that the text says by their codes, as they are written.
//!
//! Owns what acc holds before and behind one. Must not know what a code means: `codes` does.

use super::coder::Coder;
use super::flat::Step;
use super::pen::Acc;
use unoclp_text::diagnostics::Span;
use unoclp_tree::Expr;
use unoclp_tree::codes::begins;

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
