//! Bit strings that are taken as numbers, as makers let them be: BYTE as USINT, WORD as UINT, DWORD as UDINT.
//!
//! Owns where that is done, and that it is told. Must not know lists, which have rules of their own.

use super::builder::Builder;
use crate::{Base, Convert, Expr, ExprKind, TypeId};
use unoclp_text::diagnostics::{Code, Span};

impl Builder<'_, '_> {
    /// A bit string as a number without a sign; anything else as it is.
    pub(super) fn counted(&mut self, expr: Expr) -> Expr {
        let constant = matches!(expr.kind, ExprKind::Constant(_));
        match expr.base.counted() {
            Some(number) if !constant && !self.is_list => {
                self.told_counted(expr.base, number, expr.at);
                self.converted(expr, Convert::Keep, TypeId::of(number))
            }
            _ => expr,
        }
    }

    /// Of a bit string that goes into a number, or a number into a bit string, with no loss: the bit string, and the number
    /// of its size. In Instruction List neither does.
    pub(super) fn bits_counted(&self, from: Base, to: Base) -> Option<(Base, Base)> {
        match (from.counted(), to.counted()) {
            _ if self.is_list => None,
            (Some(number), None) if to.is_int() && number.widens_to(to) => Some((from, number)),
            (None, Some(number)) if from.is_int() && from.widens_to(number) => Some((to, number)),
            _ => None,
        }
    }

    /// Whether it does so; then that is told.
    pub(super) fn takes_bits(&mut self, from: Base, to: Base, at: Span) -> bool {
        let counted = self.bits_counted(from, to);
        if let Some((bits, number)) = counted {
            self.told_counted(bits, number, at);
        }
        counted.is_some()
    }

    /// The bit string that two operands come to, where both are one, or one is a number of the text.
    pub(super) fn common_bits(&self, a: &Expr, b: &Expr) -> Option<Base> {
        match (a.base, b.base) {
            (Base::AnyInt, bits) | (bits, Base::AnyInt) => bits.is_bits().then_some(bits),
            (a, b) if a.is_bits() && b.is_bits() => a.common(b),
            _ => None,
        }
    }

    pub(super) fn told_counted(&mut self, bits: Base, number: Base, at: Span) {
        let words = [bits.name().into(), number.name().into()];
        self.tell(Code::StBitsCounted, at, words);
    }
}
