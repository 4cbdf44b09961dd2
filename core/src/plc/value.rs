//! Arithmetic on the 32-bit value (NC-16): it wraps, and division by zero gives 0.

use crate::isa::Opcode;

/// The result of an operation, and whether it was an arithmetic error: S 04 tells.
pub(super) fn operate(opcode: Opcode, value: i32, operand: i32) -> (i32, bool) {
    let result = match opcode {
        Opcode::Load => operand,
        Opcode::Add => value.wrapping_add(operand),
        Opcode::Subtract => value.wrapping_sub(operand),
        Opcode::Multiply => value.wrapping_mul(operand),
        Opcode::Divide if operand == 0 => return (0, true),
        Opcode::Divide => value.wrapping_div(operand),
        Opcode::Modulo if operand == 0 => return (0, true),
        Opcode::Modulo => value.wrapping_rem(operand),
        Opcode::AndWord => value & operand,
        Opcode::OrWord => value | operand,
        Opcode::XorWord => value ^ operand,
        _ => value,
    };
    (result, false)
}

/// The result of a comparison.
pub(super) fn compare(opcode: Opcode, value: i32, operand: i32) -> Option<bool> {
    Some(match opcode {
        Opcode::Greater => value > operand,
        Opcode::GreaterOrEqual => value >= operand,
        Opcode::Equal => value == operand,
        Opcode::NotEqual => value != operand,
        Opcode::LessOrEqual => value <= operand,
        Opcode::Less => value < operand,
        _ => return None,
    })
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
