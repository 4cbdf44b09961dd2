//! REAL numbers: IEEE 754 single, as the 32 bits of a value.
//!
//! Each operation gives the bits of its result, and whether it was an arithmetic error: a result that is
//! not finite is 0 and an error, and so is a number that does not fit an integer. So x / ∞ is 0 without
//! an error, as IEEE 754 has it, and √-0 is -0.
//!
//! Bit by bit this is what the UNO gives. Its library rounds to nearest, halves to even, and differs from
//! IEEE 754 in one place: of a product or quotient below the least normal number it forgets digits before
//! it rounds, so the result may be one subnormal step too small.

const SIGN: u32 = 0x8000_0000;

/// value + operand
pub fn add(value: i32, operand: i32) -> (i32, bool) {
    finite(real(value) + real(operand))
}

/// value - operand
pub fn subtract(value: i32, operand: i32) -> (i32, bool) {
    finite(real(value) - real(operand))
}

/// value × operand
pub fn multiply(value: i32, operand: i32) -> (i32, bool) {
    let (a, b) = (Parts::of(value), Parts::of(operand));
    let below = Parts::BIAS - a.exponent - b.exponent;
    if below > 0 && a.is_finite() && b.is_finite() {
        return (
            nearest((a.digits * b.digits) >> below.min(63), 24) | sign(value ^ operand),
            false,
        );
    }
    finite(real(value) * real(operand))
}

/// value / operand
pub fn divide(value: i32, operand: i32) -> (i32, bool) {
    let (a, b) = (Parts::of(value), Parts::of(operand));
    if a.is_finite() && b.is_finite() && a.digits != 0 && b.digits != 0 {
        let (a, b) = (a.normal(), b.normal());
        // One more digit where the quotient would begin with 0.
        let less = i32::from(a.digits < b.digits);
        let below = b.exponent - a.exponent - Parts::BIAS + 1 + less;
        if below > 0 {
            let dividend = a.digits << (23 + less);
            let (quotient, rest) = (dividend / b.digits, dividend % b.digits);
            // Of the rest the chip knows whether it is less than a half, a half or more.
            let rest = match (2 * rest).cmp(&b.digits) {
                core::cmp::Ordering::Less => 0,
                core::cmp::Ordering::Equal => 0x80,
                core::cmp::Ordering::Greater => 0xFF,
            };
            let digits = quotient << 16 | rest << 8;
            return (
                nearest(digits >> below.min(63), 16) | sign(value ^ operand),
                false,
            );
        }
    }
    finite(real(value) / real(operand))
}

/// The square root; of what is less than 0 it is 0 and an error.
pub fn square_root(value: i32) -> (i32, bool) {
    let parts = Parts::of(value);
    if parts.digits == 0 {
        return (value, false);
    }
    if value < 0 || !parts.is_finite() {
        return (0, true);
    }
    let Parts { digits, exponent } = parts.normal();
    // digits × 2^(exponent - 150), with an even power of 2.
    let odd = exponent & 1;
    let square = digits << (26 + odd);
    let root = square.isqrt();
    let digits = root << 1 | u64::from(root * root != square);
    let power = (exponent - odd - 150 - 26) / 2 - 1;
    let scale = f32::from_bits(((power + Parts::BIAS) as u32) << 23);
    finite(digits as f32 * scale)
}

/// A signed integer becomes a REAL; it always fits.
pub fn from_signed(value: i32) -> (i32, bool) {
    finite(value as f32)
}

/// The same of an integer without a sign.
pub fn from_unsigned(value: i32) -> (i32, bool) {
    finite(value.cast_unsigned() as f32)
}

/// The nearest integer, the even one of two.
pub fn round(value: i32) -> (i32, bool) {
    // From here on a REAL has no fraction.
    const WHOLE: f32 = 8_388_608.0;
    let number = real(value);
    let size = number.abs();
    if size < WHOLE {
        // The sum rounds it.
        let size = (size + WHOLE - WHOLE) as i32;
        return (if value < 0 { -size } else { size }, false);
    }
    cut(value)
}

/// The integer that is left without the fraction.
pub fn cut(value: i32) -> (i32, bool) {
    const END: f32 = 2_147_483_648.0;
    let number = real(value);
    match (-END..END).contains(&number) {
        true => (number as i32, false),
        false => (0, true),
    }
}

/// -value
pub fn negate(value: i32) -> (i32, bool) {
    finite(-real(value))
}

/// value without its sign
pub fn absolute(value: i32) -> (i32, bool) {
    finite(real(value).abs())
}

/// An integer for each REAL, in the same order: -0 becomes 0, and nothing is an error.
pub fn comparable(value: i32) -> i32 {
    match value < 0 {
        true => -(value & i32::MAX),
        false => value,
    }
}

fn real(bits: i32) -> f32 {
    f32::from_bits(bits.cast_unsigned())
}

fn finite(result: f32) -> (i32, bool) {
    match result.is_finite() {
        true => (result.to_bits().cast_signed(), false),
        false => (0, true),
    }
}

fn sign(bits: i32) -> i32 {
    (bits.cast_unsigned() & SIGN).cast_signed()
}

/// Rounds to whole digits, halves to even: so many bits are a fraction.
fn nearest(digits: u64, fraction: u32) -> i32 {
    let half = 1_u64 << (fraction - 1);
    let odd = digits >> fraction & 1;
    ((digits + half - 1 + odd) >> fraction) as i32
}

/// A REAL without its sign: digits × 2^(exponent - 150).
struct Parts {
    digits: u64,
    exponent: i32,
}

impl Parts {
    const BIAS: i32 = 127;

    fn of(bits: i32) -> Parts {
        let bits = bits.cast_unsigned();
        let (digits, exponent) = (u64::from(bits & 0x7F_FFFF), (bits >> 23 & 0xFF) as i32);
        match exponent {
            0 => Parts {
                digits,
                exponent: 1,
            },
            _ => Parts {
                digits: digits | 0x80_0000,
                exponent,
            },
        }
    }

    fn is_finite(&self) -> bool {
        self.exponent < 255
    }

    /// With 24 digits, of which the first is 1. There must be one.
    fn normal(self) -> Parts {
        let shift = self.digits.leading_zeros().saturating_sub(40);
        Parts {
            digits: self.digits << shift,
            exponent: self.exponent - shift as i32,
        }
    }
}

#[cfg(test)]
mod tests;
