//! Times as a person writes them: `100ms`, `5s`, `2m`, `1h`, `400d`.

use std::time::Duration;

/// The time of this text; none of what is no time, or too long for one.
pub fn duration(text: &str) -> Option<Duration> {
    let letters = text.find(|ch: char| !ch.is_ascii_digit())?;
    let (number, unit) = text.split_at(letters);
    let number: u64 = number.parse().ok()?;
    let ms = match unit {
        "ms" => 1,
        "s" => 1_000,
        "m" => 60_000,
        "h" => 3_600_000,
        "d" => 86_400_000,
        _ => return None,
    };
    number.checked_mul(ms).map(Duration::from_millis)
}

/// A time as it is written, in the largest unit that is whole.
pub(crate) fn written(time: Duration) -> String {
    let ms = time.as_millis();
    let units = [
        ("d", 86_400_000),
        ("h", 3_600_000),
        ("m", 60_000),
        ("s", 1_000),
    ];
    let whole = units
        .iter()
        .find(|(_, of)| ms > 0 && ms.is_multiple_of(*of));
    match whole {
        Some((unit, of)) => format!("{}{unit}", ms / of),
        None => format!("{ms}ms"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_a_number_and_its_unit() {
        for (text, ms) in [
            ("100ms", Some(100)),
            ("5s", Some(5_000)),
            ("2m", Some(120_000)),
            ("1h", Some(3_600_000)),
            ("400d", Some(34_560_000_000)),
            ("5", None),
            ("s", None),
            ("", None),
            ("-5s", None),
            ("1.5s", None),
            ("5 s", None),
            ("5S", None),
            ("99999999999999999999s", None),
            ("18446744073709551615d", None),
        ] {
            assert_eq!(duration(text), ms.map(Duration::from_millis), "{text}");
        }
        for text in ["100ms", "5s", "2m", "1h", "400d", "1500ms", "90s"] {
            assert_eq!(duration(text).map(written).as_deref(), Some(text));
        }
    }
}
