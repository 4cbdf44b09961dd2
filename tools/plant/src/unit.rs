//! Physical quantities as a person writes them: a number and its unit, `1.5 l/s`.
//!
//! Owns the units, and the whole number that each comes to. Must not know what is measured.

/// What a whole number counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Things.
    Count,
    /// Thousandths of the whole, written in per cent.
    Permille,
    /// Milliseconds.
    Ms,
    /// Millimetres.
    Mm,
    /// Millimetres in a second.
    MmPerS,
    /// Millilitres.
    Ml,
    /// Millilitres in a second.
    MlPerS,
    /// Thousandths of a degree Celsius.
    MilliC,
    /// Milliamperes.
    Ma,
    /// Turns in a minute.
    Rpm,
}

/// A way to write a unit, and what one of it comes to: so many, divided by so many.
type Spelling = (&'static str, i64, i64);

impl Unit {
    /// How it may be written, the usual way first.
    pub const fn spellings(self) -> &'static [Spelling] {
        match self {
            Unit::Count => &[],
            Unit::Permille => &[("%", 10, 1)],
            Unit::Ms => &[
                ("s", 1000, 1),
                ("ms", 1, 1),
                ("min", 60_000, 1),
                ("h", 3_600_000, 1),
            ],
            Unit::Mm => &[("mm", 1, 1), ("cm", 10, 1), ("m", 1000, 1)],
            Unit::MmPerS => &[("mm/s", 1, 1), ("cm/s", 10, 1), ("m/s", 1000, 1)],
            Unit::Ml => &[("l", 1000, 1), ("ml", 1, 1)],
            Unit::MlPerS => &[("l/s", 1000, 1), ("ml/s", 1, 1), ("l/min", 1000, 60)],
            Unit::MilliC => &[("°C", 1000, 1)],
            Unit::Ma => &[("A", 1000, 1), ("mA", 1, 1)],
            Unit::Rpm => &[("rpm", 1, 1)],
        }
    }

    /// The number that a text gives; none where it gives none, or with another unit.
    pub fn read(self, text: &str) -> Option<i64> {
        let text = text.trim();
        let is_number = |sign: char| sign.is_ascii_digit() || sign == '.' || sign == '-';
        let end = text.find(|sign| !is_number(sign)).unwrap_or(text.len());
        let (number, unit) = text.split_at(end);
        let spelled = |spelling: &&Spelling| spelling.0 == unit.trim();
        let (_, times, by) = self.spellings().iter().find(spelled)?;
        let (negative, digits) = match number.strip_prefix('-') {
            Some(digits) => (true, digits),
            None => (false, number),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let is_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
        if whole.is_empty() || whole.len() > 12 || fraction.len() > 6 {
            return None;
        }
        if !is_digits(whole) || !is_digits(fraction) || number.ends_with('.') {
            return None;
        }
        let scale = 10_i64.pow(fraction.len() as u32);
        let part: i64 = match fraction {
            "" => 0,
            _ => fraction.parse().ok()?,
        };
        let number = whole.parse::<i64>().ok()?.checked_mul(scale)? + part;
        let value = number.checked_mul(*times)? / (by * scale);
        Some(if negative { -value } else { value })
    }

    /// A number of it as a person writes it: `1.5 l`.
    pub fn shown(self, value: i64) -> String {
        let Some((unit, times, _)) = self.spellings().first() else {
            return value.to_string();
        };
        let (whole, rest) = (value / times, (value % times).abs());
        let digits = times.ilog10() as usize;
        let number = match rest {
            0 => whole.to_string(),
            _ => {
                let sign = if value < 0 && whole == 0 { "-" } else { "" };
                let number = format!("{sign}{whole}.{rest:0digits$}");
                number.trim_end_matches('0').to_owned()
            }
        };
        match *unit {
            "%" => number + "%",
            unit => format!("{number} {unit}"),
        }
    }

    /// How it may be written, for a message.
    pub fn known(self) -> String {
        let names = self.spellings().iter().map(|(name, ..)| *name);
        names.collect::<Vec<_>>().join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_are_read_as_they_are_written() {
        for (unit, text, value) in [
            (Unit::Ms, "1.5 s", Some(1500)),
            (Unit::Ms, "20ms", Some(20)),
            (Unit::Ms, "3 min", Some(180_000)),
            (Unit::Ml, "0.25 l", Some(250)),
            (Unit::MlPerS, "60 l/min", Some(1000)),
            (Unit::Permille, "12.5%", Some(125)),
            (Unit::MilliC, "-5 °C", Some(-5000)),
            (Unit::Ma, "4.2 A", Some(4200)),
            (Unit::Ml, "3 kg", None),
            (Unit::Ml, "3", None),
            (Unit::Ml, "l", None),
            (Unit::Ml, "1. l", None),
            (Unit::Ml, "1.2.3 l", None),
            (Unit::Ml, "1-2 l", None),
            (Unit::Ml, "99999999999999999999 l", None),
            (Unit::Count, "3", None),
        ] {
            assert_eq!(unit.read(text), value, "{text}");
        }
        assert_eq!(Unit::Ms.shown(1500), "1.5 s");
        assert_eq!(Unit::Permille.shown(950), "95%");
        assert_eq!(Unit::MilliC.shown(-500), "-0.5 °C");
        assert_eq!(Unit::Count.shown(3), "3");
    }
}
