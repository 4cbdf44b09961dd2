//! What each operation gives: for constants while a text is read, and for the interpreter while it runs.
//!
//! Each takes values of the types that the tree says and gives the result with whether S 04 is to be set. Owns
//! widths, wrapping and rounding. Must not know places and statements.

use super::base::Base;
pub use super::conversions::convert;
use super::expression::{Binary, Compare, Unary};
use super::value::Value;
use super::width::{FAILED, finite, int, narrowed, wide};
pub use super::width::{Outcome, narrow};
use std::cmp::Ordering;
use unoclp_core::real;

/// Of one operand of type `base`.
pub fn unary(op: Unary, base: Base, value: &Value) -> Outcome {
    if base.is_real() {
        let number = value.real();
        return match op {
            Unary::Abs => finite(base, number.abs()),
            Unary::Sqrt if number < 0.0 => (Value::Real(0.0), true),
            Unary::Sqrt => finite(base, number.sqrt()),
            _ => finite(base, -number),
        };
    }
    let number = value.int();
    match op {
        Unary::Negate => int(base, -number),
        Unary::Not => int(base, !number),
        Unary::Abs => int(base, number.abs()),
        Unary::Sqrt if number < 0 => FAILED,
        Unary::Sqrt => int(base, number.unsigned_abs().isqrt() as i128),
        Unary::Low(bits, signed) => {
            let low = number & ((1 << bits) - 1);
            let is_negative = signed && bits > 0 && low >> (bits - 1) & 1 == 1;
            int(base, if is_negative { low - (1 << bits) } else { low })
        }
        Unary::Order => int(base, unoclp_core::real::comparable(number as i32).into()),
    }
}

/// Of two operands of type `base`; a shift, a power and what takes a TIME have the type of the first.
pub fn binary(op: Binary, base: Base, a: &Value, b: &Value) -> Outcome {
    if base.is_text() {
        let first = (a.text() <= b.text()) == matches!(op, Binary::Min);
        return (if first { a.clone() } else { b.clone() }, false);
    }
    if base.is_real() {
        return of_reals(op, base, a.real(), b);
    }
    let (x, y) = (a.int(), b.int());
    if base == Base::AnyInt
        && let Some(outcome) = exactly(op, x, y)
    {
        return outcome;
    }
    match op {
        Binary::Add => int(base, x.wrapping_add(y)),
        Binary::Subtract => int(base, x.wrapping_sub(y)),
        Binary::Multiply => int(base, x.wrapping_mul(y)),
        Binary::Divide | Binary::Modulo if y == 0 => FAILED,
        Binary::Divide => int(base, x.wrapping_div(y)),
        Binary::Modulo => int(base, x.wrapping_rem(y)),
        Binary::And => int(base, x & y),
        Binary::Or => int(base, x | y),
        Binary::Xor => int(base, x ^ y),
        Binary::Min => int(base, x.min(y)),
        Binary::Max => int(base, x.max(y)),
        Binary::ShiftLeft | Binary::ShiftRight | Binary::RotateLeft | Binary::RotateRight => {
            (Value::Int(shifted(op, base, x, y)), false)
        }
        Binary::Power => power(base, x, y),
        Binary::DtPlusTime => int(Base::Dt, x + y / 1000),
        Binary::DtMinusTime => int(Base::Dt, x - y / 1000),
        Binary::TodPlusTime => (Value::Int((x + y).rem_euclid(86_400_000)), false),
        Binary::TodMinusTime => (Value::Int((x - y).rem_euclid(86_400_000)), false),
        Binary::DtMinusDt => as_time((x - y) * 1000),
        Binary::DateMinusDate => as_time((x - y) * 86_400_000),
    }
}

/// Numbers of a text, each of at most 64 bits, where what comes of them can exceed 128.
fn exactly(op: Binary, x: i128, y: i128) -> Option<Outcome> {
    let number = match op {
        Binary::Multiply => x.checked_mul(y),
        Binary::Power => u32::try_from(y).ok().and_then(|y| x.checked_pow(y)),
        _ => return None,
    };
    Some(number.map_or(FAILED, |number| (Value::Int(number), false)))
}

fn as_time(ms: i128) -> Outcome {
    match i32::try_from(ms) {
        Ok(ms) => (Value::Int(ms.into()), false),
        Err(_) => FAILED,
    }
}

fn of_reals(op: Binary, base: Base, x: f64, b: &Value) -> Outcome {
    let y = b.real();
    match op {
        Binary::Add => finite(base, x + y),
        Binary::Subtract => finite(base, x - y),
        Binary::Multiply => product(base, x, y),
        Binary::Divide => quotient(base, x, y),
        Binary::Modulo => finite(base, x % y),
        Binary::Min => finite(base, x.min(y)),
        Binary::Max => finite(base, x.max(y)),
        Binary::Power => real_power(base, x, b.int()),
        _ => (Value::Real(0.0), true),
    }
}

fn product(base: Base, x: f64, y: f64) -> Outcome {
    match base {
        Base::Real => as_on_the_board(real::multiply, x, y),
        _ => finite(base, x * y),
    }
}

fn quotient(base: Base, x: f64, y: f64) -> Outcome {
    match base {
        Base::Real => as_on_the_board(real::divide, x, y),
        _ => finite(base, x / y),
    }
}

