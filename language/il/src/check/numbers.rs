//! Numbers: 32 bits with a sign, whatever is done with them.

use super::bits::name;
use super::said::{ACCUMULATOR, constant};
use super::walk::Walk;
use crate::ast::Instr;
use crate::operators::Op;
use crate::words::operator;
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Binary, Compare, Convert, Expr, ExprKind, TypeId, Unary, Value};

/// What is made of one number.
enum How {
    Does(Unary),
    Becomes(Convert, Base),
}

impl Walk<'_, '_, '_> {
    /// Arithmetic and comparisons.
    pub(super) fn computed(&mut self, op: Op, left: Expr, right: Expr, span: Span) -> Option<Expr> {
        let opcode = match op {
            Op::And => return Some(self.joined(Binary::And, left, right, span)),
            Op::Or => return Some(self.joined(Binary::Or, left, right, span)),
            Op::Xor => return Some(self.joined(Binary::Xor, left, right, span)),
            Op::Number(opcode) | Op::Compare(opcode) => opcode,
            _ => return None,
        };
        let base = match is_unsigned(&left, &right) {
            true => Base::Udint,
            false => Base::Dint,
        };
        let compare = |compare| Some((compare, base));
        let compare = match opcode {
            Opcode::Greater => compare(Compare::Greater),
            Opcode::GreaterOrEqual => compare(Compare::GreaterEqual),
            Opcode::Equal => compare(Compare::Equal),
            Opcode::NotEqual => compare(Compare::NotEqual),
            Opcode::LessOrEqual => compare(Compare::LessEqual),
            Opcode::Less => compare(Compare::Less),
            Opcode::UnsignedGreaterOrEqual => Some((Compare::GreaterEqual, Base::Udint)),
            Opcode::UnsignedLess => Some((Compare::Less, Base::Udint)),
            _ => None,
        };
        if let Some((compare, base)) = compare {
            let (left, right) = (self.taken_for(left, base), self.taken_for(right, base));
            return Some(self.front.c.builder.compare(compare, left, right, span));
        }
        let (op, base) = match opcode {
            Opcode::Add => (Binary::Add, Base::Dint),
            Opcode::Subtract => (Binary::Subtract, Base::Dint),
            Opcode::Multiply => (Binary::Multiply, Base::Dint),
            Opcode::Divide => (Binary::Divide, base),
            Opcode::Modulo => (Binary::Modulo, base),
            Opcode::UnsignedDivide => (Binary::Divide, Base::Udint),
            Opcode::UnsignedModulo => (Binary::Modulo, Base::Udint),
            Opcode::RealAdd => (Binary::Add, Base::Real),
            Opcode::RealSubtract => (Binary::Subtract, Base::Real),
            Opcode::RealMultiply => (Binary::Multiply, Base::Real),
            Opcode::RealDivide => (Binary::Divide, Base::Real),
            _ => {
                self.not_yet(span);
                return None;
            }
        };
        let typed = !(self.is_plain(&left) && self.is_plain(&right));
        let (left, right) = (self.taken_for(left, base), self.taken_for(right, base));
        let made = Expr {
            kind: ExprKind::Binary(op, Box::new(left), Box::new(right)),
            base,
            ty: TypeId::of(base),
            at: span,
        };
        Some(match typed {
            true => made,
            false => self.bits_as_number(made),
        })
    }

    /// The 32 bits of a number as those of another type.
    fn taken_for(&mut self, number: Expr, base: Base) -> Expr {
        if base == number.base {
            return number;
        }
        if base == Base::Real && !self.is_plain(&number) {
            return self.front.c.builder.coerce(number, TypeId::of(base));
        }
        let at = number.at;
        let (how, kind) = match (base, number.kind) {
            (Base::Real, ExprKind::Constant(value)) => {
                let real = f32::from_bits((value.int() as i32).cast_unsigned());
                let value = Value::Real(real.into());
                return self.front.c.builder.literal(Base::Real, value, at);
            }
            // What has just been taken for a number.
            (_, ExprKind::Convert(Convert::Bits | Convert::Keep | Convert::Wrap, of))
                if of.base == base =>
            {
                return *of;
            }
            (Base::Real, kind) => (Convert::Raw, kind),
            (_, kind) => (Convert::Keep, kind),
        };
        Expr {
            kind: ExprKind::Convert(how, Box::new(Expr { kind, ..number })),
            base,
            ty: TypeId::of(base),
            at,
        }
    }

    /// The bits of a value of 32 bits as a DINT.
    fn bits_as_number(&mut self, value: Expr) -> Expr {
        let how = match value.base {
            Base::Dint => return value,
            Base::Real => Convert::Bits,
            _ => Convert::Keep,
        };
        let at = value.at;
        Expr {
            kind: ExprKind::Convert(how, Box::new(value)),
            base: Base::Dint,
            ty: TypeId::of(Base::Dint),
            at,
        }
    }

    /// Two numbers in one.
    pub(super) fn joined(&mut self, op: Binary, left: Expr, right: Expr, at: Span) -> Expr {
        Expr {
            kind: ExprKind::Binary(op, Box::new(left), Box::new(right)),
            base: Base::Dint,
            ty: TypeId::of(Base::Dint),
            at,
        }
    }

    pub(super) fn unary(&mut self, instr: &Instr, opcode: Opcode) {
        let Some(expr) = self.take(operator(opcode), instr.span) else {
            return;
        };
        let expr = match (opcode, expr.base) {
            (Opcode::RealComparable, Base::Real) => self.bits_as_number(expr),
            _ => expr,
        };
        if !self.is_plain(&expr) {
            return self.typed_unary(operator(opcode), expr, instr);
        }
        let Some(number) = self.as_number(expr, ACCUMULATOR, instr.span) else {
            return;
        };
        let at = instr.span;
        let (from, how) = match opcode {
            Opcode::Negate => (Base::Dint, How::Does(Unary::Negate)),
            Opcode::SquareRoot => (Base::Dint, How::Does(Unary::Sqrt)),
            Opcode::RealNegate => (Base::Real, How::Does(Unary::Negate)),
            Opcode::RealAbsolute => (Base::Real, How::Does(Unary::Abs)),
            Opcode::RealRoot => (Base::Real, How::Does(Unary::Sqrt)),
            Opcode::RealComparable => (Base::Dint, How::Does(Unary::Order)),
            Opcode::RealFromSigned => (Base::Dint, How::Becomes(Convert::Float, Base::Real)),
            Opcode::RealFromUnsigned => (Base::Udint, How::Becomes(Convert::Float, Base::Real)),
            Opcode::RealRound => (Base::Real, How::Becomes(Convert::Round, Base::Dint)),
            Opcode::RealCut => (Base::Real, How::Becomes(Convert::Cut, Base::Dint)),
            _ => return self.not_yet(at),
        };
        let number = Box::new(self.taken_for(number, from));
        let (kind, base) = match how {
            How::Does(op) => (ExprKind::Unary(op, number), from),
            How::Becomes(how, base) => (ExprKind::Convert(how, number), base),
        };
        let ty = TypeId::of(base);
        let made = self.bits_as_number(Expr { kind, base, ty, at });
        self.hold(Some(made));
        self.link();
    }

    pub(super) fn shift(&mut self, instr: &Instr, opcode: Opcode) {
        let expr = self.take(name(instr.op), instr.span);
        if let Some(bits) = expr.as_ref().filter(|expr| self.shifts_bits(expr, instr)) {
            return self.norm(name(instr.op), bits.clone(), instr);
        }
        let number = expr.and_then(|expr| self.as_number(expr, ACCUMULATOR, instr.span));
        if instr.operands.is_empty() {
            return self.missing(name(instr.op), instr.span);
        }
        self.only(instr, 1);
        let (Some(bits), Some(number)) = (self.bits_of(instr), number) else {
            return;
        };
        let at = instr.whole;
        let op = match opcode {
            Opcode::ShiftLeft => Binary::ShiftLeft,
            Opcode::ShiftRight => Binary::ShiftRight,
            Opcode::ExtendSign | Opcode::ExtendZero => {
                let base = match (opcode, bits) {
                    (Opcode::ExtendSign, 8) => Some(Base::Sint),
                    (Opcode::ExtendSign, 16) => Some(Base::Int),
                    (Opcode::ExtendZero, 8) => Some(Base::Usint),
                    (Opcode::ExtendZero, 16) => Some(Base::Uint),
                    _ => None,
                };
                let cut = match base {
                    Some(base) => self.cut(number, base),
                    None => {
                        let op = Unary::Low(bits, opcode == Opcode::ExtendSign);
                        let kind = ExprKind::Unary(op, Box::new(number));
                        let (base, ty) = (Base::Dint, TypeId::of(Base::Dint));
                        Expr { kind, base, ty, at }
                    }
                };
                self.hold(Some(cut));
                return self.link();
            }
            _ => return self.not_yet(instr.span),
        };
        let by = self.whole(bits.into(), at);
        let shifted = self.joined(op, number, by, at);
        self.hold(Some(shifted));
        self.link();
    }

    /// A number in the bits of a type, as a DINT again.
    pub(super) fn cut(&mut self, number: Expr, base: Base) -> Expr {
        let builder = &mut self.front.c.builder;
        let cut = builder.converted(number, Convert::Wrap, TypeId::of(base));
        self.wide(cut)
    }
}

/// Whether two numbers are compared and divided without a sign: those of which one is a UDINT or DWORD, and the other is none
/// that may be negative.
fn is_unsigned(left: &Expr, right: &Expr) -> bool {
    let unsigned = |expr: &Expr| match &expr.kind {
        ExprKind::Convert(Convert::Wrap, of) => matches!(of.base, Base::Udint | Base::Dword),
        _ => false,
    };
    let fits = |expr: &Expr| unsigned(expr) || constant(expr).is_some_and(|number| number >= 0);
    (unsigned(left) || unsigned(right)) && fits(left) && fits(right)
}
