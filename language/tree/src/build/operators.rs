//! Operators: the common type of their operands, times and dates, folding.

use super::builder::Builder;
use crate::ops;
use crate::{Base, Binary, Compare, Convert, Expr, ExprKind, Generic, TypeId, Unary, Value};
use unoclp_text::diagnostics::{Code, Span};

/// How an operator is called in messages.
fn symbol(op: Binary) -> &'static str {
    match op {
        Binary::Add => "+",
        Binary::Subtract => "-",
        Binary::Multiply => "*",
        Binary::Divide => "/",
        Binary::Modulo => "MOD",
        Binary::And => "AND",
        Binary::Or => "OR",
        Binary::Xor => "XOR",
        Binary::Power => "EXPT",
        Binary::Min => "MIN",
        Binary::Max => "MAX",
        _ => "this",
    }
}

impl Builder<'_, '_> {
    fn is_wrong(a: &Expr, b: &Expr) -> bool {
        matches!(a.kind, ExprKind::Wrong) || matches!(b.kind, ExprKind::Wrong)
    }

    /// `a + b`, `a - b`, `a * b`, `a / b`, `a MOD b`.
    pub fn arithmetic(&mut self, op: Binary, a: Expr, b: Expr, at: Span) -> Expr {
        let (a, b) = (self.cut(a), self.cut(b));
        if Builder::is_wrong(&a, &b) {
            return self.wrong(at);
        }
        if let Some((op, base)) = timed(op, a.base, b.base) {
            return self.binary(op, base, TypeId::of(base), a, b, at);
        }
        let number = |expr: &Expr| expr.base.is_num() && !self.is_enum(expr.ty);
        match op {
            Binary::Multiply | Binary::Divide if a.base == Base::Time && number(&b) => {
                return self.scaled(op, a, b, at);
            }
            Binary::Multiply if b.base == Base::Time && number(&a) => {
                return self.scaled(op, b, a, at);
            }
            _ => {}
        }
        let generic = match op {
            Binary::Modulo => Generic::Int,
            _ => Generic::Num,
        };
        // What comes of bit strings alone is one again.
        let bits = self.common_bits(&a, &b);
        let (a, b) = (self.counted(a), self.counted(b));
        for operand in [&a, &b] {
            if !operand.base.is_of(generic) || self.is_enum(operand.ty) {
                self.told_operand(symbol(op), generic, operand);
                return self.wrong(at);
            }
        }
        let (a, b) = self.promoted(a, b);
        let all = self.joined(op, a, b, at);
        match bits {
            Some(bits) => self.converted(all, Convert::Keep, TypeId::of(bits)),
            None => all,
        }
    }

    /// What TRUNC comes to is a DINT among operands.
    pub(super) fn cut(&mut self, expr: Expr) -> Expr {
        match (&expr.kind, expr.base) {
            (ExprKind::Convert(..), Base::AnyInt) => self.settled(expr),
            _ => expr,
        }
    }

    /// A number of the text that the other operand's type cannot hold takes a larger one.
    fn promoted(&mut self, a: Expr, b: Expr) -> (Expr, Expr) {
        let large = |one: &Expr, other: &Expr| match (&one.kind, one.base) {
            (ExprKind::Constant(value), Base::AnyInt)
                if other.base.is_int() && !other.base.is_any() =>
            {
                let range = other.base.range();
                range.is_some_and(|(low, high)| !(low..=high).contains(&value.int()))
            }
            _ => false,
        };
        match (large(&a, &b), large(&b, &a)) {
            (true, _) => (self.settled(a), b),
            (_, true) => {
                let b = self.settled(b);
                (a, b)
            }
            _ => (a, b),
        }
    }

    /// Two operands in their common type; told if there is none.
    pub(super) fn common(
        &mut self,
        name: &str,
        a: Expr,
        b: Expr,
        at: Span,
    ) -> Option<(Expr, Expr)> {
        let (a, b) = match a.base.is_bits() != b.base.is_bits() && a.base.common(b.base).is_none() {
            true => (self.counted(a), self.counted(b)),
            false => (a, b),
        };
        let Some(base) = a.base.common(b.base) else {
            self.told_no_common(name, &a, &b, at);
            return None;
        };
        let constants = [&a, &b].map(|one| matches!(one.kind, ExprKind::Constant(_)));
        if base.is_any() && constants.contains(&false) {
            let (a, b) = (self.settled(a), self.settled(b));
            return match a.base.is_any() || b.base.is_any() {
                true => None,
                false => self.common(name, a, b, at),
            };
        }
        let ty = TypeId::of(base);
        let (a, b) = (self.coerce(a, ty), self.coerce(b, ty));
        (!Builder::is_wrong(&a, &b)).then_some((a, b))
    }