/// Below the least normal number the board rounds in a way of its own.
fn as_on_the_board(operation: fn(i32, i32) -> (i32, bool), x: f64, y: f64) -> Outcome {
    let bits = |number: f64| (number as f32).to_bits().cast_signed();
    let (made, failed) = operation(bits(x), bits(y));
    let made = f32::from_bits(made.cast_unsigned());
    (Value::Real(made.into()), failed)
}

/// By squaring, each product rounded, as the board does it.
fn real_power(base: Base, x: f64, exponent: i128) -> Outcome {
    let (mut result, mut square, mut failed) = (1.0, x, false);
    let mut rest = exponent.unsigned_abs().min(1 << 31);
    while rest > 0 {
        if rest & 1 == 1 {
            let (product, over) = product(base, result, square);
            (result, failed) = (product.real(), failed | over);
        }
        rest >>= 1;
        if rest > 0 {
            let (product, over) = product(base, square, square);
            (square, failed) = (product.real(), failed | over);
        }
    }
    let (value, over) = match exponent < 0 {
        true => quotient(base, 1.0, result),
        false => finite(base, result),
    };
    (if failed { Value::Real(0.0) } else { value }, failed | over)
}

fn power(base: Base, x: i128, exponent: i128) -> Outcome {
    if exponent < 0 {
        return match x {
            0 => FAILED,
            1 => int(base, 1),
            -1 => int(base, if exponent % 2 == 0 { 1 } else { -1 }),
            _ => int(base, 0),
        };
    }
    let (mut result, mut square) = (1, x);
    let mut rest = exponent;
    while rest > 0 {
        if rest & 1 == 1 {
            result = wide(base, i128::wrapping_mul(result, square));
        }
        square = wide(base, square.wrapping_mul(square));
        rest >>= 1;
    }
    int(base, result)
}

/// In the bits of the type.
fn shifted(op: Binary, base: Base, x: i128, by: i128) -> i128 {
    let bits = i128::from(base.bits().clamp(1, 64));
    let mask = (1_i128 << bits) - 1;
    let x = x & mask;
    let within = (0..bits).contains(&by);
    let turn = by.rem_euclid(bits);
    let result = match op {
        Binary::ShiftLeft if within => x << by,
        Binary::ShiftRight if within => x >> by,
        Binary::RotateLeft => x << turn | x >> (bits - turn),
        Binary::RotateRight => x >> turn | x << (bits - turn),
        _ => 0,
    };
    narrowed(base, result & mask)
}

/// Whether it holds.
pub fn compare(op: Compare, a: &Value, b: &Value) -> bool {
    let order = match (a, b) {
        (Value::Int(a), Value::Int(b)) => a.cmp(b),
        (Value::Text(a), Value::Text(b)) => a.cmp(b),
        // No real is anything but finite.
        _ => a.real().partial_cmp(&b.real()).unwrap_or(Ordering::Equal),
    };
    match op {
        Compare::Equal => order.is_eq(),
        Compare::NotEqual => order.is_ne(),
        Compare::Less => order.is_lt(),
        Compare::LessEqual => order.is_le(),
        Compare::Greater => order.is_gt(),
        Compare::GreaterEqual => order.is_ge(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_wraps_in_its_width_and_stores_in_its_bits() {
        let sum = binary(Binary::Add, Base::Int, &Value::Int(32_767), &Value::Int(1)).0;
        assert_eq!(sum, Value::Int(32_768));
        assert_eq!(narrow(Base::Int, sum), Value::Int(-32_768));
        let least = Value::Int(i32::MIN.into());
        let quotient = binary(Binary::Divide, Base::Dint, &least, &Value::Int(-1));
        assert_eq!(quotient, (least, false));
        let below = binary(
            Binary::Subtract,
            Base::Udint,
            &Value::Int(0),
            &Value::Int(1),
        )
        .0;
        assert_eq!(below, Value::Int(u32::MAX.into()));
    }

    #[test]
    fn what_cannot_be_computed_is_0_and_sets_s_04() {
        let of = |op, base, a, b| binary(op, base, &a, &b);
        let zero = || Value::Int(0);
        assert_eq!(of(Binary::Divide, Base::Int, Value::Int(7), zero()), FAILED);
        assert_eq!(of(Binary::Modulo, Base::Int, Value::Int(7), zero()), FAILED);
        let none = (Value::Real(0.0), true);
        let (one, null) = (Value::Real(1.0), Value::Real(0.0));
        assert_eq!(of(Binary::Divide, Base::Real, one, null), none);
        let big = || Value::Real(f64::from(f32::MAX));
        assert_eq!(of(Binary::Add, Base::Real, big(), big()), none);
        assert!(!of(Binary::Add, Base::Lreal, big(), big()).1);
    }

    #[test]
    fn shifts_stay_in_the_bits_of_the_type() {
        let of = |op, x, by| shifted(op, Base::Byte, x, by);
        assert_eq!(of(Binary::ShiftLeft, 0x81, 1), 2);
        assert_eq!(of(Binary::ShiftRight, 0x81, 1), 0x40);
        assert_eq!(of(Binary::ShiftLeft, 0x81, 8), 0);
        assert_eq!(of(Binary::RotateLeft, 0x81, 1), 3);
        assert_eq!(of(Binary::RotateRight, 0x81, 9), 0xC0);
    }
}
