//! Words that values go by in messages, and the numbers that stand in the text.

use unoclp_tree::{Base, Expr, ExprKind};

/// Words in two languages.
pub(super) type Words = (&'static str, &'static str);
pub(super) const BOOL: Words = ("true or false (BOOL)", "verdadeiro ou falso (BOOL)");
pub(super) const NUMBER: Words = ("a number", "um número");
pub(super) const BLOCK: Words = ("a block", "um bloco");
/// What a value is called in messages where it has no name.
pub(super) const ACCUMULATOR: Words = ("the accumulator", "o acumulador");
pub(super) const OPERAND: Words = ("the operand", "o operando");

/// The number that stands in the text.
pub(super) fn constant(expr: &Expr) -> Option<i32> {
    match &expr.kind {
        ExprKind::Constant(value) if expr.base == Base::Dint => Some(value.int() as i32),
        _ => None,
    }
}
