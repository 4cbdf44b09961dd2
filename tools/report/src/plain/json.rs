//! A value as it is told: `{"v":21.5,"t":1764266400000,"q":"good","n":17}`.

use crate::alarm::Alarm;
use crate::boards::{Sample, Shape, shape};
use crate::command::Refusal;
use serde_json::{Number, Value, json};
use unoclp_site::Point;

/// A value of this point: `v`, `null` where it is not known; since when, ms since 1970; whether it is known; and the number
/// of the sample, which grows with each.
pub(super) fn sample(point: &Point, sample: Sample) -> String {
    let Sample { value, at, number } = sample;
    let quality = if value.is_some() { "good" } else { "bad" };
    let value = value.map_or(Value::Null, |value| told(shape(point), value));
    format!(r#"{{"v":{value},"t":{at},"q":"{quality}","n":{number}}}"#)
}

/// Which command is refused, and why.
pub(super) fn refused(point: &str, refusal: Refusal) -> String {
    json!({ "point": point, "why": refusal.word() }).to_string()
}

/// Which alarm is not acknowledged, and why.
pub(super) fn alarm_refused(alarm: &str, refusal: Refusal) -> String {
    json!({ "alarm": alarm, "why": refusal.word() }).to_string()
}

/// How an alarm stands.
pub(super) fn alarm(alarm: &Alarm) -> String {
    let Alarm {
        state,
        severity,
        text,
        since,
        who,
        ..
    } = alarm;
    let text = json!({ "en": text.en, "pt": text.pt });
    json!({ "state": state, "severity": severity, "t": since, "who": who, "text": text })
        .to_string()
}

fn told(shape: Shape, value: f64) -> Value {
    match shape {
        Shape::Bit => Value::Bool(value != 0.0),
        // Whole numbers of 32 bits.
        Shape::Unsigned | Shape::Signed => Value::Number((value as i64).into()),
        // As many digits as tell it from its neighbours of 32 bits, not of 64.
        Shape::Real => {
            let text = (value as f32).to_string();
            let number = text.parse().ok().and_then(Number::from_f64);
            number.map_or(Value::Null, Value::Number)
        }
    }
}
