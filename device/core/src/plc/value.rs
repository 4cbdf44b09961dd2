//! Arithmetic on the 32-bit value (NC-16): it wraps, and division by zero gives 0.

/// The quotient without the fraction, and whether it was an arithmetic error: S 04 tells.
pub(super) fn divide(value: i32, operand: i32) -> (i32, bool) {
    match operand {
        0 => (0, true),
        _ => (value.wrapping_div(operand), false),
    }
}

/// The rest of a division, and whether it was an arithmetic error.
pub(super) fn modulo(value: i32, operand: i32) -> (i32, bool) {
    match operand {
        0 => (0, true),
        _ => (value.wrapping_rem(operand), false),
    }
}

/// The quotient of numbers without signs, and whether it was an arithmetic error.
pub(super) fn unsigned_divide(value: i32, operand: i32) -> (i32, bool) {
    let quotient = value.cast_unsigned().checked_div(operand.cast_unsigned());
    (quotient.unwrap_or(0).cast_signed(), quotient.is_none())
}

/// The rest of such a division.
pub(super) fn unsigned_modulo(value: i32, operand: i32) -> (i32, bool) {
    let rest = value.cast_unsigned().checked_rem(operand.cast_unsigned());
    (rest.unwrap_or(0).cast_signed(), rest.is_none())
}

/// The low bits alone, 0 to 31 of them.
pub(super) fn extend_zero(value: i32, bits: u8) -> i32 {
    value & !(-1_i32).wrapping_shl(bits.into())
}

/// The low bits, 0 to 31 of them, the highest as the sign.
pub(super) fn extend_sign(value: i32, bits: u8) -> i32 {
    let unused = 32 - u32::from(bits);
    value.checked_shl(unused).map_or(0, |high| high >> unused)
}

/// The whole square root; of a negative value 0 and an error.
pub(super) fn square_root(value: i32) -> (i32, bool) {
    match value.checked_isqrt() {
        Some(root) => (root, false),
        None => (0, true),
    }
}

/// Linear scaling (NC-17): what comes is cut to its range; the loader has seen to it that the range is
/// none of one number.
pub(super) fn scale(value: i32, from: [i16; 2], to: [i16; 2]) -> i32 {
    let [from_low, from_high] = from.map(i64::from);
    let [to_low, to_high] = to.map(i64::from);
    let value = i64::from(value).clamp(from_low, from_high.max(from_low));
    let span = (from_high - from_low).max(1);
    (to_low + (value - from_low) * (to_high - to_low) / span) as i32
}
