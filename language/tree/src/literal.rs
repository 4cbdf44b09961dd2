//! The values of literals, in every form of the standard (2.2).

use super::base::Base;
use super::value::{Value, days};
use super::width::given;
use unoclp_text::diagnostics::Word;
use unoclp_text::literal::time;

/// What is wrong with a literal: what it was to be, in both languages, and how one is written.
pub struct Fault {
    /// What it was to be.
    pub what: Word,
    /// One that is right.
    pub like: Word,
}

type Read = Result<(Base, Value), Fault>;

fn fault(en: &str, pt: &str, like: &str) -> Fault {
    Fault {
        what: Word::Both(en.to_owned(), pt.to_owned()),
        like: like.into(),
    }
}

fn number_fault() -> Fault {
    fault("number", "número", "20, -5, 1.5, 2#1010 or 16#FF")
        .like_both("20, -5, 1.5, 2#1010 ou 16#FF")
}

impl Fault {
    fn like_both(mut self, pt: &str) -> Fault {
        if let Word::Text(en) = &self.like {
            self.like = Word::Both(en.clone(), pt.to_owned());
        }
        self
    }
}

/// `20`, `1_000`, `16#FF`, `1.5E3`.
pub fn number(text: &str) -> Read {
    let digits: String = text.chars().filter(|c| *c != '_').collect();
    if let Some((radix, digits)) = digits.split_once('#') {
        let radix = match radix {
            "2" => 2,
            "8" => 8,
            "16" => 16,
            "10" => 10,
            _ => return Err(number_fault()),
        };
        let value = u64::from_str_radix(digits, radix).map_err(|_| number_fault())?;
        return Ok((Base::AnyInt, Value::Int(value.into())));
    }
    if digits.contains(['.', 'e', 'E']) {
        let value: f64 = digits.parse().map_err(|_| number_fault())?;
        return match value.is_finite() {
            true => Ok((Base::AnyReal, Value::Real(value))),
            false => Err(number_fault()),
        };
    }
    if let Some(unit) = digits.find(|c: char| c.is_ascii_alphabetic()) {
        let is_time = unit > 0 && time(&digits).is_some();
        return Err(match is_time {
            true => Fault {
                what: ("number", "número").into(),
                like: format!("T#{digits}").into(),
            },
            false => number_fault(),
        });
    }
    let value: u64 = digits.parse().map_err(|_| number_fault())?;
    Ok((Base::AnyInt, Value::Int(value.into())))
}

/// `T#20s`, `INT#-5`, `WORD#16#FF`, `BOOL#TRUE`, `D#2026-11-23`; none where the word before `#` names no
/// elementary type.
pub fn typed(text: &str) -> Option<Read> {
    let (prefix, rest) = text.split_once('#')?;
    let base = match prefix.to_ascii_uppercase().as_str() {
        "T" | "TIME" => Base::Time,
        "D" | "DATE" => Base::Date,
        upper => Base::named(upper)?,
    };
    // `T# 5s`, as some write it.
    Some(of_type(base, rest.trim_start()))
}

/// The value of this type that a text without quotes spells: `-5`, `2#1010`, `T#20s`, `TRUE`; none if it is none.
pub fn spelled(text: &str, base: Base) -> Option<Value> {
    if base == Base::Bool {
        return match text.to_ascii_uppercase().as_str() {
            "TRUE" | "1" | "BOOL#TRUE" | "BOOL#1" => Some(Value::truth(true)),
            "FALSE" | "0" | "BOOL#FALSE" | "BOOL#0" => Some(Value::truth(false)),
            _ => None,
        };
    }
    if let Some(read) = typed(text) {
        let (from, value) = read.ok()?;
        let fits = from == base
            || base.is_real() && from.is_num()
            || base.is_int() && from.is_int()
            || base.is_bits() && from.is_bits();
        return given(value, base).filter(|_| fits);
    }
    let (sign, size) = match text.strip_prefix('-') {
        Some(size) => (-1, size),
        None => (1, text),
    };
    let value = match number(size).ok()?.1 {
        Value::Int(number) => Value::Int(number * i128::from(sign)),
        Value::Real(number) => Value::Real(number * f64::from(sign)),
        other => other,
    };
    given(value, base)
}

fn of_type(base: Base, rest: &str) -> Read {
    let int = |value: Option<i128>, fault: Fault| match value {
        Some(value) if in_range(base, value) => Ok((base, Value::Int(value))),
        _ => Err(fault),
    };
    match base {
        Base::Time => int(
            signed_time(rest),
            fault("time", "tempo", "T#20s, T#1h30m or T#1.5s")
                .like_both("T#20s, T#1h30m ou T#1.5s"),
        ),
        Base::Date => int(date(rest), fault("date", "data", "D#2026-11-23")),
        Base::Tod => int(
            clock(rest),
            fault("time of day", "hora do dia", "TOD#14:30:00"),
        ),
        Base::Dt => int(
            date_and_time(rest),
            fault("date and time", "data com hora", "DT#2026-11-23-14:30:00"),
        ),
        Base::Bool => match rest.to_ascii_uppercase().as_str() {
            "TRUE" | "1" => Ok((base, Value::Int(1))),
            "FALSE" | "0" => Ok((base, Value::Int(0))),
            _ => Err(fault("BOOL", "BOOL", "BOOL#TRUE")),
        },
        Base::Str | Base::Wstr => {
            let inner = rest
                .get(1..rest.len().saturating_sub(1))
                .unwrap_or_default();
            let quoted = rest.len() >= 2 && rest.starts_with(['\'', '"']);
            match characters(inner).filter(|_| quoted) {
                Some(text) => Ok((base, Value::Text(text))),
                None => Err(fault("string", "string", "STRING#'OK'")),
            }
        }
        _ => {
            let (sign, digits) = match rest.strip_prefix('-') {
                Some(digits) => (-1, digits),
                None => (1, rest.strip_prefix('+').unwrap_or(rest)),
            };
            let range = match base.range() {
                Some((low, high)) => {
                    format!("{base}#{high}").replace("#-", "#") + &format!(" ({low}..{high})")
                }
                None => format!("{base}#1.5"),
            };
            let wrong = || fault(base.name(), base.name(), &range);
            match number(digits).map_err(|_| wrong())? {
                (Base::AnyInt, Value::Int(value)) if !base.is_real() => {
                    int(Some(sign * value), wrong())
                }
                (_, value) if base.is_real() => {
                    let value = value.real() * sign as f64;
                    let value = if base == Base::Real {
                        f64::from(value as f32)
                    } else {
                        value
                    };
                    match value.is_finite() {
                        true => Ok((base, Value::Real(value))),
                        false => Err(wrong()),
                    }
                }
                _ => Err(wrong()),
            }
        }
    }
}

