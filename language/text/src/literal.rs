//! Numbers and times as they are written.

use crate::decimal;
use crate::diagnostics::Code;

/// The number or time, in ms, that a literal says: `20`, `2#1010`, `16#FF`, `T#1h2m3s4ms`, `TIME#2.5s`.
pub fn value(text: &str) -> Option<i32> {
    let Some((prefix, rest)) = text.split_once('#') else {
        return whole(text, 10);
    };
    match prefix.to_ascii_uppercase().as_str() {
        // OMRON's: each digit is a decimal one.
        "" | "10" => whole(rest, 10),
        "2" => whole(rest, 2),
        "8" => whole(rest, 8),
        "16" => whole(rest, 16),
        "T" | "TIME" => short_time(rest),
        "REAL" => real(rest),
        // As a pattern of 32 bits.
        "UDINT" | "DWORD" if !rest.contains('#') => {
            u32::try_from(digits(rest, 10)?).ok().map(u32::cast_signed)
        }
        "SINT" | "INT" | "DINT" | "USINT" | "UINT" | "UDINT" | "BYTE" | "WORD" | "DWORD"
            if rest.matches('#').count() <= 1 =>
        {
            value(rest)
        }
        "BOOL" => match &*rest.to_ascii_uppercase() {
            "FALSE" => Some(0),
            "TRUE" => Some(1),
            _ => value(rest).filter(|number| (0..=1).contains(number)),
        },
        _ => None,
    }
}

/// The ms of a time that a person writes, with its `T#` or without: `4s`, `T#4s`, `1m30s`; none without a unit.
pub fn duration(text: &str) -> Option<i32> {
    match text.split_once('#') {
        None => short_time(text),
        Some(_) if text.to_ascii_lowercase().starts_with('t') => value(text),
        Some(_) => None,
    }
}

/// The bits of a REAL number, which has a fraction, an exponent, or neither: `0.5`, `1.5E3`, `2`.
pub fn real(text: &str) -> Option<i32> {
    let digits: String = text.chars().filter(|&c| c != '_').collect();
    let digit = |c: char| c.is_ascii_digit();
    let number = digits.strip_prefix('-').unwrap_or(&digits);
    let number = number
        .starts_with(digit)
        .then(|| decimal::real(&digits))??;
    Some(number.to_bits().cast_signed())
}

/// What is wrong with a literal that has no value, and how it may have been meant.
pub fn fault(text: &str) -> (Code, String) {
    let point = text.replace(',', ".");
    let behind = text.split_once('#').map(|(_, rest)| rest);
    let timed = text.get(..2).is_some_and(|t| t.eq_ignore_ascii_case("T#"))
        || text
            .get(..5)
            .is_some_and(|t| t.eq_ignore_ascii_case("TIME#"));
    let digits = |c: char| c.is_ascii_digit() || matches!(c, '.' | ',' | '_');
    match behind {
        None if short_time(&point).is_some() => (Code::TimePrefix, format!("T#{point}")),
        Some(_) if timed && text.contains(',') => (Code::DecimalComma, point),
        Some(rest) if timed && !rest.is_empty() && rest.chars().all(digits) => {
            (Code::TimeUnit, text.to_owned())
        }
        rest if is_fraction(rest.unwrap_or(text)) => (Code::Fraction, text.to_owned()),
        _ => (Code::BadNumber, text.to_owned()),
    }
}

/// Whether this is a number with a fraction or an exponent: `2.5`, `2,5`, `1E3`.
pub fn is_fraction(text: &str) -> bool {
    let number = text.strip_prefix('-').unwrap_or(text).replace(',', ".");
    let begins = number.starts_with(|c: char| c.is_ascii_digit());
    begins && number.contains(['.', 'e', 'E']) && decimal::is_decimal(&number)
}

/// Whether this is a REAL as Structured Text writes one, without a sign: `2.5`, `1.5E3`.
pub fn is_decimal(text: &str) -> bool {
    !text.contains(',') && is_fraction(text)
}

fn whole(digits: &str, radix: u32) -> Option<i32> {
    let number = self::digits(digits, radix)?;
    match radix {
        // A pattern of 32 bits.
        2 | 8 | 16 => u32::try_from(number).ok().map(u32::cast_signed),
        // One more than the largest, because a minus may be before it.
        _ => (number <= 1 << 31).then_some(number as i32),
    }
}

