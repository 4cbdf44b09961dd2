//! Values of the elementary types, and how they are written.

use super::base::Base;
use std::fmt::Write;

/// A value of an elementary type; its type stands beside it.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// BOOL as 0 and 1; integers and bit strings; TIME and TOD in ms, DATE in days, DT in seconds.
    Int(i128),
    /// REAL, rounded to a single, and LREAL.
    Real(f64),
    /// STRING and WSTRING.
    Text(String),
}

impl Value {
    /// What a variable of this type holds if nobody says what.
    pub fn zero(base: Base) -> Value {
        match base {
            _ if base.is_real() => Value::Real(0.0),
            _ if base.is_text() => Value::Text(String::new()),
            _ => Value::Int(0),
        }
    }

    /// TRUE or FALSE.
    pub fn truth(is: bool) -> Value {
        Value::Int(is.into())
    }

    /// The whole number; 0 where it is none.
    pub fn int(&self) -> i128 {
        match self {
            Value::Int(number) => *number,
            _ => 0,
        }
    }

    /// As a real.
    pub fn real(&self) -> f64 {
        match self {
            Value::Int(number) => *number as f64,
            Value::Real(number) => *number,
            Value::Text(_) => 0.0,
        }
    }

    /// The text; empty where it is none.
    pub fn text(&self) -> &str {
        match self {
            Value::Text(text) => text,
            _ => "",
        }
    }

    /// Of a text its first characters.
    pub fn cut(self, most: u32) -> Value {
        match self {
            Value::Text(text) => Value::Text(text.chars().take(most as usize).collect()),
            other => other,
        }
    }

    /// Whether it is not 0.
    pub fn is_true(&self) -> bool {
        self.int() != 0
    }

    /// As a literal of its type, as a person writes it: `TRUE`, `16#FF`, `1.5`, `T#1s500ms`.
    pub fn shown(&self, base: Base) -> String {
        match (self, base) {
            (Value::Int(number), Base::Bool) => match number {
                0 => "FALSE".to_owned(),
                _ => "TRUE".to_owned(),
            },
            (Value::Int(number), _) if base.is_bits() => format!("16#{number:X}"),
            (Value::Int(ms), Base::Time) => time(*ms),
            (Value::Int(ms), Base::Tod) => format!("TOD#{}", clock(*ms)),
            (Value::Int(days), Base::Date) => format!("D#{}", date(*days)),
            (Value::Int(seconds), Base::Dt) => {
                let (days, rest) = (seconds.div_euclid(86_400), seconds.rem_euclid(86_400));
                format!("DT#{}-{}", date(days), clock(rest * 1000))
            }
            (Value::Int(number), _) => number.to_string(),
            (Value::Real(number), _) => real(*number, base),
            (Value::Text(text), Base::Wstr) => format!("\"{text}\""),
            (Value::Text(text), _) => format!("'{text}'"),
        }
    }
}

/// The shortest decimal that is read as the same number, always with a point.
pub fn real(number: f64, base: Base) -> String {
    let size = number.abs();
    let plain = number == 0.0 || (1e-5..1e15).contains(&size);
    match (base, plain) {
        (Base::Real, true) => format!("{:?}", number as f32),
        (Base::Real, false) => format!("{:E}", number as f32),
        (_, true) => format!("{number:?}"),
        (_, false) => format!("{number:E}"),
    }
}

fn time(ms: i128) -> String {
    let mut text = String::from(if ms < 0 { "T#-" } else { "T#" });
    let mut rest = ms.unsigned_abs();
    let begin = text.len();
    for (unit, size) in [
        ("d", 86_400_000),
        ("h", 3_600_000),
        ("m", 60_000),
        ("s", 1000),
        ("ms", 1),
    ] {
        if rest >= size {
            let _ = write!(text, "{}{unit}", rest / size);
            rest %= size;
        }
    }
    if text.len() == begin {
        text.push_str("0ms");
    }
    text
}

fn clock(ms: i128) -> String {
    let (seconds, rest) = (ms / 1000, ms % 1000);
    let text = format!(
        "{:02}:{:02}:{:02}",
        seconds / 3600,
        seconds / 60 % 60,
        seconds % 60
    );
    match rest {
        0 => text,
        _ => format!("{text}.{rest:03}"),
    }
}

/// The day of a calendar that so many days since 1970-01-01 are.
fn date(days: i128) -> String {
    // Counted in eras of 400 years that begin in March (Hinnant, "chrono-Compatible Low-Level Date Algorithms").
    let shifted = days + 719_468;
    let era = shifted.div_euclid(146_097);
    let day = shifted.rem_euclid(146_097);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let of_year = day - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let of_month = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = year + era * 400 + i128::from(month <= 2);
    format!("{year:04}-{month:02}-{of_month:02}")
}

/// The days since 1970-01-01; none where the calendar has no such day.
pub fn days(year: i128, month: i128, day: i128) -> Option<i128> {
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let longest = match month {
        4 | 6 | 9 | 11 => 30,
        2 if leap => 29,
        2 => 28,
        1..=12 => 31,
        _ => return None,
    };
    if !(1..=longest).contains(&day) {
        return None;
    }
    let year = year - i128::from(month <= 2);
    let era = year.div_euclid(400);
    let of_era = year.rem_euclid(400);
    let shifted = if month > 2 { month - 3 } else { month + 9 };
    let of_year = (153 * shifted + 2) / 5 + day - 1;
    let days = of_era * 365 + of_era / 4 - of_era / 100 + of_year;
    Some(era * 146_097 + days - 719_468)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_day_is_the_same_there_and_back() {
        for (day, text) in [
            (0, "1970-01-01"),
            (59, "1970-03-01"),
            (-25_509, "1900-02-28"),
            (11_016, "2000-02-29"),
            (47_541, "2100-03-01"),
            (49_710, "2106-02-07"),
        ] {
            assert_eq!(date(day), text);
            let parts: Vec<i128> = text.split('-').map(|part| part.parse().unwrap()).collect();
            assert_eq!(days(parts[0], parts[1], parts[2]), Some(day));
        }
        for year in [1900, 2023, 2100] {
            assert_eq!(days(year, 2, 29), None);
        }
    }

    #[test]
    fn values_are_shown_as_literals() {
        for (value, base, text) in [
            (Value::Int(1), Base::Bool, "TRUE"),
            (Value::Int(255), Base::Byte, "16#FF"),
            (Value::Int(90_500), Base::Time, "T#1m30s500ms"),
            (Value::Int(-5), Base::Time, "T#-5ms"),
            (Value::Int(0), Base::Time, "T#0ms"),
            (Value::Int(3_661_001), Base::Tod, "TOD#01:01:01.001"),
            (Value::Int(86_399), Base::Dt, "DT#1970-01-01-23:59:59"),
            (Value::Real(f64::from(0.1_f32)), Base::Real, "0.1"),
            (Value::Real(1e20), Base::Lreal, "1E20"),
            (Value::Real(2.0), Base::Real, "2.0"),
        ] {
            assert_eq!(value.shown(base), text);
        }
    }
}
