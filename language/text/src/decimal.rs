//! Decimal fractions as the 32 bits of a REAL number, exactly rounded.
//!
//! The standard library reads the same: its tables for doing it fast are a tenth of a page's module, and a program has a
//! handful of such numbers. Must not know where in a text they stand.

use std::cmp::Ordering;

/// A number as it is written: digits without zeros before them, and the power of ten that they are multiplied by.
struct Decimal {
    digits: Vec<u8>,
    power: i64,
}

/// The number that is nearest to `12`, `1.5`, `2.5E-3`; of two as near, the even one. None where this is no such
/// number, or too large for a REAL.
pub fn real(text: &str) -> Option<f32> {
    let (is_negative, text) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let nearest = nearest(&Decimal::read(text)?)?;
    Some(if is_negative { -nearest } else { nearest })
}

/// Whether this is a number with or without a fraction and an exponent, of any size.
pub fn is_decimal(text: &str) -> bool {
    Decimal::read(text).is_some()
}

/// More digits than this decide nothing: half way between two neighbours has fewer. One after them stands for all others.
const MOST: usize = 120;

impl Decimal {
    /// Digits, perhaps with a point among or after them, and perhaps an exponent.
    fn read(text: &str) -> Option<Decimal> {
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, whole(exponent)?),
            None => (text, 0),
        };
        let (before, behind) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let mut digits = before.bytes().chain(behind.bytes());
        if before.is_empty() || !digits.clone().all(|digit| digit.is_ascii_digit()) {
            return None;
        }
        let mut power = exponent - behind.len() as i64;
        let mut kept: Vec<u8> = digits
            .by_ref()
            .skip_while(|&digit| digit == b'0')
            .map(|digit| digit - b'0')
            .collect();
        if kept.len() > MOST {
            power += (kept.len() - MOST) as i64;
            let rest = kept.split_off(MOST);
            if rest.iter().any(|&digit| digit != 0) {
                kept.push(1);
                power -= 1;
            }
        }
        Some(Decimal {
            digits: kept,
            power,
        })
    }
}

/// An exponent; one that is out of all bounds is as large as matters.
fn whole(text: &str) -> Option<i64> {
    let (sign, digits) = match text.as_bytes().first()? {
        b'-' => (-1, text.get(1..)?),
        b'+' => (1, text.get(1..)?),
        _ => (1, text),
    };
    if digits.is_empty() || !digits.bytes().all(|digit| digit.is_ascii_digit()) {
        return None;
    }
    Some(sign * digits.parse().unwrap_or(i64::MAX / 4).min(i64::MAX / 4))
}

/// The bits of the positive numbers are in the order of the numbers, so that the nearest is found by halves.
fn nearest(decimal: &Decimal) -> Option<f32> {
    // The number is at least 10^(top − 1), and less than 10^top.
    let top = decimal.power.saturating_add(decimal.digits.len() as i64);
    if decimal.digits.is_empty() || top < -50 {
        return Some(0.0);
    }
    if top > 40 {
        return None;
    }
    let (mut low, mut high) = (0, f32::INFINITY.to_bits());
    while low < high {
        let middle = low + (high - low) / 2;
        match compare(decimal, middle) {
            Ordering::Greater => low = middle + 1,
            Ordering::Equal if middle % 2 == 1 => low = middle + 1,
            _ => high = middle,
        }
    }
    Some(f32::from_bits(low)).filter(|number| number.is_finite())
}

/// A number beside the half way from the REAL of these bits to the next.
fn compare(decimal: &Decimal, bits: u32) -> Ordering {
    let (exponent, fraction) = (bits >> 23, bits & 0x7F_FFFF);
    let (mantissa, exponent) = match exponent {
        0 => (fraction, 1),
        exponent => (fraction | 0x80_0000, exponent),
    };
    // Half way is (2 mantissa + 1) × 2^(exponent − 151).
    let mut left = Natural::of(&decimal.digits);
    let mut right = Natural(vec![2 * mantissa + 1]);
    let tens = decimal.power.unsigned_abs() as u32;
    let twos = exponent.abs_diff(151);
    match decimal.power {
        0.. => left.times(10, tens),
        _ => right.times(10, tens),
    }
    match exponent {
        151.. => right.times(2, twos),
        _ => left.times(2, twos),
    }
    left.compare(&right)
}

