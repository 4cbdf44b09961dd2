//! What a type holds: wrapping and rounding.
//!
//! Owns the width of arithmetic, and the bits that a variable keeps. Must not know operations.

use super::base::{Base, Width};
use super::value::Value;

/// A result, and whether it sets S 04.
pub type Outcome = (Value, bool);

/// Wrapped to the width in which the arithmetic of this type is done.
pub(super) fn wide(base: Base, number: i128) -> i128 {
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

pub(super) fn narrowed(base: Base, number: i128) -> i128 {
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
pub(super) fn finite(base: Base, number: f64) -> Outcome {
    let number = match base {
        Base::Real => f64::from(number as f32),
        _ => number,
    };
    match number.is_finite() {
        true => (Value::Real(number), false),
        false => (Value::Real(0.0), true),
    }
}

pub(super) fn int(base: Base, number: i128) -> Outcome {
    (Value::Int(wide(base, number)), false)
}

pub(super) const FAILED: Outcome = (Value::Int(0), true);

/// A number that a person gives for a value of this type; none if it does not fit.
pub(super) fn given(value: Value, to: Base) -> Option<Value> {
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
