//! What each operation gives: for constants while a text is read, and for the interpreter while it runs.
//!
//! Each takes values of the types that the tree says and gives the result with whether S 04 is to be set. Owns
//! widths, wrapping and rounding. Must not know places and statements.

use super::base::{Base, Width};
use super::tree::{Binary, Compare, Convert, Unary};
use super::value::Value;
use std::cmp::Ordering;

/// A result, and whether it sets S 04.
pub type Outcome = (Value, bool);

/// Wrapped to the width in which the arithmetic of this type is done.
fn wide(base: Base, number: i128) -> i128 {
    match base.width() {
        Width::Bit => number & 1,
        Width::Signed => i128::from(number as i32),
        Width::Unsigned => i128::from(number as u32),
        Width::Signed64 if base == Base::AnyInt => number,
        Width::Signed64 => i128::from(number as i64),
        Width::Unsigned64 => i128::from(number as u64),
        Width::Single | Width::Double | Width::Text => number,
    }
}

/// Wrapped to the bits that a variable of this type keeps.
pub fn narrow(base: Base, value: Value) -> Value {
    match value {
        Value::Int(number) => Value::Int(narrowed(base, number)),
        other => other,
    }
}

fn narrowed(base: Base, number: i128) -> i128 {
    match base.bits() {
        _ if base == Base::AnyInt => number,
        1 => number & 1,
        8 if base.is_signed() => i128::from(number as i8),
        8 => i128::from(number as u8),
        16 if base.is_signed() => i128::from(number as i16),
        16 => i128::from(number as u16),
        _ => wide(base, number),
    }
}

/// A real as its type holds it; 0 and S 04 if it is not finite.
fn finite(base: Base, number: f64) -> Outcome {
    let number = match base {
        Base::Real => f64::from(number as f32),
        _ => number,
    };
    match number.is_finite() {
        true => (Value::Real(number), false),
        false => (Value::Real(0.0), true),
    }
}

fn int(base: Base, number: i128) -> Outcome {
    (Value::Int(wide(base, number)), false)
}

const FAILED: Outcome = (Value::Int(0), true);

