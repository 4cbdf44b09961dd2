//! Functions of the standard on values of whatever type, and operations of which one value is no number of the board.

use super::calls::positional;
use super::typed::natural;
use super::walk::Walk;
use crate::ast::{Instr, Param};
use crate::operators::Op;
use crate::words::operator;
use unoclp_text::diagnostics::Span;
use unoclp_tree::build::{Argument, Given};
use unoclp_tree::{Base, Convert, Expr, ExprKind, TypeId};

impl Walk<'_, '_, '_> {
    /// An operation of the standard on values of which one is no number of the board.
    pub(super) fn of_types(&mut self, op: Op, left: Expr, right: Expr, at: Span) -> Option<Expr> {
        let name = match op {
            Op::And => "AND",
            Op::Or => "OR",
            Op::Xor => "XOR",
            Op::Number(opcode) | Op::Compare(opcode) => operator(opcode),
            _ => return None,
        };
        let real = [&left, &right].iter().any(|one| one.base.is_real());
        // What has no fraction meets no fraction.
        for (one, other) in [(&left, &right), (&right, &left)] {
            let whole = self.is_plain(other) && !is_narrow(other) && !is_real(other);
            if one.base == Base::AnyReal && whole {
                self.not_into(one.clone(), other.ty);
                return None;
            }
        }
        let [left, right] = [left, right].map(|one| match real {
            true => self.beside_real(one),
            false => natural(one),
        });
        self.function_of_norm(name, vec![left, right], at)
    }

    /// A whole number beside a REAL.
    pub(super) fn beside_real(&mut self, expr: Expr) -> Expr {
        let expr = natural(expr);
        let whole = expr.base.is_int() && !expr.base.is_any() && expr.base.bits() <= 32;
        match whole && !expr.base.widens_to(Base::Real) {
            true => {
                let real = TypeId::of(Base::Real);
                self.front.c.builder.converted(expr, Convert::Float, real)
            }
            false => expr,
        }
    }

    fn function_of_norm(&mut self, name: &str, values: Vec<Expr>, at: Span) -> Option<Expr> {
        let given = values.into_iter().map(value).collect();
        let made = self.front.c.builder.function(name, given, at);
        self.made(made)
    }

    fn made(&mut self, made: Expr) -> Option<Expr> {
        match made.kind {
            ExprKind::Wrong => None,
            _ => Some(self.wide(made)),
        }
    }

    /// A function of the standard by its name, `LIMIT 0, 10`, or `LIMIT (MN := 0, IN := a, MX := 10)` without the accumulator.
    pub(super) fn norm_operator(&mut self, instr: &Instr) {
        let name = self.front.names.written(instr.span);
        if instr.params.is_empty() {
            if let Some(expr) = self.take(&name, instr.span) {
                return self.norm(&name, expr, instr);
            }
            for operand in &instr.operands {
                self.meaning(operand);
            }
            return;
        }
        self.warn_unused();
        let mut given = Vec::new();
        for param in &instr.params {
            let named = param.name.as_ref();
            let value = self.argument(param);
            given.push(Argument {
                name: named.map(|name| (self.front.names.written(name.span), name.span)),
                ..value
            });
        }
        let made = self.front.c.builder.function(&name, given, instr.whole);
        let made = self.made(made);
        self.run.load(made);
        self.run.links = 1;
        self.run.unused = Some(instr.whole);
    }

    /// A function of the standard on the accumulator.
    pub(super) fn norm(&mut self, name: &str, expr: Expr, instr: &Instr) {
        self.hint = Some(expr.ty);
        let mut given = vec![value(natural(expr))];
        for operand in &instr.operands {
            given.push(self.argument(&positional(operand)));
        }
        let made = self.front.c.builder.function(name, given, instr.whole);
        let made = self.made(made);
        self.hold(made);
        self.link();
        self.run.unused = Some(instr.whole);
    }

    /// What a call gives.
    fn argument(&mut self, param: &Param) -> Argument {
        let at = param.value.span;
        let given = match self.value(&param.value) {
            Some(expr) if param.negated => {
                Given::Value(self.front.c.builder.not(natural(expr), at))
            }
            Some(expr) => Given::Value(natural(expr)),
            None => Given::Wrong,
        };
        Argument {
            name: None,
            out: false,
            at,
            given,
        }
    }

    /// Whether a shift is that of the standard: of what is no number of the board, or by a number that is computed.
    pub(super) fn shifts_bits(&self, expr: &Expr, instr: &Instr) -> bool {
        let by = instr.operands.first();
        let computed = by.is_some_and(|by| by.number().is_none() && !by.is_wrong());
        let base = natural(expr.clone()).base;
        !self.is_plain(expr) || computed && base.is_bits()
    }

    /// NEG, SQRT and their like of a value that is no number of the board.
    pub(super) fn typed_unary(&mut self, word: &str, expr: Expr, instr: &Instr) {
        let name = word
            .strip_prefix("REAL_")
            .filter(|name| !name.starts_with("TO_"));
        let name = name.unwrap_or(word);
        if name != "NEG" {
            return self.norm(name, expr, instr);
        }
        let made = self.front.c.builder.negate(expr, instr.span);
        let made = self.made(made);
        self.hold(made);
        self.link();
    }
}

/// A value without a parameter's name.
fn value(expr: Expr) -> Argument {
    Argument {
        name: None,
        out: false,
        at: expr.at,
        given: Given::Value(expr),
    }
}

/// Whether a number is a REAL that has been taken for a number of the board.
fn is_real(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Convert(Convert::Bits, of) if of.base.is_real())
}

/// Whether a number is computed from none that has more than 16 bits, so that it is a whole number beside a REAL.
fn is_narrow(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Constant(value) => i16::try_from(value.int()).is_ok(),
        ExprKind::Convert(Convert::Keep, of) => of.base.is_int() && of.base.bits() <= 16,
        ExprKind::Binary(_, a, b) => is_narrow(a) && is_narrow(b),
        ExprKind::Unary(_, of) => is_narrow(of),
        _ => false,
    }
}