/// A natural number of any size: its lowest 32 bits first, and no zeros last.
struct Natural(Vec<u32>);

impl Natural {
    fn of(digits: &[u8]) -> Natural {
        let mut number = Natural(Vec::new());
        for &digit in digits {
            number.step(10, digit.into());
        }
        number
    }

    /// Multiplied by a factor so many times.
    fn times(&mut self, factor: u32, mut times: u32) {
        while times > 0 {
            // As many at one time as fit 32 bits.
            let some = times.min(if factor == 2 { 31 } else { 9 });
            self.step(factor.pow(some), 0);
            times -= some;
        }
    }

    fn step(&mut self, factor: u32, plus: u32) {
        let mut carry = u64::from(plus);
        for part in &mut self.0 {
            carry += u64::from(*part) * u64::from(factor);
            *part = carry as u32;
            carry >>= 32;
        }
        if carry > 0 {
            self.0.push(carry as u32);
        }
    }

    fn compare(&self, other: &Natural) -> Ordering {
        let parts = |number: &Natural| number.0.len();
        parts(self)
            .cmp(&parts(other))
            .then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
    }
}

#[cfg(test)]
mod tests {
    use super::{is_decimal, real};
    use unoclp_testing::{Random, rounds};

    /// As the standard library reads it.
    fn expected(text: &str) -> Option<u32> {
        let number: f32 = text.parse().ok()?;
        number.is_finite().then(|| number.to_bits())
    }

    #[track_caller]
    fn is_same(text: &str) {
        assert_eq!(real(text).map(f32::to_bits), expected(text), "{text}");
    }

    #[test]
    fn limits_and_halves_are_rounded_as_the_standard_library_does() {
        for text in [
            "0",
            "-0",
            "0.0",
            "1",
            "-1.5",
            "1.",
            "00.10",
            "16777217",
            "16777219",
            "3.4028235e38",
            "3.4028236e38",
            "3.40282357e38",
            "1e39",
            "1e999999999999999999999",
            "1e-999999999999999999999",
            "1.4e-45",
            "7.006492321624085e-46",
            "7.006492321624086e-46",
            "1.17549435e-38",
            "0e999999999999",
            "0.000000000000000000000000000000000000000000001401298464324817070923729583289916131280261941876515771757",
        ] {
            is_same(text);
        }
        for text in [
            "", "-", ".", ".5", "e1", "1e", "1e+", "1.2.3", "1x", "--1", "inf", "NaN", "1e5.0",
        ] {
            assert_eq!(real(text), None, "{text}");
            assert!(!is_decimal(text), "{text}");
        }
        assert!(is_decimal("1e99"));
    }

    #[test]
    fn random_numbers_are_read_as_the_standard_library_reads_them() {
        let mut random = Random(21);
        for _ in 0..rounds(20_000) {
            let number = f32::from_bits(random.bits() as u32 & 0x7FFF_FFFF);
            let next = f64::from(f32::from_bits(number.to_bits() + 1));
            let half = f64::midpoint(f64::from(number), next);
            if half.is_finite() {
                // Half way, exactly, a little above and a little below.
                let exact = format!("{half:.160}");
                is_same(&exact);
                is_same(&format!("{exact}0000000001"));
                is_same(&format!("{half:e}"));
            }
            let digits: String = (0..=random.below(30))
                .map(|_| char::from(b'0' + random.below(10) as u8))
                .collect();
            is_same(&format!("{digits}e{}", random.below(100) as i32 - 70));
            is_same(&format!("0.{digits}"));
        }
    }
}