    pub(super) fn joined(&mut self, op: Binary, a: Expr, b: Expr, at: Span) -> Expr {
        let Some((a, b)) = self.common(symbol(op), a, b, at) else {
            return self.wrong(at);
        };
        let base = a.base;
        self.binary(op, base, TypeId::of(base), a, b, at)
    }

    /// Makes the node, or the constant that it comes to.
    pub(super) fn binary(
        &mut self,
        op: Binary,
        base: Base,
        ty: TypeId,
        a: Expr,
        b: Expr,
        at: Span,
    ) -> Expr {
        if Builder::is_wrong(&a, &b) {
            return self.wrong(at);
        }
        let divides = matches!(op, Binary::Divide | Binary::Modulo);
        let by_zero =
            divides && matches!(&b.kind, ExprKind::Constant(divisor) if divisor.real() == 0.0);
        if by_zero && (!self.divides_by_zero || self.is_list && base.is_real()) {
            self.tell(Code::StDivisionByZero, at, []);
            return self.wrong(at);
        }
        if by_zero && base.is_any() {
            let a = self.settled(a);
            let (base, ty) = (a.base, a.ty);
            let b = self.coerce(b, ty);
            return self.binary(op, base, ty, a, b, at);
        }
        let kind = match (&a.kind, &b.kind) {
            // Computed where it stands: 0, and S 04.
            _ if by_zero => ExprKind::Binary(op, Box::new(a), Box::new(b)),
            (ExprKind::Constant(x), ExprKind::Constant(y)) => {
                let (value, failed) = ops::binary(op, a.base, x, y);
                let lost = base == Base::AnyInt
                    && base
                        .range()
                        .is_some_and(|(low, high)| !(low..=high).contains(&value.int()));
                if failed || lost {
                    self.told_range(at, base);
                    return self.wrong(at);
                }
                ExprKind::Constant(value)
            }
            _ => ExprKind::Binary(op, Box::new(a), Box::new(b)),
        };
        Expr { kind, base, ty, at }
    }

    /// A time so many times, or a part of one.
    fn scaled(&mut self, op: Binary, time: Expr, by: Expr, at: Span) -> Expr {
        let ty = TypeId::of(Base::Time);
        if by.base.is_real() {
            let by = self.settled(by);
            let base = by.base;
            let number = self.converted(time, Convert::Float, TypeId::of(base));
            let product = self.binary(op, base, TypeId::of(base), number, by, at);
            return self.converted(product, Convert::Round, ty);
        }
        let by = self.settled(by);
        if by.base.bits() == 64 {
            let long = TypeId::of(Base::Lint);
            let time = self.converted(time, Convert::Keep, long);
            let by = self.converted(by, Convert::Wrap, long);
            let made = self.binary(op, Base::Lint, long, time, by, at);
            return self.converted(made, Convert::Wrap, ty);
        }
        let by = self.converted(by, Convert::Keep, ty);
        self.binary(op, Base::Time, ty, time, by, at)
    }

    /// `a AND b`, `a OR b`, `a XOR b`.
    pub fn logic(&mut self, op: Binary, a: Expr, b: Expr, at: Span) -> Expr {
        let (a, b) = (self.cut(a), self.cut(b));
        if Builder::is_wrong(&a, &b) {
            return self.wrong(at);
        }
        for operand in [&a, &b] {
            if !operand.base.is_of(Generic::Bit) || self.is_enum(operand.ty) {
                self.told_operand(symbol(op), Generic::Bit, operand);
                return self.wrong(at);
            }
        }
        let bool_with_number = |x: &Expr, y: &Expr| x.base == Base::Bool && y.base == Base::AnyInt;
        if bool_with_number(&a, &b) || bool_with_number(&b, &a) {
            let (a, b) = (self.coerce(a, TypeId::BOOL), self.coerce(b, TypeId::BOOL));
            return self.binary(op, Base::Bool, TypeId::BOOL, a, b, at);
        }
        self.joined(op, a, b, at)
    }

