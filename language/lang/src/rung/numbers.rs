//! Numbers: the board's value, and what an operation takes its operand from.

use super::{Holds, Rungs, Written};
use crate::diagnostics::Span;
use crate::tree::{Num, Number, exchanged};
use unoclp_core::isa::{DEEPEST, Opcode, Value};
use unoclp_point::Address;

impl Rungs {
    pub(super) fn compare(&mut self, op: Opcode, left: &Number, right: &Number, span: Span) {
        if simple(right).is_none()
            && simple(left).is_some()
            && let Some(op) = exchanged(op)
        {
            return self.compare(op, right, left, span);
        }
        let operand = self.pair(left, right, span);
        self.changes(Written::Value(op, operand), span);
    }

    /// Brings a number into the board's value. The accumulator stays as it is.
    pub(crate) fn number(&mut self, number: &Number) {
        match number {
            Number::Live => {}
            Number::Leaf(num, span) => self.load(*num, *span),
            Number::Unary(op, inner, span) => {
                self.number(inner);
                self.write(Written::Plain(*op), *span);
            }
            Number::Shift(op, inner, bits, span) => {
                self.number(inner);
                self.write(Written::Numbered(*op, *bits), *span);
            }
            Number::Binary(op, left, right, span) => {
                let commutes = COMMUTING.contains(op);
                let exchange = commutes && simple(right).is_none() && simple(left).is_some();
                let (left, right) = if exchange {
                    (right, left)
                } else {
                    (left, right)
                };
                let operand = self.pair(left, right, *span);
                self.write(Written::Value(*op, operand), *span);
            }
        }
    }

    /// Brings the left number into the value, and the right one to where an operation can take it from.
    fn pair(&mut self, left: &Number, right: &Number, span: Span) -> Value {
        if let Some(value) = simple(right) {
            self.number(left);
            return value;
        }
        let kept = left.has_live().then(|| {
            // The left one begins with what the value holds, so it comes first.
            self.number(left);
            self.keep(span)
        });
        self.number(right);
        let operand = Value::Register(self.keep(span));
        match kept {
            Some(register) => self.write(
                Written::Value(Opcode::Load, Value::Register(register)),
                span,
            ),
            None => self.number(left),
        }
        operand
    }

    /// Stores the value in a register of its own. A store takes an accumulator of 1; within an AND block it
    /// begins with 1, and the block leaves it as it was.
    pub(crate) fn keep(&mut self, span: Span) -> u8 {
        let register = self.temps.register();
        if self.holds == Holds::One {
            self.write(Written::Numbered(Opcode::Store, register), span);
            return register;
        }
        let holds = self.holds;
        self.write(Written::Plain(Opcode::OpenAnd), span);
        if self.open >= DEEPEST {
            self.too_deep.get_or_insert(span);
        }
        self.write(Written::Numbered(Opcode::Store, register), span);
        self.write(Written::Plain(Opcode::CloseBranch), span);
        self.holds = holds;
        register
    }

    fn load(&mut self, num: Num, span: Span) {
        let written = match num {
            Num::Const(number) => Written::Value(Opcode::Load, Value::Constant(number)),
            Num::At(Address::Register(n)) => Written::Value(Opcode::Load, Value::Register(n)),
            Num::At(Address::Analogue(n)) => Written::Numbered(Opcode::LoadAnalogue, n),
            Num::At(Address::Count(n)) => Written::Numbered(Opcode::LoadCount, n),
            Num::Elapsed(timer) => self.of_timer(Opcode::LoadTimer, timer),
            Num::At(Address::Group(n)) => Written::Numbered(Opcode::LoadMarkers, n),
            Num::At(Address::Inputs(_)) => Written::Plain(Opcode::LoadInputs),
            // The names let nobody read what can only be written.
            _ => Written::Plain(Opcode::LoadOutputs),
        };
        self.write(written, span);
    }
}

/// The operations whose operands may change places.
const COMMUTING: &[Opcode] = &[
    Opcode::Add,
    Opcode::Multiply,
    Opcode::AndWord,
    Opcode::OrWord,
    Opcode::XorWord,
    Opcode::RealAdd,
    Opcode::RealMultiply,
];

/// What an operation can take its operand from.
fn simple(number: &Number) -> Option<Value> {
    match number {
        Number::Leaf(Num::Const(number), _) => Some(Value::Constant(*number)),
        Number::Leaf(Num::At(Address::Register(register)), _) => Some(Value::Register(*register)),
        _ => None,
    }
}
