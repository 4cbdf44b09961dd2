//! Which types go where: what an operator joins, and what a variable takes, in the words of InterSCL.
//!
//! INT goes into REAL by itself; nothing else changes its type. Owns the messages about that. Must not know places.

use super::ast::Op;
use super::check::Checker;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Target, both};
use unoclp_tree::{Base, Binary, Expr, ExprKind, Value};

fn is_wrong(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Wrong)
}

fn is_real(expr: &Expr) -> bool {
    matches!(expr.base, Base::Real | Base::AnyReal)
}

impl Checker<'_, '_> {
    /// Whether a variable of this type takes the value.
    pub(super) fn fits(&self, value: &Expr, held: Base) -> bool {
        match held {
            Base::Bool => {
                value.base == Base::Bool
                    || matches!(&value.kind, ExprKind::Constant(Value::Int(0 | 1)) if value.base == Base::AnyInt)
            }
            Base::Real => value.base != Base::Bool,
            _ => value.base != Base::Bool && !is_real(value),
        }
    }

    /// Tells that a variable does not take a value, and what to do.
    pub(super) fn told_mismatch(&mut self, target: &Target, value: &Expr, held: Base) {
        let (name, written) = (
            self.builder.written(target.at),
            self.builder.written(value.at),
        );
        let help = match (held, value.base) {
            (Base::Int, Base::Real | Base::AnyReal) => both(
                format!("a REAL would lose its fraction: declare REAL {name};"),
                format!("um REAL perderia as casas decimais: declare REAL {name};"),
            ),
            (Base::Bool, _) if matches!(value.kind, ExprKind::Constant(_)) => both(
                format!("write {name} := TRUE or {name} := FALSE"),
                format!("escreva {name} := TRUE ou {name} := FALSE"),
            ),
            (Base::Bool, _) => both(
                format!("compare it: {name} := {written} <> 0"),
                format!("compare-o: {name} := {written} <> 0"),
            ),
            _ => both(
                format!("test it: IF {written} THEN {name} := 1; ELSE {name} := 0; END_IF"),
                format!("teste-o: IF {written} THEN {name} := 1; ELSE {name} := 0; END_IF"),
            ),
        };
        let is = self.type_of(value);
        let words = [written.into(), is, name.into(), held.name().into(), help];
        self.builder.tell(Code::IsclMismatch, value.at, words);
    }

    /// Whether an operator that computes takes it; told if not.
    pub(super) fn is_number(&mut self, sign: &str, operand: &Expr) -> bool {
        if is_wrong(operand) {
            return false;
        }
        if operand.base != Base::Bool {
            return true;
        }
        let written = self.builder.written(operand.at);
        let help = both(
            format!(
                "AND and OR combine BOOL values; for a number, write IF {written} THEN … END_IF"
            ),
            format!(
                "AND e OR combinam valores BOOL; para um número, escreva IF {written} THEN … END_IF"
            ),
        );
        let needs = both("numbers", "números");
        let words = [sign.into(), needs, written.into(), "BOOL".into(), help];
        self.builder.tell(Code::IsclOperand, operand.at, words);
        false
    }

    /// Whether AND, OR and NOT take it; told if not.
    pub(super) fn is_bit(&mut self, sign: &str, operand: &Expr) -> bool {
        if is_wrong(operand) {
            return false;
        }
        if operand.base == Base::Bool {
            return true;
        }
        let written = self.builder.written(operand.at);
        let help = match sign {
            "NOT" => both(
                format!("NOT applies only to what follows it: write NOT ({written} = …)"),
                format!("NOT vale só para o que vem logo depois: escreva NOT ({written} = …)"),
            ),
            _ => both(
                format!("compare it with a value: {written} <> 0"),
                format!("compare com um valor: {written} <> 0"),
            ),
        };
        let is = self.type_of(operand);
        let words = [sign.into(), "BOOL".into(), written.into(), is, help];
        self.builder.tell(Code::IsclOperand, operand.at, words);
        false
    }

    /// Whether an operator joins the two; told if not.
    pub(super) fn goes_with(&mut self, op: Op, a: &Expr, b: &Expr, at: Span) -> bool {
        if is_wrong(a) || is_wrong(b) {
            return false;
        }
        match op {
            Op::Arithmetic(op) => {
                let sign = match op {
                    Binary::Add => "+",
                    Binary::Subtract => "-",
                    Binary::Multiply => "*",
                    _ => "/",
                };
                self.is_number(sign, a) && self.is_number(sign, b)
            }
            Op::Logic(op) => {
                let sign = if op == Binary::Or { "OR" } else { "AND" };
                self.is_bit(sign, a) && self.is_bit(sign, b)
            }
            Op::Compare(_) => {
                let (bit, other) = match (a.base == Base::Bool, b.base == Base::Bool) {
                    (true, false) => (a, b),
                    (false, true) => (b, a),
                    _ => return true,
                };
                let (written, number) =
                    (self.builder.written(bit.at), self.builder.written(other.at));
                let is = self.type_of(other);
                let help = both(
                    format!("a BOOL is true or false: write {written}, or NOT {written}"),
                    format!("um BOOL é verdadeiro ou falso: escreva {written} ou NOT {written}"),
                );
                let words = [number.into(), is, written.into(), "BOOL".into(), help];
                self.builder.tell(Code::IsclMismatch, at, words);
                false
            }
        }
    }
}
