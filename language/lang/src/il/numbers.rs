//! Numbers: 32 bits with a sign, whatever is done with them.

use super::bits::name;
use super::said::ACCUMULATOR;
use super::walk::Walk;
use crate::ast::Instr;
use crate::diagnostics::Span;
use crate::operators::Op;
use crate::typed::{Base, Binary, Compare, Convert, Expr, ExprKind, TypeId, Unary};
use crate::words::operator;
use unoclp_core::isa::Opcode;

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
        let compare = match opcode {
            Opcode::Greater => Compare::Greater,
            Opcode::GreaterOrEqual => Compare::GreaterEqual,
            Opcode::Equal => Compare::Equal,
            Opcode::NotEqual => Compare::NotEqual,
            Opcode::LessOrEqual => Compare::LessEqual,
            Opcode::Less => Compare::Less,
            _ => {
                let op = match opcode {
                    Opcode::Add => Binary::Add,
                    Opcode::Subtract => Binary::Subtract,
                    Opcode::Multiply => Binary::Multiply,
                    Opcode::Divide => Binary::Divide,
                    Opcode::Modulo => Binary::Modulo,
                    _ => {
                        self.not_yet(span);
                        return None;
                    }
                };
                return Some(self.joined(op, left, right, span));
            }
        };
        let builder = &mut self.front.builder;
        Some(builder.compare(compare, left, right, span))
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
        let Some(number) = self.as_number(expr, ACCUMULATOR, instr.span) else {
            return;
        };
        let op = match opcode {
            Opcode::Negate => Unary::Negate,
            Opcode::SquareRoot => Unary::Sqrt,
            _ => return self.not_yet(instr.span),
        };
        self.hold(Some(Expr {
            kind: ExprKind::Unary(op, Box::new(number)),
            base: Base::Dint,
            ty: TypeId::of(Base::Dint),
            at: instr.span,
        }));
        self.link();
    }

    pub(super) fn shift(&mut self, instr: &Instr, opcode: Opcode) {
        let expr = self.take(name(instr.op), instr.span);
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
                    (Opcode::ExtendSign, 8) => Base::Sint,
                    (Opcode::ExtendSign, 16) => Base::Int,
                    (Opcode::ExtendZero, 8) => Base::Usint,
                    (Opcode::ExtendZero, 16) => Base::Uint,
                    _ => return self.not_yet(instr.span),
                };
                let cut = self.cut(number, base);
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
        let builder = &mut self.front.builder;
        let cut = builder.converted(number, Convert::Wrap, TypeId::of(base));
        self.wide(cut)
    }
}
