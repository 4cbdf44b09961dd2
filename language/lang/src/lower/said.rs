//! Words that operations and operands go by.

use crate::operators::Op;
use crate::words::operator;

/// The operand that stands for what was pushed.
pub(super) const POP: &str = "POP";

/// What messages call an operation.
pub(super) fn name(op: Op) -> &'static str {
    match op {
        Op::And => "AND",
        Op::Or => "OR",
        Op::Xor => "XOR",
        Op::Number(opcode) | Op::Compare(opcode) | Op::Shift(opcode) | Op::Table(opcode) => {
            operator(opcode)
        }
        _ => "",
    }
}
