//! What works on the accumulator: loads and operations with an operand.

use super::run::Acc;
use super::said::{ACCUMULATOR, OPERAND, constant};
use super::walk::Walk;
use crate::ast::Instr;
use crate::operators::Op;
use crate::words::operator;
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Base, Binary, Expr};

/// The operand that stands for what was pushed.
const POP: &str = "POP";

/// What messages call an operation.
pub(super) fn name(op: Op) -> &'static str {
    match op {
        Op::And => "AND",
        Op::Or => "OR",
        Op::Xor => "XOR",
        Op::Number(opcode) | Op::Compare(opcode) | Op::Shift(opcode) | Op::Table(opcode) => {
            operator(opcode)
        }
        _ => "",
    }
}

impl Walk<'_, '_, '_> {
    pub(super) fn load(&mut self, instr: &Instr) {
        self.run.decided = None;
        self.hint = None;
        self.warn_unused();
        self.run.unused = Some(instr.whole);
        let inverted = std::mem::take(&mut self.run.inverts) != instr.negated;
        self.run.links = 0;
        let Some(operand) = instr.operands.first() else {
            self.missing("LD", instr.span);
            self.run.acc = Acc::Wrong;
            return;
        };
        self.only(instr, 1);
        if let Some(whole) = self.whole_variable(operand) {
            self.run.acc = Acc::Whole(whole);
            return;
        }
        let mut expr = self.value(operand);
        if inverted {
            expr = expr.map(|expr| self.opposite(expr, operand.span));
        }
        if instr.edge.is_some() {
            let unused = self.run.unused;
            expr = expr.and_then(|expr| {
                let bit = self.as_bit(expr, ACCUMULATOR, instr.span)?;
                self.edge_of(bit, instr.span)
            });
            self.run.unused = unused;
        }
        self.hold(expr);
    }

    /// The opposite: of a number, each bit's.
    pub(super) fn opposite(&mut self, expr: Expr, span: Span) -> Expr {
        if expr.base == Base::Bool || !self.is_plain(&expr) {
            return self.front.c.builder.not(expr, span);
        }
        if let Some(number @ 0..=1) = constant(&expr) {
            return self.truth(number == 0, expr.at);
        }
        let ones = self.whole(-1, span);
        self.joined(Binary::Xor, expr, ones, span)
    }

    pub(super) fn not(&mut self, instr: &Instr) {
        if let Some(state) = self.run.decided {
            self.run.unused = None;
            self.run.decided = Some(!state);
            return;
        }
        let expr = self.take("NOT", instr.span);
        let expr = expr.map(|expr| self.opposite(expr, instr.span));
        self.hold(expr);
    }

    /// AND, OR, XOR, arithmetic and comparisons, at once or deferred.
    pub(super) fn operate(&mut self, instr: &Instr) {
        if let Some(open) = instr.open {
            return self.open(instr, open);
        }
        let mut left = self.take(name(instr.op), instr.span);
        self.hint = left.as_ref().map(|left| left.ty);
        let Some(operand) = instr.operands.first() else {
            return self.missing(name(instr.op), instr.span);
        };
        let typed = left.as_ref().is_some_and(|left| !self.is_plain(left));
        let more = instr.op.takes_list() && !instr.negated || typed;
        // `LT 2, 3`: each less than the next.
        if let (Some(left), Op::Compare(opcode), [_, _, ..]) = (&left, instr.op, &*instr.operands) {
            return self.norm(operator(opcode), left.clone(), instr);
        }
        self.only(instr, if more { usize::MAX } else { 1 });
        if operand.name() == Some(POP) && matches!(instr.op, Op::Number(_) | Op::Compare(_)) {
            self.only(instr, 1);
            let span = instr.whole;
            let right = left.and_then(|right| match self.is_plain(&right) {
                true => self.as_number(right, ACCUMULATOR, span),
                false => Some(right),
            });
            let popped = self.popped_number(span);
            let made = self.both(popped, right, instr.op, false, span);
            return self.linked(made);
        }
        if instr.edge.is_some() {
            let bit = self.value(operand);
            let bit = bit.and_then(|bit| self.as_bit(bit, ACCUMULATOR, instr.span));
            let bit = bit.and_then(|bit| self.edge_of(bit, instr.span));
            let made = self.both(left, bit, instr.op, false, instr.whole);
            return self.linked(made);
        }
        let listed = if more { instr.operands.len() } else { 1 };
        for (index, operand) in instr.operands.iter().take(listed).enumerate() {
            let right = self.value(operand);
            let span = if index == 0 {
                instr.whole
            } else {
                operand.span
            };
            let made = self.both(left, right, instr.op, instr.negated, span);
            self.linked(made);
            left = match &self.run.acc {
                Acc::Value(expr) => Some(expr.clone()),
                _ => None,
            };
        }
        if typed {
            self.run.unused = Some(instr.whole);
        }
    }

    fn linked(&mut self, made: Option<Expr>) {
        self.hold(made);
        self.link();
    }

    fn both(
        &mut self,
        left: Option<Expr>,
        right: Option<Expr>,
        op: Op,
        negated: bool,
        span: Span,
    ) -> Option<Expr> {
        self.apply(op, negated, left?, right?, span)
    }

    /// The result of an operation on two values.
    pub(super) fn apply(
        &mut self,
        op: Op,
        negated: bool,
        left: Expr,
        right: Expr,
        span: Span,
    ) -> Option<Expr> {
        let right = match negated {
            true => self.opposite(right, span),
            false => right,
        };
        if !(op.is_real() || self.is_plain(&left) && self.is_plain(&right)) {
            return self.of_types(op, left, right, span);
        }
        let bits = left.base == Base::Bool || right.base == Base::Bool;
        let on_bits = match op {
            Op::Number(_) => false,
            Op::Compare(opcode) => bits && matches!(opcode, Opcode::Equal | Opcode::NotEqual),
            _ => bits,
        };
        if on_bits {
            let left = self.as_bit(left, ACCUMULATOR, span);
            let right = self.as_bit(right, OPERAND, span);
            let (left, right) = (left?, right?);
            let builder = &mut self.front.c.builder;
            return Some(match op {
                Op::And => builder.logic(Binary::And, left, right, span),
                Op::Or => builder.logic(Binary::Or, left, right, span),
                Op::Compare(Opcode::Equal) => {
                    let other = builder.logic(Binary::Xor, left, right, span);
                    builder.not(other, span)
                }
                _ => builder.logic(Binary::Xor, left, right, span),
            });
        }
        let left = self.as_number(left, ACCUMULATOR, span);
        let right = self.as_number(right, OPERAND, span);
        self.computed(op, left?, right?, span)
    }

    /// EU, ED: the accumulator's own rise or fall.
    pub(super) fn edge(&mut self, instr: &Instr, opcode: Opcode) {
        let Some(bit) = self.take_bit(operator(opcode), instr.span) else {
            return;
        };
        let changed = self.edge_of(bit, instr.span);
        self.run.links = 0;
        self.hold(changed);
    }

    /// The shift's number of bits; told where it is none.
    pub(super) fn bits_of(&mut self, instr: &Instr) -> Option<u8> {
        let operand = instr.operands.first()?;
        let bits = operand.number().and_then(|n| u8::try_from(n).ok());
        let bits = bits.filter(|&bits| bits <= 31);
        if bits.is_none() {
            let text = self.spelled(operand);
            let range = ("a number from 0 to 31", "um número de 0 a 31");
            self.tell(Code::BadValue, operand.span, [text.into(), range.into()]);
        }
        bits
    }
}