/// Of one operand of type `base`.
pub fn unary(op: Unary, base: Base, value: &Value) -> Outcome {
    if base.is_real() {
        let number = value.real();
        return match op {
            Unary::Abs => finite(base, number.abs()),
            Unary::Sqrt if number < 0.0 => (Value::Real(0.0), true),
            Unary::Sqrt => finite(base, number.sqrt()),
            Unary::Negate | Unary::Not => finite(base, -number),
        };
    }
    let number = value.int();
    match op {
        Unary::Negate => int(base, -number),
        Unary::Not => int(base, !number),
        Unary::Abs => int(base, number.abs()),
        Unary::Sqrt if number < 0 => FAILED,
        Unary::Sqrt => int(base, number.unsigned_abs().isqrt() as i128),
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

/// Numbers of a text, which do not wrap.
fn exactly(op: Binary, x: i128, y: i128) -> Option<Outcome> {
    let number = match op {
        Binary::Add => x.checked_add(y),
        Binary::Subtract => x.checked_sub(y),
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
        Binary::Multiply => finite(base, x * y),
        Binary::Divide => finite(base, x / y),
        Binary::Modulo => finite(base, x % y),
        Binary::Min => finite(base, x.min(y)),
        Binary::Max => finite(base, x.max(y)),
        Binary::Power => real_power(base, x, b.int()),
        _ => (Value::Real(0.0), true),
    }
}

/// By squaring, each product rounded, as the board does it.
fn real_power(base: Base, x: f64, exponent: i128) -> Outcome {
    let (mut result, mut square, mut failed) = (1.0, x, false);
    let mut rest = exponent.unsigned_abs().min(1 << 31);
    while rest > 0 {
        if rest & 1 == 1 {
            let (product, over) = finite(base, result * square);
            (result, failed) = (product.real(), failed | over);
        }
        rest >>= 1;
        if rest > 0 {
            let (product, over) = finite(base, square * square);
            (square, failed) = (product.real(), failed | over);
        }
    }
    let (value, over) = match exponent < 0 {
        true => finite(base, 1.0 / result),
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

/// From one type to another.
pub fn convert(how: Convert, from: Base, to: Base, value: &Value) -> Outcome {
    match how {
        Convert::Keep => match value {
            Value::Int(number) => int(to, *number),
            other => (other.clone(), false),
        },
        Convert::Wrap => (narrow(to, value.clone()), false),
        Convert::Float => finite(to, value.real()),
        Convert::Single => finite(to, value.real()),
        Convert::Round => whole(to, value.real().round_ties_even()),
        Convert::Cut => whole(to, value.real().trunc()),
        Convert::Test => {
            let truth = match value {
                Value::Real(number) => *number != 0.0,
                other => other.is_true(),
            };
            (Value::truth(truth), false)
        }
        Convert::Bits => match value {
            Value::Real(number) => int(to, (*number as f32).to_bits().into()),
            other => finite(to, f32::from_bits(other.int() as u32).into()),
        },
        Convert::Day => (Value::Int(value.int() / 86_400), false),
        Convert::Clock => (Value::Int(value.int() % 86_400 * 1000), false),
        Convert::Midnight => int(to, value.int() * 86_400),
        Convert::Write => (Value::Text(written(from, value)), false),
        Convert::Parse => parsed(to, value.text()),
    }
}

fn whole(to: Base, number: f64) -> Outcome {
    let fits = to.range().is_some_and(|(low, high)| {
        // Each end as a double, which may be rounded up to one more than the greatest.
        number >= low as f64
            && number < high as f64 + 1.0
            && (low..=high).contains(&(number as i128))
    });
    match fits {
        true => (Value::Int(number as i128), false),
        false => FAILED,
    }
}

fn written(from: Base, value: &Value) -> String {
    let shown = value.shown(from);
    match value {
        Value::Text(text) => text.clone(),
        _ => shown,
    }
}

fn parsed(to: Base, text: &str) -> Outcome {
    let text = text.trim();
    let failed = (Value::zero(to), true);
    if to.is_real() {
        let number = text.parse().ok().filter(|number: &f64| number.is_finite());
        return number.map_or(failed, |number| finite(to, number));
    }
    if to == Base::Bool {
        return match text.to_ascii_uppercase().as_str() {
            "TRUE" | "1" => (Value::Int(1), false),
            "FALSE" | "0" => (Value::Int(0), false),
            _ => failed,
        };
    }
    let number = match text.strip_prefix("16#") {
        Some(digits) => i128::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    };
    let fits = |number: &i128| to.range().is_some_and(|(a, b)| (a..=b).contains(number));
    match number.filter(fits) {
        Some(number) => (Value::Int(number), false),
        None => failed,
    }
}

/// A number that a person gives for a value of this type; none if it does not fit.
pub fn given(value: Value, to: Base) -> Option<Value> {
    match value {
        Value::Int(number) if to.is_real() => Some(finite(to, number as f64))
            .filter(|out| !out.1)
            .map(|out| out.0),
        Value::Real(number) if to.is_real() => Some(finite(to, number))
            .filter(|out| !out.1)
            .map(|out| out.0),
        Value::Int(number) => {
            let fits = to
                .range()
                .is_some_and(|(low, high)| (low..=high).contains(&number));
            fits.then_some(Value::Int(number))
        }
        Value::Real(_) | Value::Text(_) => None,
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
    fn reals_round_halves_to_even() {
        for (number, rounded, cut) in [(2.5, 2, 2), (3.5, 4, 3), (-2.5, -2, -2), (-2.6, -3, -2)] {
            let of = |how| convert(how, Base::Real, Base::Int, &Value::Real(number));
            assert_eq!(of(Convert::Round), (Value::Int(rounded), false));
            assert_eq!(of(Convert::Cut), (Value::Int(cut), false));
        }
        for (number, to) in [
            (40_000.0, Base::Int),
            (-1.0, Base::Uint),
            (2147483648.0, Base::Dint),
        ] {
            assert_eq!(
                convert(Convert::Round, Base::Real, to, &Value::Real(number)),
                FAILED
            );
        }
        let odd = Value::Real(100_000.125);
        let bits = convert(Convert::Bits, Base::Real, Base::Dword, &odd).0;
        assert_eq!(
            convert(Convert::Bits, Base::Dword, Base::Real, &bits),
            (odd, false)
        );
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
