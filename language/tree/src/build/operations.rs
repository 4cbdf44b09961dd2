//! What the standard functions make of their operands.

use super::builder::Builder;
use crate::{Base, Binary, Compare, Convert, Expr, ExprKind, Extra, Generic, TypeId, Unary};
use unoclp_text::diagnostics::{Code, Span};

/// Operands of one call that each stand within the one before.
const MOST_OPERANDS: usize = 300;

impl Builder<'_, '_> {
    pub(super) fn chain(
        &mut self,
        operands: Vec<Expr>,
        at: Span,
        join: impl Fn(&mut Self, Expr, Expr) -> Expr,
    ) -> Expr {
        if operands.len() > MOST_OPERANDS {
            self.tell(Code::StTooDeep, at, []);
            return self.wrong(at);
        }
        let mut operands = operands.into_iter();
        let Some(mut all) = operands.next() else {
            return self.wrong(at);
        };
        for operand in operands {
            all = join(self, all, operand);
        }
        all
    }

    /// Of more than two, each two neighbours.
    pub(super) fn compared(&mut self, op: Compare, operands: Vec<Expr>, at: Span) -> Expr {
        if operands.len() == 2 {
            let mut operands = operands.into_iter();
            return match (operands.next(), operands.next()) {
                (Some(a), Some(b)) => self.compare(op, a, b, at),
                _ => self.wrong(at),
            };
        }
        if operands.len() > MOST_OPERANDS {
            self.tell(Code::StTooDeep, at, []);
            return self.wrong(at);
        }
        let operands = operands.into_iter().map(|one| self.settled(one)).collect();
        let Some((operands, _)) = self.alike("GT", operands, at) else {
            return self.wrong(at);
        };
        Expr {
            kind: ExprKind::Ordered(op, operands),
            base: Base::Bool,
            ty: TypeId::BOOL,
            at,
        }
    }

    /// All in their common type, which none of them is without.
    fn alike(&mut self, name: &str, operands: Vec<Expr>, at: Span) -> Option<(Vec<Expr>, TypeId)> {
        let operands: Vec<Expr> = operands.into_iter().map(|one| self.cut(one)).collect();
        let first = operands.first()?;
        let mut ty = first.ty;
        if !self.is_enum(ty) {
            let mut base = first.base;
            for operand in &operands {
                let Some(common) = base.common(operand.base) else {
                    let (first, operand) = (operands[0].clone(), operand.clone());
                    let _ = self.common(name, first, operand, at);
                    return None;
                };
                base = common;
            }
            ty = TypeId::of(base);
        }
        let operands: Vec<Expr> = operands
            .into_iter()
            .map(|one| self.coerce(one, ty))
            .collect();
        let wrong = operands
            .iter()
            .any(|one| matches!(one.kind, ExprKind::Wrong));
        (!wrong).then_some((operands, ty))
    }

    pub(super) fn extreme(&mut self, op: Binary, a: Expr, b: Expr, at: Span) -> Expr {
        if matches!(a.kind, ExprKind::Wrong) || matches!(b.kind, ExprKind::Wrong) {
            return self.wrong(at);
        }
        self.joined(op, a, b, at)
    }

    pub(super) fn of_number(
        &mut self,
        name: &str,
        op: Unary,
        generic: Generic,
        a: Expr,
        at: Span,
    ) -> Expr {
        if !a.base.is_of(generic) || self.is_enum(a.ty) {
            self.told_operand(name, generic, &a);
            return self.wrong(at);
        }
        let a = if op == Unary::Sqrt {
            self.settled(a)
        } else {
            a
        };
        self.unary(op, a, at)
    }

    /// Without the fraction: to the integer type that is needed, or to DINT.
    pub(super) fn truncated(&mut self, name: &str, a: Expr, at: Span) -> Expr {
        if !a.base.is_real() {
            self.told_operand(name, Generic::Real, &a);
            return self.wrong(at);
        }
        let a = self.settled(a);
        if let ExprKind::Constant(_) = a.kind {
            let cut = self.converted(a, Convert::Cut, TypeId::of(Base::Dint));
            return match cut.kind {
                ExprKind::Constant(value) => self.whole(value.int(), at),
                _ => cut,
            };
        }
        Expr {
            kind: ExprKind::Convert(Convert::Cut, Box::new(a)),
            base: Base::AnyInt,
            ty: TypeId::of(Base::AnyInt),
            at,
        }
    }

    pub(super) fn shift(&mut self, name: &str, op: Binary, a: Expr, by: Expr, at: Span) -> Expr {
        if !a.base.is_bits() && a.base != Base::Bool {
            self.told_operand(name, Generic::Bit, &a);
            return self.wrong(at);
        }
        if !by.base.is_int() {
            self.told_operand(name, Generic::Int, &by);
            return self.wrong(at);
        }
        let by = match by.base {
            Base::Udint | Base::Lint | Base::Ulint => self.explicit(by, Base::Dint, at),
            _ => self.coerce(by, TypeId::of(Base::Dint)),
        };
        let base = a.base;
        self.binary(op, base, TypeId::of(base), a, by, at)
    }

