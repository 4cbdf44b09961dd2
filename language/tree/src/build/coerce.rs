//! Which value goes where: by itself, or by a conversion that a text asks for.

use super::builder::Builder;
use crate::ops;
use crate::{Base, Convert, Expr, ExprKind, Kind, TypeId, Value};
use unoclp_text::diagnostics::{Code, Span};

/// How a value of one type becomes one of another where a text asks for it; none where that has no meaning.
pub fn conversion(from: Base, to: Base) -> Option<Convert> {
    let number = |base: Base| base.is_num() || base.is_bits();
    Some(match (from, to) {
        _ if from == to => Convert::Keep,
        (_, _) if from.is_text() && to.is_text() => Convert::Keep,
        (_, _) if to.is_text() => Convert::Write,
        (_, _) if from.is_text() => Convert::Parse,
        (Base::Dt, Base::Date) => Convert::Day,
        (Base::Dt, Base::Tod) => Convert::Clock,
        (Base::Date, Base::Dt) => Convert::Midnight,
        _ if from.is_date() && (to.is_date() || to == Base::Time || to == Base::Bool) => {
            return None;
        }
        _ if to.is_date() && (from == Base::Time || from == Base::Bool) => return None,
        (_, Base::Bool) => Convert::Test,
        _ if from.is_real() && to.is_real() => match to {
            Base::Real => Convert::Single,
            _ => Convert::Keep,
        },
        _ if from.is_real() => Convert::Round,
        _ if to.is_real() => Convert::Float,
        _ if from == Base::Bool => Convert::Keep,
        (_, Base::Tod | Base::Date) if number(from) => Convert::Fit,
        _ if number(from) || number(to) => {
            let (same, wider) = (from.is_signed() == to.is_signed(), from.bits() <= to.bits());
            match wider && (same || !from.is_signed() && from.bits() < to.bits()) {
                true => Convert::Keep,
                false => Convert::Wrap,
            }
        }
        _ => return None,
    })
}

/// Whether all numbers of the text that it chooses among fit this type.
fn whole_within(expr: &Expr, base: Base) -> bool {
    match &expr.kind {
        ExprKind::Constant(value) => {
            let range = base.range();
            range.is_some_and(|(low, high)| (low..=high).contains(&value.int()))
        }
        ExprKind::Select(parts) => parts[1..].iter().all(|one| whole_within(one, base)),
        ExprKind::Mux(_, inputs) => inputs.iter().all(|one| whole_within(one, base)),
        _ => true,
    }
}

/// Whether an integer of the board loses a part of its value in this type.
fn is_cut(expr: &Expr, to: Base) -> bool {
    let is_small = |base: Base| base.is_int() && base.bits() <= 32;
    match &expr.kind {
        ExprKind::Constant(value) if expr.base == Base::AnyInt => {
            let range = to.range().filter(|_| is_small(to));
            range.is_some_and(|(low, high)| !(low..=high).contains(&value.int()))
        }
        _ => is_small(expr.base) && is_small(to) && !expr.base.widens_to(to),
    }
}

impl Builder<'_, '_> {
    /// A number of the text, whose type what it meets decides.
    pub fn whole(&mut self, number: i128, at: Span) -> Expr {
        self.literal(Base::AnyInt, Value::Int(number), at)
    }

    /// A value of the text, whose type it says; `AnyReal` of a number with a point.
    pub fn literal(&mut self, base: Base, value: Value, at: Span) -> Expr {
        Expr {
            kind: ExprKind::Constant(value),
            base,
            ty: TypeId::of(base),
            at,
        }
    }

    /// Converts without asking; a constant at once.
    pub fn converted(&mut self, expr: Expr, how: Convert, ty: TypeId) -> Expr {
        let Some(to) = self.tree.types.base(ty) else {
            return self.wrong(expr.at);
        };
        let (from, at) = (expr.base, expr.at);
        let kind = match expr.kind {
            ExprKind::Wrong => ExprKind::Wrong,
            ExprKind::Constant(value) => {
                let (value, failed) = ops::convert(how, from, to, &value);
                if failed {
                    self.told_range(at, to);
                    return self.wrong(at);
                }
                ExprKind::Constant(value)
            }
            kind if how == Convert::Keep && from == to => kind,
            kind => ExprKind::Convert(
                how,
                Box::new(Expr {
                    kind,
                    base: from,
                    ty: expr.ty,
                    at,
                }),
            ),
        };
        Expr {
            kind,
            base: to,
            ty,
            at,
        }
    }

    /// Converts as a text asks, by `INT_TO_REAL(x)` and the like.
    pub fn explicit(&mut self, expr: Expr, to: Base, at: Span) -> Expr {
        if matches!(expr.kind, ExprKind::Wrong) {
            return expr;
        }
        let mut expr = self.settled(expr);
        expr.at = at;
        match conversion(expr.base, to) {
            Some(how) => self.converted(expr, how, TypeId::of(to)),
            None => {
                let name = format!("{}_TO_{to}", expr.base);
                let help = (
                    "there are conversions between numbers, bit strings, BOOL, TIME and strings, and from DT to DATE and TOD",
                    "há conversões entre números, cadeias de bits, BOOL, TIME e strings, e de DT para DATE e TOD",
                );
                self.tell(Code::StNoConversion, at, [name.into(), help.into()]);
                self.wrong(at)
            }
        }
    }

