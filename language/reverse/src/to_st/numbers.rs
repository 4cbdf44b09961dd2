//! The value accumulator: loads, operations and comparisons.
//!
//! Owns what each operation is. Must not know types, nor where numbers are stored.

use super::expr::{Expr, Place, Type, View, and, binary, call, compare, not, sign, whole};
use super::machine::{Machine, Number};
use super::views::is_finite;
use super::why::Why;
use unoclp_core::Instruction;
use unoclp_core::isa::{Class, Opcode, Operand, Value};
use unoclp_point::Address;

/// More parts than this are put aside, so that no chain of operations becomes one long expression.
const LONG: usize = 24;

impl Machine<'_, '_> {
    pub fn load(&mut self, step: Instruction<'_>) -> Result<(), Why> {
        let xx = step.number().unwrap_or_default();
        let place = |place| Number(Expr::Place(place), Type::Dint);
        self.value = match step.opcode {
            Opcode::Load => match step.operand {
                Operand::Value(Value::Register(register)) => self.register(register),
                Operand::Value(Value::Constant(number)) => Number(whole(number), Type::Dint),
                // Value is the operand, and what was pushed is gone.
                _ => {
                    self.pushed.pop();
                    return Ok(());
                }
            },
            Opcode::LoadAnalogue => place(Place::At(Address::Analogue(xx))),
            Opcode::LoadTimer => Number(self.elapsed(xx)?, Type::Dint),
            Opcode::LoadCount => place(Place::At(Address::Count(xx))),
            Opcode::LoadMarkers => {
                let first = (xx - 1) * 8 + 1;
                self.gathered((first..first + 8).map(|n| Some(Place::At(Address::Marker(n)))))
            }
            Opcode::LoadInputs => {
                let inputs = self.inputs();
                self.gathered(inputs.into_iter())
            }
            Opcode::LoadOutputs => {
                let outputs = self.outputs();
                self.gathered(outputs.into_iter())
            }
            Opcode::LoadBit => Number(from_bit(self.acc.clone()), Type::Dint),
            _ => return Err(Why::NoWords),
        };
        Ok(())
    }

    /// Bits as a number, the first the lowest; what is no bit is 0.
    fn gathered(&self, bits: impl Iterator<Item = Option<Place>>) -> Number {
        let parts = bits
            .enumerate()
            .filter_map(|(at, place)| Some((at, place?)));
        let parts = parts.map(|(at, place)| {
            let bit = from_bit(Expr::Place(place));
            if at == 0 {
                bit
            } else {
                binary("*", bit, whole(1 << at))
            }
        });
        let sum = parts.reduce(|sum, part| binary("+", sum, part));
        Number(sum.unwrap_or(whole(0)), Type::Dint)
    }

    /// The operand of a step, and what stands left of it.
    fn operands(&mut self, step: Instruction<'_>) -> (Number, Number) {
        let value = self.value.clone();
        match step.operand {
            Operand::Value(Value::Register(register)) => (value, self.register(register)),
            Operand::Value(Value::Constant(number)) => (value, Number(whole(number), Type::Dint)),
            _ => {
                let left = self.pushed.pop();
                (left.unwrap_or(Number(whole(0), Type::Dint)), value)
            }
        }
    }

    pub fn comparison(&mut self, step: Instruction<'_>) {
        self.shorten_value();
        let holds = match step.opcode.class() {
            Class::ValueContact => {
                let bit = 1_i32.wrapping_shl(step.number().unwrap_or_default().into());
                let value = self.value.clone();
                let holds = self.has_bit(value, bit);
                if step.opcode.is_inverted() {
                    not(holds)
                } else {
                    holds
                }
            }
            _ => {
                let (left, right) = self.operands(step);
                if step.operand == Operand::Value(Value::Popped) {
                    self.value = left.clone();
                }
                self.compared(step.opcode, left, right)
            }
        };
        let acc = std::mem::replace(&mut self.acc, Expr::Is(true));
        self.acc = and(acc, holds);
    }

    /// Whether a number has this bit.
    pub fn has_bit(&mut self, number: Number, bit: i32) -> Expr {
        let bits = binary("AND", self.dword(number), Expr::Constant(bit, Type::Dword));
        compare("<>", bits, Expr::Constant(0, Type::Dword))
    }

    fn compared(&mut self, opcode: Opcode, left: Number, right: Number) -> Expr {
        let sign = sign(opcode);
        if matches!(
            opcode,
            Opcode::UnsignedGreaterOrEqual | Opcode::UnsignedLess
        ) {
            return compare(sign, self.udint(left), self.udint(right));
        }
        match (&left.0, &right.0) {
            (Expr::Order(a), Expr::Order(b)) => return compare(sign, (**a).clone(), (**b).clone()),
            (Expr::Order(a), Expr::Constant(number, Type::Dint)) => {
                if let Some(real) = real_of_order(*number) {
                    return compare(sign, (**a).clone(), Expr::Constant(real, Type::Real));
                }
            }
            (Expr::Constant(number, Type::Dint), Expr::Order(b)) => {
                if let Some(real) = real_of_order(*number) {
                    return compare(sign, Expr::Constant(real, Type::Real), (**b).clone());
                }
            }
            (Expr::Constant(a, _), Expr::Constant(b, _)) => {
                return Expr::Is(match opcode {
                    Opcode::Greater => a > b,
                    Opcode::GreaterOrEqual => a >= b,
                    Opcode::Equal => a == b,
                    Opcode::NotEqual => a != b,
                    Opcode::LessOrEqual => a <= b,
                    _ => a < b,
                });
            }
            _ => {}
        }
        compare(sign, self.dint(left), self.dint(right))
    }

