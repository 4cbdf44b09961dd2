//! Conversions that no instruction does in one piece.
//!
//! Owns what a BOOL is as a number, and which REAL fits an integer.

use super::coder::Coder;
use super::flat::expr;
use super::flat::{both, compare, whole};
use super::ranges::real_bounds;
use crate::diagnostics::Span;
use crate::typed::{Base, Binary, Compare, Convert, Expr, ExprKind};
use unoclp_core::isa::Opcode;

impl Coder<'_, '_> {
    pub(super) fn prepare_convert(
        &mut self,
        how: Convert,
        a: Expr,
        base: Base,
        at: Span,
        ty: crate::typed::TypeId,
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
            self.lacking(
                at,
                (
                    "a conversion of REAL to a number of 32 bits without a sign",
                    "uma conversão de REAL para um número de 32 bits sem sinal",
                ),
                ("convert to DINT first", "converta antes para DINT"),
            );
            return whole(0, base, at);
        }
        let number = expr(ExprKind::Convert(how, Box::new(a)), Base::Dint, at);
        let held = self.keep(number);
        let above = compare(Compare::Greater, held.clone(), whole(most, Base::Dint, at));
        let below = compare(Compare::Less, held.clone(), whole(least, Base::Dint, at));
        self.zero_where(&both(Binary::Or, above, below), &held);
        Expr { base, ..held }
    }
}
