//! One value of several: SEL, MUX, MIN, MAX, ABS, and comparisons in a row.
//!
//! Owns which of them are logic and which need a temporary.

use super::coder::Coder;
use super::flat::{both, compare, not, whole};
use super::flat::{constant, expr};
use super::prepare::MOST_DEEP;
use super::ranges::bounds;
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Binary, Compare, Convert, Expr, ExprKind, Place, Unary, Value};

impl Coder<'_, '_> {
    pub(super) fn absolute(&mut self, a: Expr) -> Expr {
        let (base, at) = (a.base, a.at);
        let size = expr(ExprKind::Unary(Unary::Abs, Box::new(a.clone())), base, at);
        let wide = !self.is_within(&size, base);
        let (place, held) = self.temporary_for(base, at, wide);
        self.put(&place, &a);
        let negative = compare(Compare::Less, held.clone(), whole(0, base, at));
        if self.is_unsigned(&held) {
            return held;
        }
        self.bit(&negative, false);
        self.value(&held);
        self.pen.changes_value(Opcode::Negate);
        self.store(place.offset);
        held
    }

    pub(super) fn select(
        &mut self,
        which: Expr,
        no: Expr,
        yes: Expr,
        base: Base,
        at: Span,
    ) -> Expr {
        if base == Base::Bool {
            let mut which = which;
            if self.nest(&which) > 0 {
                which = self.keep(which);
            }
            let first = both(Binary::And, which.clone(), yes);
            let second = both(Binary::And, not(which), no);
            let made = both(Binary::Or, first, second);
            return if self.nest(&made) >= MOST_DEEP {
                self.keep(made)
            } else {
                made
            };
        }
        let wide = !self.is_within(&no, base) || !self.is_within(&yes, base);
        let (to, held) = self.temporary_for(base, at, wide);
        self.put(&to, &no);
        self.guarded(&which, &to, &yes);
        held
    }

    pub(super) fn ordered(&mut self, op: Compare, all: Vec<Expr>, at: Span) -> Expr {
        let mut simple = Vec::with_capacity(all.len());
        for operand in all {
            let operand = self.prepare(operand);
            let bare = operand.base == Base::Bool && self.nest(&operand) == 0;
            simple.push(if bare { operand } else { self.simple(operand) });
        }
        let pairs = simple.windows(2).filter_map(|pair| match pair {
            [a, b] => Some(compare(op, a.clone(), b.clone())),
            _ => None,
        });
        let all: Vec<Expr> = pairs.collect();
        let joined = all.into_iter().reduce(|a, b| both(Binary::And, a, b));
        joined.unwrap_or_else(|| constant(Value::truth(true), Base::Bool, at))
    }

    pub(super) fn mux(&mut self, which: Expr, all: Vec<Expr>, base: Base, at: Span) -> Expr {
        let which = self.prepare(which);
        let which = self.simple(which);
        let count = all.len() as i128;
        let (to, held) = match base {
            Base::Bool => {
                let (to, held) = self.temporary(Base::Dint, at);
                (to, Expr { base, ..held })
            }
            _ => self.temporary_for(base, at, true),
        };
        let values: Vec<Expr> = all.into_iter().map(|value| self.prepare(value)).collect();
        let number = |value: Expr, this: &mut Self| match value.base {
            Base::Bool => this.prepare_convert(
                Convert::Keep,
                value,
                Base::Dint,
                at,
                unoclp_tree::TypeId::of(Base::Dint),
            ),
            _ => value,
        };
        let mut made = Vec::with_capacity(values.len());
        for value in values {
            made.push(number(value, self));
        }
        let bare = expr(
            ExprKind::Convert(Convert::Keep, Box::new(which.clone())),
            Base::Udint,
            at,
        );
        let (low, high) = bounds(&which);
        self.put(&to, &whole(0, Base::Dint, at));
        if low < 0 || high >= count {
            let outside = compare(Compare::GreaterEqual, bare, whole(count, Base::Udint, at));
            self.zero_where(
                &outside,
                &Expr {
                    base: Base::Dint,
                    ..held.clone()
                },
            );
        }
        for (at_number, value) in (0..).zip(&made) {
            let is = compare(
                Compare::Equal,
                which.clone(),
                whole(at_number, which.base, at),
            );
            self.guarded(&is, &to, value);
        }
        held
    }

    /// The smaller or the greater; of two that are equal, the first.
    pub(super) fn extreme(&mut self, op: Binary, a: Expr, b: Expr) -> Expr {
        let base = a.base;
        // What is computed is put where the other one may replace it.
        let second_first = self.operand(&a).is_some() && self.operand(&b).is_none();
        let (begun, other) = match second_first {
            true => (b, a),
            false => (a, self.simple(b)),
        };
        let wide = !self.is_within(&begun, base) || !self.is_within(&other, base);
        let (to, held) = self.own_temporary(begun, wide);
        let how = match (op, second_first) {
            (Binary::Min, false) => Compare::Less,
            (Binary::Min, true) => Compare::LessEqual,
            (_, false) => Compare::Greater,
            (_, true) => Compare::GreaterEqual,
        };
        self.guarded(&compare(how, other.clone(), held.clone()), &to, &other);
        held
    }

    /// A prepared value in a temporary that nothing else reads: its own, if it stands in one.
    fn own_temporary(&mut self, value: Expr, wide: bool) -> (Place, Expr) {
        match &value.kind {
            ExprKind::Read(own) if self.seats.is_temporary(own.offset, wide) => {
                ((**own).clone(), value)
            }
            _ => {
                let (to, held) = self.temporary_for(value.base, value.at, wide);
                self.put(&to, &value);
                (to, held)
            }
        }
    }
}
