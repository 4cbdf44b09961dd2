//! REAL numbers as NC-23 tells them, by numbers of 64 bits that round but once.
//!
//! A value is the 32 bits of a REAL, with a sign. None is an arithmetic error.

/// The least number above 0, of which all others are multiples.
const STEP: f64 = 1.401_298_464_324_817e-45;
/// What is less than so many steps is subnormal.
const NORMAL: f64 = 8_388_608.0;

pub fn real(bits: i64) -> f32 {
    f32::from_bits(bits as u32)
}

fn bits(number: f32) -> Option<i64> {
    number
        .is_finite()
        .then(|| i64::from(number.to_bits() as i32))
}

pub fn operate(name: &str, value: i64, operand: i64) -> Option<i64> {
    let (a, b) = (real(value), real(operand));
    bits(match name {
        "RAD" => a + b,
        "RSU" => a - b,
        "RMU" => product(a, b),
        "RDI" => quotient(a, b),
        _ => panic!("{name}: say in tests/naive what it does"),
    })
}

pub fn change(name: &str, value: i64) -> Option<i64> {
    let number = real(value);
    match name {
        "ITR" => bits(value as f32),
        "UTR" => bits(value.rem_euclid(1 << 32) as f32),
        "RND" => whole(f64::from(number).round_ties_even()),
        "TRC" => whole(f64::from(number).trunc()),
        "RNG" => bits(-number),
        "RAB" => bits(number.abs()),
        "RRT" => bits(number.sqrt()),
        // It compares as the REAL does.
        "CMR" => Some(match value {
            0.. => value,
            _ => -(value + (1 << 31)),
        }),
        _ => panic!("{name}: say in tests/naive what it does"),
    }
}

/// The whole number, where 32 bits with a sign hold it.
fn whole(number: f64) -> Option<i64> {
    (-2_147_483_648.0..2_147_483_648.0)
        .contains(&number)
        .then_some(number as i64)
}

/// Of a product below the least normal number, a 2^24th of a step and less is forgotten before it is rounded.
fn product(a: f32, b: f32) -> f32 {
    // 48 digits: 64 bits hold them all.
    let exact = f64::from(a) * f64::from(b);
    let steps = exact.abs() / STEP;
    if steps.is_nan() || steps >= NORMAL {
        return exact as f32;
    }
    let kept = (steps * 16_777_216.0).floor() / 16_777_216.0;
    subnormal(kept, a.is_sign_negative() != b.is_sign_negative())
}

/// Of such a quotient 24 digits are taken, and of the rest whether it is less than a half, a half or more,
/// which is 0, 1/2 or 255/256; then a 2^16th of a step and less is forgotten.
fn quotient(a: f32, b: f32) -> f32 {
    let plain = a / b;
    let about = f64::from(a).abs() / f64::from(b).abs();
    if plain.is_nan() || plain.abs() > f32::MIN_POSITIVE || about == 0.0 || about / STEP > NORMAL {
        return plain;
    }
    // Exactly dividend / divisor, with 24 digits before the point.
    let (mut dividend, mut dividend_power) = integer(a);
    let (divisor, divisor_power) = integer(b);
    while dividend / divisor < 1 << 23 {
        (dividend, dividend_power) = (dividend * 2, dividend_power - 1);
    }
    let mut unit = 1;
    while dividend / (divisor * unit) >= 1 << 24 {
        unit *= 2;
    }
    let divisor = divisor * unit;
    let rest = match (dividend % divisor * 2).cmp(&divisor) {
        std::cmp::Ordering::Less => 0.0,
        std::cmp::Ordering::Equal => 0.5,
        std::cmp::Ordering::Greater => 255.0 / 256.0,
    };
    let digits = (dividend / divisor) as f64 + rest;
    let power = dividend_power - divisor_power + unit.trailing_zeros() as i32;
    let steps = digits * 2_f64.powi(power) / STEP;
    if steps >= NORMAL {
        return plain;
    }
    let kept = (steps * 65_536.0).floor() / 65_536.0;
    subnormal(kept, a.is_sign_negative() != b.is_sign_negative())
}

/// A whole number, and the power of 2 by which it is to be multiplied.
fn integer(number: f32) -> (u128, i32) {
    let (mut number, mut power) = (f64::from(number).abs(), 0);
    while number != number.trunc() {
        (number, power) = (number * 2.0, power - 1);
    }
    while number >= 9_007_199_254_740_992.0 {
        (number, power) = (number / 2.0, power + 1);
    }
    (number as u128, power)
}

/// So many steps, the nearest whole number of them.
fn subnormal(steps: f64, negative: bool) -> f32 {
    let number = f32::from_bits(steps.round_ties_even() as u32);
    if negative { -number } else { number }
}