    /// `a = b` and its like.
    pub fn compare(&mut self, op: Compare, a: Expr, b: Expr, at: Span) -> Expr {
        let (a, b) = (self.cut(a), self.cut(b));
        if Builder::is_wrong(&a, &b) {
            return self.wrong(at);
        }
        let pair = if self.is_enum(a.ty) || self.is_enum(b.ty) {
            let (of, other) = match self.is_enum(a.ty) {
                true => (a.ty, &b),
                false => (b.ty, &a),
            };
            if !self.tree.types.same(of, other.ty) {
                let other = other.clone();
                self.told_mismatch(&other, of);
                return self.wrong(at);
            }
            Some((a, b))
        } else if a.base == Base::Bool && b.base == Base::AnyInt {
            let b = self.coerce(b, TypeId::BOOL);
            Some((a, b))
        } else {
            self.common(sign(op), a, b, at)
        };
        let Some((a, b)) = pair else {
            return self.wrong(at);
        };
        if Builder::is_wrong(&a, &b) {
            return self.wrong(at);
        }
        let kind = match (&a.kind, &b.kind) {
            (ExprKind::Constant(x), ExprKind::Constant(y)) => {
                ExprKind::Constant(Value::truth(ops::compare(op, x, y)))
            }
            _ => ExprKind::Compare(op, Box::new(a), Box::new(b)),
        };
        Expr {
            kind,
            base: Base::Bool,
            ty: TypeId::BOOL,
            at,
        }
    }

    pub(super) fn unary(&mut self, op: Unary, a: Expr, at: Span) -> Expr {
        let a = match a.kind {
            ExprKind::Constant(_) => a,
            _ => self.settled(a),
        };
        let (base, ty) = (a.base, TypeId::of(a.base));
        let kind = match a.kind {
            ExprKind::Wrong => ExprKind::Wrong,
            ExprKind::Constant(value) => {
                let (value, failed) = ops::unary(op, base, &value);
                if failed {
                    self.told_range(at, base);
                    return self.wrong(at);
                }
                ExprKind::Constant(value)
            }
            _ => ExprKind::Unary(op, Box::new(a)),
        };
        Expr { kind, base, ty, at }
    }

    /// `-a`
    pub fn negate(&mut self, a: Expr, at: Span) -> Expr {
        if matches!(a.kind, ExprKind::Wrong) {
            return a;
        }
        if !a.base.is_of(Generic::Magnitude) || self.is_enum(a.ty) {
            self.told_operand("-", Generic::Magnitude, &a);
            return self.wrong(at);
        }
        self.unary(Unary::Negate, a, at)
    }

    /// `NOT a`: of bits, in the bits of their type.
    pub fn not(&mut self, a: Expr, at: Span) -> Expr {
        if matches!(a.kind, ExprKind::Wrong) {
            return a;
        }
        let bits = a.base.is_bits() || a.base == Base::Bool;
        if !bits {
            self.told_operand("NOT", Generic::Bit, &a);
            return self.wrong(at);
        }
        let ty = TypeId::of(a.base);
        let narrow = a.base.bits() < 32 && a.base != Base::Bool;
        let all = self.unary(Unary::Not, a, at);
        match narrow {
            true => self.narrowed(all, ty),
            false => all,
        }
    }

    /// Cut to the bits of its type, as a node of its own.
    pub(super) fn narrowed(&mut self, expr: Expr, ty: TypeId) -> Expr {
        self.converted(expr, Convert::Wrap, ty)
    }
}

/// What is computed with times and dates, and the type that it comes to.
fn timed(op: Binary, a: Base, b: Base) -> Option<(Binary, Base)> {
    use Base::{Date, Dt, Time, Tod};
    Some(match (op, a, b) {
        (Binary::Add | Binary::Subtract, Time, Time) => (op, Time),
        (Binary::Add, Tod, Time) => (Binary::TodPlusTime, Tod),
        (Binary::Subtract, Tod, Time) => (Binary::TodMinusTime, Tod),
        (Binary::Subtract, Tod, Tod) => (op, Time),
        (Binary::Add, Dt, Time) => (Binary::DtPlusTime, Dt),
        (Binary::Subtract, Dt, Time) => (Binary::DtMinusTime, Dt),
        (Binary::Subtract, Dt, Dt) => (Binary::DtMinusDt, Time),
        (Binary::Subtract, Date, Date) => (Binary::DateMinusDate, Time),
        _ => return None,
    })
}

fn sign(op: Compare) -> &'static str {
    match op {
        Compare::Equal => "=",
        Compare::NotEqual => "<>",
        Compare::Less => "<",
        Compare::LessEqual => "<=",
        Compare::Greater => ">",
        Compare::GreaterEqual => ">=",
    }
}