fn in_range(base: Base, value: i128) -> bool {
    base.range()
        .is_some_and(|(low, high)| (low..=high).contains(&value))
}

fn signed_time(text: &str) -> Option<i128> {
    match text.strip_prefix('-') {
        Some(size) => time(size).map(|ms| -ms),
        None => time(text.strip_prefix('+').unwrap_or(text)),
    }
}

fn date(text: &str) -> Option<i128> {
    let mut parts = text.split('-');
    let mut next = || parts.next()?.parse::<u32>().ok().map(i128::from);
    let (year, month, day) = (next()?, next()?, next()?);
    let days = days(year, month, day)?;
    (parts.next().is_none() && days >= 0).then_some(days)
}

/// In ms.
fn clock(text: &str) -> Option<i128> {
    let mut parts = text.split(':');
    let hours: u32 = parts.next()?.parse().ok()?;
    let minutes: u32 = parts.next()?.parse().ok()?;
    let seconds = parts.next().unwrap_or("0");
    let (whole, fraction) = seconds.split_once('.').unwrap_or((seconds, "0"));
    let whole: u32 = whole.parse().ok()?;
    let ms: u32 = format!("{fraction:0<3}").get(..3)?.parse().ok()?;
    let fits = hours < 24 && minutes < 60 && whole < 60 && parts.next().is_none();
    let seconds = (u64::from(hours) * 60 + u64::from(minutes)) * 60 + u64::from(whole);
    fits.then(|| i128::from(seconds * 1000 + u64::from(ms)))
}

/// In seconds; a fraction is cut.
fn date_and_time(text: &str) -> Option<i128> {
    let (day, clock_text) = text.rsplit_once('-')?;
    Some(date(day)? * 86_400 + clock(clock_text)? / 1000)
}

/// The characters of a text between its quotes, with what `$` stands for.
pub fn characters(inner: &str) -> Option<String> {
    let mut text = String::with_capacity(inner.len());
    let mut rest = inner.chars();
    while let Some(c) = rest.next() {
        if c != '$' {
            text.push(c);
            continue;
        }
        match rest.next()? {
            c @ ('$' | '\'' | '"') => text.push(c),
            'L' | 'l' | 'N' | 'n' => text.push('\n'),
            'P' | 'p' => text.push('\u{C}'),
            'R' | 'r' => text.push('\r'),
            'T' | 't' => text.push('\t'),
            high => {
                let low = rest.next()?;
                let number = high.to_digit(16)? * 16 + low.to_digit(16)?;
                text.push(char::from_u32(number)?);
            }
        }
    }
    Some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Option<(Base, Value)> {
        typed(text).unwrap_or_else(|| number(text)).ok()
    }

    #[test]
    fn every_form_of_literal() {
        for (text, base, value) in [
            ("1_000", Base::AnyInt, Value::Int(1000)),
            ("16#fF", Base::AnyInt, Value::Int(255)),
            ("2#1111_0000", Base::AnyInt, Value::Int(240)),
            ("8#17", Base::AnyInt, Value::Int(15)),
            ("1.34E-12", Base::AnyReal, Value::Real(1.34e-12)),
            ("INT#-5", Base::Int, Value::Int(-5)),
            ("WORD#16#AFF", Base::Word, Value::Int(0xAFF)),
            ("BOOL#1", Base::Bool, Value::Int(1)),
            ("REAL#1", Base::Real, Value::Real(1.0)),
            ("T#14.7s", Base::Time, Value::Int(14_700)),
            ("t#5d14h12m18s3.5ms", Base::Time, Value::Int(483_138_004)),
            ("TIME#-14ms", Base::Time, Value::Int(-14)),
            ("T#25h_15m", Base::Time, Value::Int(90_900_000)),
            ("D#1984-06-25", Base::Date, Value::Int(5289)),
            ("TOD#15:36:55.36", Base::Tod, Value::Int(56_215_360)),
            ("DT#1970-01-02-00:00:01", Base::Dt, Value::Int(86_401)),
            ("STRING#'a$'b'", Base::Str, Value::Text("a'b".into())),
        ] {
            assert_eq!(of(text), Some((base, value)), "{text}");
        }
        for wrong in [
            "5s",
            "2#12",
            "16#",
            "T#5",
            "T#",
            "T#1s2h",
            "T#1.5m3s",
            "T#30d",
            "D#2023-02-29",
            "TOD#24:00:00",
            "SINT#200",
            "INT#1.5",
            "BOOL#2",
            "1e999",
            "16#1FFFFFFFFFFFFFFFF",
            "3#1",
        ] {
            assert_eq!(of(wrong), None, "{wrong}");
        }
    }
}
