//! Conversions that no instruction does in one piece.
//!
//! Owns what a BOOL is as a number, which REAL fits an integer, and which integer a date.

use super::coder::Coder;
use super::flat::{both, compare, constant, expr, whole};
use super::ranges::{bounds, real_bounds};
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Binary, Compare, Convert, Expr, ExprKind, Value};

impl Coder<'_, '_> {
    pub(super) fn prepare_convert(
        &mut self,
        how: Convert,
        a: Expr,
        base: Base,
        at: Span,
        ty: unoclp_tree::TypeId,
    ) -> Expr {
        let made = |a: Expr| Expr {
            kind: ExprKind::Convert(how, Box::new(a)),
            base,
            ty,
            at,
        };
        if a.base == Base::Bool && base != Base::Bool {
            let (to, held) = self.temporary(Base::Dint, at);
            self.bit(&a, false);
            self.pen.changes_value(Opcode::LoadBit);
            self.pen.fresh();
            self.store(to.offset);
            // 0 or 1 is in each type.
            let held = Expr { base, ..held };
            return match how {
                Convert::Float => expr(
                    ExprKind::Convert(
                        how,
                        Box::new(Expr {
                            base: Base::Dint,
                            ..held
                        }),
                    ),
                    base,
                    at,
                ),
                _ => held,
            };
        }
        if how == Convert::Fit {
            return self.fitting(a, base, at);
        }
        if !matches!(how, Convert::Round | Convert::Cut) {
            return made(a);
        }
        let (least, most) = base.range().unwrap_or((0, 0));
        let (low, high) = real_bounds(&a);
        if low - 1.0 >= least as f64 && high + 1.0 <= most as f64
            || base == Base::Dint
            || base == Base::Time
        {
            return made(a);
        }
        if most > i128::from(i32::MAX) {
            return self.without_sign(how, a, base, at);
        }
        let number = expr(ExprKind::Convert(how, Box::new(a)), Base::Dint, at);
        let held = self.keep(number);
        let above = compare(Compare::Greater, held.clone(), whole(most, Base::Dint, at));
        let below = compare(Compare::Less, held.clone(), whole(least, Base::Dint, at));
        self.zero_where(&both(Binary::Or, above, below), &held);
        Expr { base, ..held }
    }

    /// A whole number as a TOD or DATE: 0 where it is none.
    fn fitting(&mut self, a: Expr, base: Base, at: Span) -> Expr {
        let as_it_is =
            |a: Expr, base| expr(ExprKind::Convert(Convert::Keep, Box::new(a)), base, at);
        let (least, most) = base.range().unwrap_or((0, 0));
        let (low, high) = bounds(&a);
        if least <= low && high <= most {
            return as_it_is(a, base);
        }
        // As a number without a sign, what is below 0 is above all others.
        let held = self.keep(as_it_is(a, Base::Udint));
        let beyond = compare(Compare::Greater, held.clone(), whole(most, Base::Udint, at));
        self.zero_where(&beyond, &held);
        Expr { base, ..held }
    }

    /// A REAL as 32 bits without a sign: from 2^31 on by what it is above 2^32, which is exact.
    fn without_sign(&mut self, how: Convert, a: Expr, base: Base, at: Span) -> Expr {
        let real = |number: f64| constant(Value::Real(number), Base::Real, at);
        let a = self.simple(a);
        let held = self.keep(a.clone());
        let is_big = compare(Compare::GreaterEqual, a.clone(), real(2_147_483_648.0));
        let big = self.keep(is_big);
        if let ExprKind::Read(to) = &held.kind {
            let above = both(Binary::Subtract, a, real(4_294_967_296.0));
            self.guarded(&big, to, &above);
        }
        let number = self.keep(expr(ExprKind::Convert(how, Box::new(held)), Base::Dint, at));
        let negative = compare(Compare::Less, number.clone(), whole(0, Base::Dint, at));
        self.zero_where(&both(Binary::Xor, negative, big), &number);
        Expr { base, ..number }
    }
}
