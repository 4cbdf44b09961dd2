//! The functions that run on a PC alone: of reals, and of texts.

use crate::ops::Outcome;
use crate::{Base, Extra, Value};

pub(super) fn extra(function: Extra, base: Base, values: &[Value]) -> Outcome {
    let value = |at: usize| values.get(at).cloned().unwrap_or(Value::Int(0));
    let x = value(0).real();
    let number = match function {
        Extra::Sin => x.sin(),
        Extra::Cos => x.cos(),
        Extra::Tan => x.tan(),
        Extra::Asin => x.asin(),
        Extra::Acos => x.acos(),
        Extra::Atan => x.atan(),
        Extra::Ln => x.ln(),
        Extra::Log => x.log10(),
        Extra::Exp => x.exp(),
        Extra::Power => x.powf(value(1).real()),
        _ => return of_texts(function, values),
    };
    let number = if base == Base::Real {
        f64::from(number as f32)
    } else {
        number
    };
    match number.is_finite() {
        true => (Value::Real(number), false),
        false => (Value::Real(0.0), true),
    }
}

/// Positions count from 1; what lies outside of a text is left out, and sets S 04.
fn of_texts(function: Extra, values: &[Value]) -> Outcome {
    let text = |at: usize| -> Vec<char> {
        values
            .get(at)
            .map_or_else(Vec::new, |value| value.text().chars().collect())
    };
    let number = |at: usize| values.get(at).map_or(0, Value::int);
    let first = text(0);
    let length = first.len();
    // As many characters, and a position, as there are.
    let count = |at: usize| usize::try_from(number(at)).unwrap_or(0).min(length);
    let place = |at: usize| usize::try_from(number(at) - 1).unwrap_or(0).min(length);
    let outside = |at: usize| number(at) < 1 || number(at) > length as i128 + 1;
    let made = |chars: Vec<char>| Value::Text(chars.into_iter().take(4096).collect());
    match function {
        Extra::Len => (Value::Int(length as i128), false),
        Extra::Left => (made(first[..count(1)].to_vec()), number(1) < 0),
        Extra::Right => (made(first[length - count(1)..].to_vec()), number(1) < 0),
        Extra::Mid => {
            let from = place(2);
            let chars = first[from..].iter().take(count(1)).copied().collect();
            (made(chars), outside(2))
        }
        Extra::Insert => {
            let at = count(2);
            let joined = [&first[..at], &text(1), &first[at..]].concat();
            (made(joined), number(2) < 0 || number(2) > length as i128)
        }
        Extra::Delete => {
            let from = place(2);
            let to = (from + count(1)).min(length);
            (made([&first[..from], &first[to..]].concat()), outside(2))
        }
        Extra::Replace => {
            let from = place(3);
            let to = (from + count(2)).min(length);
            (
                made([&first[..from], &text(1), &first[to..]].concat()),
                outside(3),
            )
        }
        Extra::Find => {
            let second = text(1);
            let found = (!second.is_empty())
                .then(|| {
                    first
                        .windows(second.len())
                        .position(|part| *part == second[..])
                })
                .flatten();
            (Value::Int(found.map_or(0, |at| at as i128 + 1)), false)
        }
        _ => {
            let all = (0..values.len()).flat_map(text).collect();
            (made(all), false)
        }
    }
}
