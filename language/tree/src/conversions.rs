//! What each conversion gives, for constants and while a program runs.
//!
//! Must not know which conversions a language makes by itself.

use super::base::Base;
use super::expression::Convert;
use super::literal;
use super::value::Value;
use super::width::{FAILED, Outcome, finite, given, int, narrow};

/// From one type to another.
pub fn convert(how: Convert, from: Base, to: Base, value: &Value) -> Outcome {
    match how {
        Convert::Keep => match value {
            Value::Int(number) => int(to, *number),
            other => (other.clone(), false),
        },
        Convert::Wrap => (narrow(to, value.clone()), false),
        Convert::Fit => given(value.clone(), to).map_or(FAILED, |value| (value, false)),
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
        Convert::Bits | Convert::Raw => match value {
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

/// What a text spells, as a literal of the type would be written.
fn parsed(to: Base, text: &str) -> Outcome {
    match literal::spelled(text.trim(), to) {
        Some(value) => (value, false),
        None => (Value::zero(to), true),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