    pub fn operation(&mut self, step: Instruction<'_>) -> Result<(), Why> {
        let opcode = step.opcode;
        if opcode == Opcode::Push {
            self.shorten_value();
            self.pushed.push(self.value.clone());
            return Ok(());
        }
        let (left, right) = match step.operand {
            Operand::Value(_) => self.operands(step),
            _ => (self.value.clone(), Number(whole(0), Type::Dint)),
        };
        let xx = step.number().unwrap_or_default();
        let made = match opcode {
            Opcode::Add => self.whole("+", left, right),
            Opcode::Subtract => self.whole("-", left, right),
            Opcode::Multiply => self.whole("*", left, right),
            Opcode::Divide => self.whole("/", left, right),
            Opcode::Modulo => self.whole("MOD", left, right),
            Opcode::UnsignedDivide => self.unsigned("/", left, right),
            Opcode::UnsignedModulo => self.unsigned("MOD", left, right),
            Opcode::AndWord => self.pattern("AND", left, right),
            Opcode::OrWord => self.pattern("OR", left, right),
            Opcode::XorWord => self.pattern("XOR", left, right),
            Opcode::ShiftLeft => self.shifted("SHL", left, xx),
            Opcode::ShiftRight => self.shifted("SHR", left, xx),
            Opcode::ExtendZero => {
                let low = Number(whole(low_bits(xx)), Type::Dint);
                self.pattern("AND", left, low)
            }
            Opcode::ExtendSign => self.extended(left, xx),
            Opcode::Negate => {
                let left = self.variable(left);
                let expr = self.dint(left);
                Number(Expr::Negate(Box::new(expr)), Type::Dint)
            }
            Opcode::SquareRoot => {
                self.body.roots = true;
                Number(call("root", self.dint(left)), Type::Dint)
            }
            Opcode::Scale => self.scaled(left, step.operand),
            Opcode::RealAdd => self.reals("+", left, right),
            Opcode::RealSubtract => self.reals("-", left, right),
            Opcode::RealMultiply => self.reals("*", left, right),
            Opcode::RealDivide => self.reals("/", left, right),
            Opcode::RealFromSigned => Number(call("DINT_TO_REAL", self.dint(left)), Type::Real),
            Opcode::RealFromUnsigned => Number(call("UDINT_TO_REAL", self.udint(left)), Type::Real),
            Opcode::RealRound => Number(call("REAL_TO_DINT", self.real_variable(left)), Type::Dint),
            Opcode::RealCut => Number(
                call("REAL_TRUNC_DINT", self.real_variable(left)),
                Type::Dint,
            ),
            Opcode::RealNegate => {
                let expr = self.real_variable(left);
                Number(Expr::Negate(Box::new(expr)), Type::Real)
            }
            Opcode::RealAbsolute => Number(call("ABS", self.real_variable(left)), Type::Real),
            Opcode::RealRoot => Number(call("SQRT", self.real_variable(left)), Type::Real),
            Opcode::RealComparable => {
                let expr = self.real(left);
                Number(Expr::Order(Box::new(expr)), Type::Dint)
            }
            Opcode::LoadTable => self.element(left, step.operand),
            _ => return Err(Why::NoWords),
        };
        self.value = made;
        let fails = self.errors && may_fail(opcode);
        if fails {
            self.changes(&|place| place == Place::At(Address::System(4)));
        }
        if (fails || self.value.0.size() > LONG) && !matches!(self.value.0, Expr::Place(_)) {
            let value = self.value.clone();
            self.value = self.number_aside(value);
        }
        Ok(())
    }

    /// A constant in a variable: what is computed of constants alone is told where it does not fit.
    fn variable(&mut self, number: Number) -> Number {
        match number.0 {
            Expr::Constant(..) => self.number_aside(number),
            _ => number,
        }
    }

    fn real_variable(&mut self, number: Number) -> Expr {
        let expr = self.real(number);
        let number = self.variable(Number(expr, Type::Real));
        number.0
    }

    fn apart(&mut self, left: Number, right: &Number) -> Number {
        match right.0 {
            Expr::Constant(..) => self.variable(left),
            _ => left,
        }
    }