fn digits(digits: &str, radix: u32) -> Option<i64> {
    let digits: String = digits.chars().filter(|&c| c != '_').collect();
    i64::from_str_radix(&digits, radix).ok()
}

/// The ms of a time that fit 32 bits.
fn short_time(text: &str) -> Option<i32> {
    i32::try_from(time(text)?).ok()
}

/// Parts from days to ms, each with its unit; only the last may have a fraction.
pub fn time(text: &str) -> Option<i128> {
    let text = text.to_ascii_lowercase().replace('_', "");
    let mut rest = text.as_str();
    let (mut sum, mut last, mut ended) = (0_i128, i128::MAX, rest.is_empty());
    while !rest.is_empty() {
        if ended {
            return None;
        }
        let digits = rest.find(|c: char| !c.is_ascii_digit() && c != '.')?;
        let (number, behind) = rest.split_at(digits);
        let letters = behind
            .find(|c: char| !c.is_ascii_alphabetic())
            .unwrap_or(behind.len());
        let (unit, behind) = behind.split_at(letters);
        let size = match unit {
            "d" => 86_400_000,
            "h" => 3_600_000,
            "m" => 60_000,
            "s" => 1000,
            "ms" => 1,
            _ => return None,
        };
        if size >= last {
            return None;
        }
        last = size;
        sum += match number.split_once('.') {
            None => number.parse::<u64>().ok().map(i128::from)? * size,
            Some((whole, fraction)) => {
                ended = true;
                let whole: i128 = whole.parse::<u32>().ok()?.into();
                let scale = 10_i128
                    .checked_pow(u32::try_from(fraction.len()).ok().filter(|n| *n <= 18)?)?;
                let fraction: i128 = fraction.parse::<u64>().ok()?.into();
                whole * size + (fraction * size + scale / 2) / scale
            }
        };
        rest = behind;
    }
    (!ended || last != i128::MAX).then_some(sum)
}

#[cfg(test)]
mod tests {
    use super::{fault, value};
    use crate::diagnostics::Code;

    #[test]
    fn literals() {
        let cases = [
            ("20", Some(20)),
            ("1_000", Some(1000)),
            ("2#1010", Some(10)),
            ("16#FF", Some(255)),
            ("16#FFFF_FFFF", Some(-1)),
            ("T#20s", Some(20_000)),
            ("t#1h2m3s4ms", Some(3_723_004)),
            ("TIME#2.5s", Some(2500)),
            ("T#1s2h", None),
            ("T#s", None),
            ("T#", None),
            ("T#25d", None),
            ("T#1.5h2m", None),
            ("T#1.5006s", Some(1501)),
            ("99999999999", None),
            ("2#3", None),
            ("7#3", None),
            ("UINT#16#F", Some(15)),
            ("DWORD#2#1010", Some(10)),
            ("INT#INT#16#F", None),
            ("UDINT#4_294_967_295", Some(-1)),
            ("UDINT#4294967296", None),
            ("bool#true", Some(1)),
            ("BOOL#FALSE", Some(0)),
            ("BOOL#2", None),
            ("DINT#4294967295", None),
            ("REAL#0.5", Some(0x3F00_0000)),
            ("REAL#-1.5E3", Some(0xC4BB_8000_u32.cast_signed())),
            ("REAL#1E39", None),
            ("REAL#inf", None),
        ];
        for (text, expected) in cases {
            assert_eq!(value(text), expected, "{text}");
        }
    }

    #[test]
    fn each_slip_has_its_own_words() {
        for (text, code, meant) in [
            ("5s", Code::TimePrefix, "T#5s"),
            ("1,5s", Code::TimePrefix, "T#1.5s"),
            ("T#5", Code::TimeUnit, "T#5"),
            ("T#1,5s", Code::DecimalComma, "T#1.5s"),
            ("2.5", Code::Fraction, "2.5"),
            ("1E3", Code::Fraction, "1E3"),
            ("2#123", Code::BadNumber, "2#123"),
            ("T#s", Code::BadNumber, "T#s"),
        ] {
            assert_eq!(fault(text), (code, meant.to_owned()), "{text}");
        }
    }
}
