//! Comparisons of numbers.
//!
//! Owns which instructions they take; value and acc as operations leave them.

use super::coder::Coder;
use unoclp_core::isa::{Opcode, Value as Operand};
use unoclp_tree::{Compare, Expr, ExprKind};

/// The comparison with its sides exchanged.
fn exchanged(op: Compare) -> Compare {
    match op {
        Compare::Less => Compare::Greater,
        Compare::LessEqual => Compare::GreaterEqual,
        Compare::Greater => Compare::Less,
        Compare::GreaterEqual => Compare::LessEqual,
        same => same,
    }
}

fn opcode(op: Compare) -> Opcode {
    match op {
        Compare::Equal => Opcode::Equal,
        Compare::NotEqual => Opcode::NotEqual,
        Compare::Less => Opcode::Less,
        Compare::LessEqual => Opcode::LessOrEqual,
        Compare::Greater => Opcode::Greater,
        Compare::GreaterEqual => Opcode::GreaterOrEqual,
    }
}

impl Coder<'_, '_> {
    /// A comparison of two numbers, in series.
    pub(super) fn compare(&mut self, op: Compare, a: &Expr, b: &Expr) {
        if a.base.is_real() {
            self.compare_reals(op, a, b);
            return;
        }
        let unsigned = self.is_unsigned(a) || self.is_unsigned(b);
        if self.operand(b).is_none() && self.operand(a).is_some() {
            return self.compare(exchanged(op), b, a);
        }
        if unsigned {
            self.compare_unsigned(op, a, b);
            return;
        }
        let operand = self.pair(a, b);
        self.comparison(opcode(op), operand, b);
    }

    fn comparison(&mut self, opcode: Opcode, operand: Operand, b: &Expr) {
        let cell = self.named_operand(operand, b);
        let holds = self.pen.holds;
        self.pen.operation(opcode, operand, cell);
        // A comparison leaves value as it is, but for one with what was pushed.
        if operand != Operand::Popped {
            self.pen.holds = holds;
        }
    }

    fn compare_unsigned(&mut self, op: Compare, a: &Expr, b: &Expr) {
        let (opcode, turned) = match op {
            Compare::Equal => (Opcode::Equal, false),
            Compare::NotEqual => (Opcode::NotEqual, false),
            Compare::Less => (Opcode::UnsignedLess, false),
            Compare::GreaterEqual => (Opcode::UnsignedGreaterOrEqual, false),
            Compare::Greater => (Opcode::UnsignedLess, true),
            Compare::LessEqual => (Opcode::UnsignedGreaterOrEqual, true),
        };
        if !turned {
            let operand = self.pair(a, b);
            return self.comparison(opcode, operand, b);
        }
        if let ExprKind::Constant(value) = &b.kind {
            // a > n is a >= n + 1, and a <= n is a < n + 1.
            let number = value.int() as u32;
            if number == u32::MAX {
                // Never, or always.
                self.value(a);
                let opcode = match op {
                    Compare::Greater => Opcode::UnsignedLess,
                    _ => Opcode::UnsignedGreaterOrEqual,
                };
                return self.comparison(opcode, Operand::Constant(0), b);
            }
            self.value(a);
            let opcode = match op {
                Compare::Greater => Opcode::UnsignedGreaterOrEqual,
                _ => Opcode::UnsignedLess,
            };
            let next = number.wrapping_add(1).cast_signed();
            return self.comparison(opcode, Operand::Constant(next), b);
        }
        // The other way round.
        let operand = self.pair(b, a);
        self.comparison(opcode, operand, a);
    }

    fn compare_reals(&mut self, op: Compare, a: &Expr, b: &Expr) {
        let constant = |e: &Expr| matches!(e.kind, ExprKind::Constant(_));
        if constant(a) && !constant(b) {
            return self.compare_reals(exchanged(op), b, a);
        }
        if let ExprKind::Constant(value) = &b.kind {
            self.value(a);
            self.pen.changes_value(Opcode::RealComparable);
            let bits = (value.real() as f32).to_bits().cast_signed();
            let operand = Operand::Constant(unoclp_core::real::comparable(bits));
            return self.comparison(opcode(op), operand, b);
        }
        self.value(a);
        self.pen.changes_value(Opcode::RealComparable);
        self.pen.plain(Opcode::Push);
        self.value(b);
        self.pen.changes_value(Opcode::RealComparable);
        self.comparison(opcode(op), Operand::Popped, b);
    }
}