    fn whole(&mut self, sign: &'static str, left: Number, right: Number) -> Number {
        let left = self.apart(left, &right);
        let left = self.dint(left);
        let right = match (sign, &right.0) {
            ("/" | "MOD", Expr::Constant(0, _)) => Expr::Place(Place::Zero(View::Whole)),
            _ => self.dint(right),
        };
        Number(binary(sign, left, right), Type::Dint)
    }

    fn unsigned(&mut self, sign: &'static str, left: Number, right: Number) -> Number {
        let left = self.apart(left, &right);
        let left = self.udint(left);
        let right = match &right.0 {
            Expr::Constant(0, _) => call("DINT_TO_UDINT", Expr::Place(Place::Zero(View::Whole))),
            _ => self.udint(right),
        };
        Number(binary(sign, left, right), Type::Udint)
    }

    fn pattern(&mut self, sign: &'static str, left: Number, right: Number) -> Number {
        let left = self.apart(left, &right);
        let (left, right) = (self.dword(left), self.dword(right));
        Number(binary(sign, left, right), Type::Dword)
    }

    fn shifted(&mut self, function: &'static str, left: Number, by: u8) -> Number {
        let left = self.variable(left);
        let expr = self.dword(left);
        Number(
            Expr::Call(function, vec![expr, whole(by.into())]),
            Type::Dword,
        )
    }

    fn reals(&mut self, sign: &'static str, left: Number, right: Number) -> Number {
        let left = self.apart(left, &right);
        let left = self.real(left);
        let right = match (sign, self.real(right)) {
            ("/", Expr::Constant(0 | i32::MIN, _)) => Expr::Place(Place::Zero(View::Real)),
            (_, right) => right,
        };
        Number(binary(sign, left, right), Type::Real)
    }

    /// The low bits, the highest of them as the sign.
    fn extended(&mut self, left: Number, bits: u8) -> Number {
        let left = self.variable(left);
        match bits {
            0 => Number(whole(0), Type::Dint),
            8 => Number(
                call("SINT_TO_DINT", call("DINT_TO_SINT", self.dint(left))),
                Type::Dint,
            ),
            16 => Number(
                call("INT_TO_DINT", call("DINT_TO_INT", self.dint(left))),
                Type::Dint,
            ),
            _ => {
                let low = Number(whole(low_bits(bits)), Type::Dint);
                let high = 1_i32 << (bits - 1);
                let low = self.pattern("AND", left, low);
                let turned = self.pattern("XOR", low, Number(whole(high), Type::Dint));
                let expr = self.dint(turned);
                Number(binary("-", expr, whole(high)), Type::Dint)
            }
        }
    }

    /// Linear scaling: the product has up to 32 bits without a sign.
    fn scaled(&mut self, left: Number, operand: Operand<'_>) -> Number {
        let Operand::Scale { from, to } = operand else {
            return left;
        };
        let [low, high] = from.map(i32::from);
        let [to_low, to_high] = to.map(i32::from);
        let left = self.variable(left);
        let value = self.dint(left);
        let value = Expr::Call("LIMIT", vec![whole(low), value, whole(high)]);
        let value = match low {
            0 => value,
            low => binary("-", value, whole(low)),
        };
        let (span, rise) = (high - low, to_high - to_low);
        let wide = i64::from(span) * i64::from(rise.abs()) > i64::from(i32::MAX);
        let part = match (rise, wide) {
            (0, _) => return Number(whole(to_low), Type::Dint),
            (_, false) => binary("/", binary("*", value, whole(rise.abs())), whole(span)),
            (_, true) => {
                let constant = |number| Expr::Constant(number, Type::Udint);
                let product = binary("*", call("DINT_TO_UDINT", value), constant(rise.abs()));
                call("UDINT_TO_DINT", binary("/", product, constant(span)))
            }
        };
        let expr = match (to_low, rise > 0) {
            (0, true) => part,
            (0, false) => Expr::Negate(Box::new(part)),
            (to_low, true) => binary("+", part, whole(to_low)),
            (to_low, false) => binary("-", whole(to_low), part),
        };
        Number(expr, Type::Dint)
    }
}

/// A bit as a number.
fn from_bit(bit: Expr) -> Expr {
    match bit {
        Expr::Is(is) => whole(is.into()),
        bit => call("BOOL_TO_DINT", bit),
    }
}

/// The bits of the REAL number that has this order; none where it is none, or infinite.
fn real_of_order(order: i32) -> Option<i32> {
    let bits = match order < 0 {
        true => order.checked_neg()? | i32::MIN,
        false => order,
    };
    is_finite(bits).then_some(bits)
}

fn low_bits(bits: u8) -> i32 {
    !(-1_i32).wrapping_shl(bits.into())
}

/// Whether it may set S 04.
fn may_fail(opcode: Opcode) -> bool {
    use Opcode::*;
    matches!(
        opcode,
        Divide
            | Modulo
            | UnsignedDivide
            | UnsignedModulo
            | SquareRoot
            | LoadTable
            | RealRoot
            | RealAdd
            | RealSubtract
            | RealMultiply
            | RealDivide
            | RealRound
            | RealCut
    )
}
