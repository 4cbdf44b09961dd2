//! Arithmetic that no instruction does in one piece: powers, dates and times.
//!
//! Owns by which other operations it is done.

use super::coder::Coder;
use super::fails::may_fail;
use super::flat::{both, compare, whole};
use super::flat::{constant, expr};
use super::ranges::bounds;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Binary, Compare, Convert, Expr, ExprKind, Unary, Value};

impl Coder<'_, '_> {
    pub(super) fn prepare_binary(
        &mut self,
        op: Binary,
        a: Expr,
        b: Expr,
        base: Base,
        at: Span,
    ) -> Expr {
        let again = |a, b| expr(ExprKind::Binary(op, Box::new(a), Box::new(b)), base, at);
        let day = |sum: Expr| {
            let all = || whole(86_400_000, Base::Dint, at);
            both(Binary::Modulo, both(Binary::Add, sum, all()), all())
        };
        let within_day = |time: Expr| both(Binary::Modulo, time, whole(86_400_000, Base::Dint, at));
        let seconds = |time: Expr| {
            let time = both(Binary::Divide, time, whole(1000, Base::Time, at));
            expr(
                ExprKind::Convert(Convert::Keep, Box::new(time)),
                Base::Dt,
                at,
            )
        };
        match op {
            Binary::Min | Binary::Max if base != Base::Bool => self.extreme(op, a, b),
            Binary::Power => self.power(a, b, base, at),
            Binary::ShiftLeft | Binary::ShiftRight | Binary::RotateLeft | Binary::RotateRight => {
                self.shifted(op, a, b, base, at)
            }
            Binary::DtPlusTime => both(Binary::Add, a, seconds(b)),
            Binary::DtMinusTime => both(Binary::Subtract, a, seconds(b)),
            Binary::TodPlusTime => {
                let sum = both(Binary::Add, within_day(b), a);
                Expr { base, ..day(sum) }
            }
            Binary::TodMinusTime => {
                let time = expr(
                    ExprKind::Unary(Unary::Negate, Box::new(within_day(b))),
                    Base::Dint,
                    at,
                );
                Expr {
                    base,
                    ..day(both(Binary::Add, time, a))
                }
            }
            Binary::DtMinusDt => self.difference(a, b, 1_000, at),
            Binary::DateMinusDate => self.difference(a, b, 86_400_000, at),
            _ => again(a, b),
        }
    }

    /// As a TIME; 0 and S 04 where it is beyond.
    fn difference(&mut self, a: Expr, b: Expr, unit: i128, at: Span) -> Expr {
        let most = i128::from(i32::MAX) / unit;
        let (from, to) = (bounds(&a), bounds(&b));
        // Numbers without signs that are nearly 32 bits apart are near one another where 32 bits are all there are.
        let far = (to.1 - from.0).max(from.1 - to.0) > i128::from(u32::MAX) - most;
        let (a, b) = match far {
            true => (self.simple(a), self.simple(b)),
            false => (a, b),
        };
        let sides = far.then(|| compare(Compare::Less, a.clone(), b.clone()));
        let apart = both(Binary::Subtract, a, b);
        let apart = expr(
            ExprKind::Convert(Convert::Keep, Box::new(apart)),
            Base::Dint,
            at,
        );
        let held = self.keep(apart);
        let shifted = both(Binary::Add, held.clone(), whole(most, Base::Dint, at));
        let shifted = expr(
            ExprKind::Convert(Convert::Keep, Box::new(shifted)),
            Base::Udint,
            at,
        );
        let mut wrong = compare(Compare::Greater, shifted, whole(2 * most, Base::Udint, at));
        if let Some(less) = sides {
            let negative = compare(Compare::Less, held.clone(), whole(0, Base::Dint, at));
            wrong = both(Binary::Or, wrong, both(Binary::Xor, less, negative));
        }
        self.zero_where(&wrong, &held);
        let made = both(Binary::Multiply, held, whole(unit, Base::Dint, at));
        Expr {
            base: Base::Time,
            ..made
        }
    }

    /// To a constant power, by squaring, each product rounded.
    fn power(&mut self, a: Expr, b: Expr, base: Base, at: Span) -> Expr {
        let one = || match base.is_real() {
            true => constant(Value::Real(1.0), base, at),
            false => whole(1, base, at),
        };
        let exponent = match &b.kind {
            ExprKind::Constant(value) => value.int(),
            _ => i128::MIN,
        };
        if exponent == i128::MIN {
            self.lacking(
                at,
                (
                    "a power with a computed exponent",
                    "uma potência com expoente calculado",
                ),
                (
                    "write a whole number as the exponent, or multiply in a loop",
                    "escreva um número inteiro como expoente, ou multiplique em um laço",
                ),
            );
            return one();
        }
        if exponent < 0 && !base.is_real() {
            // Of whole numbers nothing is left but of 1, -1, and 0, which cannot be computed.
            let part = self.keep(both(Binary::Divide, one(), a));
            return match exponent % 2 {
                0 => both(Binary::Multiply, part.clone(), part),
                _ => part,
            };
        }
        let mut rest = exponent.unsigned_abs();
        let mut square = match rest {
            0 if may_fail(&a) => self.keep(a),
            0 | 1 => a,
            _ => self.simple(a),
        };
        let mut result: Option<Expr> = None;
        while rest > 0 {
            if rest & 1 == 1 {
                result = Some(match result {
                    None => square.clone(),
                    Some(result) => both(Binary::Multiply, result, square.clone()),
                });
            }
            rest >>= 1;
            if rest > 0 {
                let product = both(Binary::Multiply, square.clone(), square);
                square = match rest == 1 && result.is_none() {
                    true => product,
                    false => self.keep(product),
                };
            }
        }
        let result = result.unwrap_or_else(one);
        match exponent < 0 {
            true => both(Binary::Divide, one(), result),
            false => result,
        }
    }
}