    /// The base is a number; a whole exponent that is constant works on the board, any other on a PC.
    pub(super) fn power(&mut self, operands: Vec<Expr>, at: Span) -> Expr {
        let mut operands = operands.into_iter();
        let (Some(a), Some(b)) = (operands.next(), operands.next()) else {
            return self.wrong(at);
        };
        for operand in [&a, &b] {
            if !operand.base.is_num() || self.is_enum(operand.ty) {
                self.told_operand("EXPT", Generic::Num, operand);
                return self.wrong(at);
            }
        }
        if b.base.is_int() {
            let a = if a.base == Base::AnyReal || !matches!(b.kind, ExprKind::Constant(_)) {
                self.settled(a)
            } else {
                a
            };
            let by = match b.base {
                Base::Udint | Base::Lint | Base::Ulint => self.explicit(b, Base::Dint, at),
                _ => self.coerce(b, TypeId::of(Base::Dint)),
            };
            let base = a.base;
            return self.binary(Binary::Power, base, TypeId::of(base), a, by, at);
        }
        let (a, b) = (self.settled(a), self.settled(b));
        let base = if a.base == Base::Lreal {
            Base::Lreal
        } else {
            b.base
        };
        let (a, b) = (
            self.coerce(a, TypeId::of(base)),
            self.coerce(b, TypeId::of(base)),
        );
        self.extra(Extra::Power, base, vec![a, b], at)
    }

    pub(super) fn select(&mut self, which: Expr, a: Expr, b: Expr, at: Span) -> Expr {
        let which = self.coerce(which, TypeId::BOOL);
        let pair = self.alike("SEL", vec![a, b], at);
        let (Some((pair, ty)), false) = (pair, matches!(which.kind, ExprKind::Wrong)) else {
            return self.wrong(at);
        };
        let Ok([a, b]) = <[Expr; 2]>::try_from(pair) else {
            return self.wrong(at);
        };
        let base = a.base;
        if let ExprKind::Constant(value) = &which.kind {
            return if value.is_true() { b } else { a };
        }
        Expr {
            kind: ExprKind::Select(Box::new([which, a, b])),
            base,
            ty,
            at,
        }
    }

    pub(super) fn mux(&mut self, operands: Vec<Expr>, at: Span) -> Expr {
        let mut operands = operands.into_iter();
        let Some(which) = operands.next() else {
            return self.wrong(at);
        };
        if !which.base.is_int() {
            self.told_operand("MUX", Generic::Int, &which);
            return self.wrong(at);
        }
        let which = match which.base {
            Base::Udint | Base::Lint | Base::Ulint => self.explicit(which, Base::Dint, at),
            _ => self.coerce(which, TypeId::of(Base::Dint)),
        };
        let Some((inputs, ty)) = self.alike("MUX", operands.collect(), at) else {
            return self.wrong(at);
        };
        let Some(base) = self.tree.types.base(ty) else {
            return self.wrong(at);
        };
        Expr {
            kind: ExprKind::Mux(Box::new(which), inputs),
            base,
            ty,
            at,
        }
    }

    pub(super) fn of_real(&mut self, name: &str, extra: Extra, a: Expr, at: Span) -> Expr {
        let a = match a.base {
            Base::AnyInt => self.coerce(a, TypeId::of(Base::Real)),
            _ => self.settled(a),
        };
        if !a.base.is_real() {
            self.told_operand(name, Generic::Real, &a);
            return self.wrong(at);
        }
        let base = a.base;
        self.extra(extra, base, vec![a], at)
    }

    pub(super) fn of_texts(
        &mut self,
        name: &str,
        extra: Extra,
        operands: Vec<Expr>,
        at: Span,
    ) -> Expr {
        let texts = match extra {
            Extra::Concat => operands.len(),
            Extra::Insert | Extra::Replace | Extra::Find => 2,
            _ => 1,
        };
        let mut given = Vec::new();
        for (number, operand) in operands.into_iter().enumerate() {
            let generic = if number < texts {
                Generic::Text
            } else {
                Generic::Int
            };
            if !operand.base.is_of(generic) {
                self.told_operand(name, generic, &operand);
                return self.wrong(at);
            }
            given.push(match generic {
                Generic::Text => operand,
                _ => self.coerce(operand, TypeId::of(Base::Dint)),
            });
        }
        let base = match extra {
            Extra::Len | Extra::Find => Base::Int,
            _ => given.first().map_or(Base::Str, |first| first.base),
        };
        self.extra(extra, base, given, at)
    }

    fn extra(&mut self, extra: Extra, base: Base, operands: Vec<Expr>, at: Span) -> Expr {
        if operands
            .iter()
            .any(|operand| matches!(operand.kind, ExprKind::Wrong))
        {
            return self.wrong(at);
        }
        Expr {
            kind: ExprKind::Extra(extra, operands),
            base,
            ty: TypeId::of(base),
            at,
        }
    }
}