    /// Converts in a way that the language has for it, where [`Builder::explicit`] would take another: LCE cuts the
    /// fraction of a real, and keeps the bits that fit.
    pub fn convert(&mut self, expr: Expr, how: Convert, to: Base, at: Span) -> Expr {
        let expr = self.settled(expr);
        Expr {
            at,
            ..self.converted(expr, how, TypeId::of(to))
        }
    }

    /// Gives a number of the text, whose type is open, its own: INT, DINT or LINT, and REAL.
    pub fn settled(&mut self, expr: Expr) -> Expr {
        let to = match (&expr.kind, expr.base) {
            (ExprKind::Constant(value), Base::AnyInt) => {
                let number = value.int();
                let fits = |base: &&Base| {
                    let range = base.range();
                    range.is_some_and(|(low, high)| (low..=high).contains(&number))
                };
                let all = [Base::Int, Base::Dint, Base::Lint, Base::Ulint];
                all.iter().find(fits).copied().unwrap_or(Base::Ulint)
            }
            (ExprKind::Convert(..), Base::AnyInt) => Base::Dint,
            (ExprKind::Select(_) | ExprKind::Mux(..), Base::AnyInt) => {
                match whole_within(&expr, Base::Int) {
                    true => Base::Int,
                    false => Base::Dint,
                }
            }
            (_, Base::AnyReal) => Base::Real,
            _ => return expr,
        };
        self.coerce(expr, TypeId::of(to))
    }

    /// A value as this type needs it: as it is, or converted where that loses nothing. Else it is told.
    pub fn coerce(&mut self, expr: Expr, ty: TypeId) -> Expr {
        if matches!(expr.kind, ExprKind::Wrong) {
            return expr;
        }
        let Some(to) = self.tree.types.base(ty) else {
            self.told_mismatch(&expr, ty);
            return self.wrong(expr.at);
        };
        if self.is_enum(expr.ty) || self.is_enum(ty) {
            if self.tree.types.same(expr.ty, ty) {
                return Expr { ty, ..expr };
            }
            self.told_mismatch(&expr, ty);
            return self.wrong(expr.at);
        }
        if self.is_wide && is_cut(&expr, to) {
            return self.converted(expr, Convert::Wrap, ty);
        }
        if let ExprKind::Constant(value) = &expr.kind {
            return self.coerce_constant(value.clone(), expr, to, ty);
        }
        if expr.base.is_any() && expr.base.widens_to(to) {
            if to.is_int() || !matches!(expr.kind, ExprKind::Convert(..)) {
                return self.coerce_inner(expr, to, ty);
            }
            let expr = self.settled(expr);
            return self.coerce(expr, ty);
        }
        if !expr.base.widens_to(to) {
            if self.takes_bits(expr.base, to, expr.at) {
                return self.converted(expr, Convert::Keep, ty);
            }
            self.told_mismatch(&expr, ty);
            return self.wrong(expr.at);
        }
        let how = match (expr.base.is_real(), to.is_real()) {
            (false, true) => Convert::Float,
            _ => Convert::Keep,
        };
        self.converted(expr, how, ty)
    }

    /// What chooses among numbers of the text, each of which takes the type.
    fn coerce_inner(&mut self, expr: Expr, to: Base, ty: TypeId) -> Expr {
        let at = expr.at;
        let kind = match expr.kind {
            ExprKind::Select(parts) => {
                let [which, no, yes] = *parts;
                let (no, yes) = (self.coerce(no, ty), self.coerce(yes, ty));
                if [&no, &yes]
                    .iter()
                    .any(|one| matches!(one.kind, ExprKind::Wrong))
                {
                    return self.wrong(at);
                }
                ExprKind::Select(Box::new([which, no, yes]))
            }
            ExprKind::Mux(which, inputs) => {
                let inputs: Vec<Expr> =
                    inputs.into_iter().map(|one| self.coerce(one, ty)).collect();
                if inputs.iter().any(|one| matches!(one.kind, ExprKind::Wrong)) {
                    return self.wrong(at);
                }
                ExprKind::Mux(which, inputs)
            }
            kind => kind,
        };
        Expr {
            kind,
            base: to,
            ty,
            at,
        }
    }

    fn coerce_constant(&mut self, value: Value, expr: Expr, to: Base, ty: TypeId) -> Expr {
        let at = expr.at;
        let from = expr.base;
        let bit = to == Base::Bool && from == Base::AnyInt && (0..=1).contains(&value.int());
        if !from.widens_to(to) && !bit {
            self.told_mismatch(&expr, ty);
            return self.wrong(at);
        }
        let value = match (&value, to.is_real()) {
            (Value::Int(_) | Value::Real(_), true) => {
                let (value, failed) = ops::convert(Convert::Float, from, to, &value);
                if failed {
                    self.told_range(at, to);
                    return self.wrong(at);
                }
                value
            }
            _ => value,
        };
        let range = match self.tree.types.kind(ty) {
            Kind::Range { low, high, .. } => Some((*low, *high)),
            _ => to.range(),
        };
        if let (Some((low, high)), Value::Int(number)) = (range, &value)
            && !(low..=high).contains(number)
        {
            let words = [
                number.to_string().into(),
                self.tree.types.name(ty).into(),
                low.to_string().into(),
                high.to_string().into(),
            ];
            self.tell(Code::StOutOfRange, at, words);
            return self.wrong(at);
        }
        Expr {
            kind: ExprKind::Constant(value),
            base: to,
            ty,
            at,
        }
    }
}
