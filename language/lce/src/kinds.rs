//! Operators: the type of both sides, and of the result.
//!
//! Owns R, D, W and B of expressions. Must not know what is stored where.

use super::ast::{Kind, Node, NodeKind, Op};
use super::checker::Checker;
use super::values::Val;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Binary, Convert, Expr, ExprKind};

impl Checker<'_, '_> {
    pub(super) fn value(&mut self, node: &Node) -> Val {
        let at = node.span;
        match &node.kind {
            NodeKind::Wrong => Val::Wrong(at),
            NodeKind::Number(value, based) => Val::Number(value.clone(), *based, at),
            NodeKind::Name(name) => {
                let slot = self.slot(name);
                self.held(slot, at)
            }
            NodeKind::Not(inner) => {
                let inner = self.value(inner);
                let bit = self.as_bit(inner);
                Val::Bit(self.builder.not(bit, at))
            }
            NodeKind::Binary(op, kind, sign, both) => {
                let (a, b) = (self.value(&both.0), self.value(&both.1));
                self.joined(*op, *kind, *sign, a, b, at)
            }
        }
    }

    fn joined(&mut self, op: Op, kind: Option<Kind>, sign: Span, a: Val, b: Val, at: Span) -> Val {
        let sign = self.builder.written(sign);
        match op {
            Op::Compare(op) => {
                let real = self.may_be_real(&a) || self.may_be_real(&b);
                let kind = kind.unwrap_or(if real { Kind::R } else { Kind::D });
                let (a, b) = (self.taken(a, kind, &sign), self.taken(b, kind, &sign));
                Val::Bit(self.builder.compare(op, a, b, at))
            }
            Op::Logic(op) => {
                // Of two bits, the bits of their numbers come to the same.
                if let (Val::Bit(a), Val::Bit(b)) = (&a, &b) {
                    let (a, b) = (a.clone(), b.clone());
                    return Val::Bit(self.builder.logic(op, a, b, at));
                }
                let kind = kind.unwrap_or(Kind::D);
                let (a, b) = (self.taken(a, kind, &sign), self.taken(b, kind, &sign));
                let (a, b) = (self.bits(a), self.bits(b));
                let joined = self.builder.logic(op, a, b, at);
                Val::Whole(self.to(joined, Convert::Wrap, Base::Dint))
            }
            Op::Arithmetic(op) => {
                let kind = kind.unwrap_or(Kind::D);
                let (a, b) = (self.taken(a, kind, &sign), self.taken(b, kind, &sign));
                let result = self.builder.arithmetic(op, a, b, at);
                match kind {
                    _ if matches!(result.kind, ExprKind::Wrong) => Val::Wrong(at),
                    Kind::R => Val::Real(result),
                    // A quotient of two that fit fits.
                    _ if op == Binary::Divide => Val::Whole(result),
                    _ => Val::Whole(self.cut_to(result, kind)),
                }
            }
        }
    }

    fn bits(&mut self, expr: Expr) -> Expr {
        self.to(expr, Convert::Wrap, Base::Dword)
    }
}
