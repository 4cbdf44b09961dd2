//! Instructions that a text says by their codes.
//!
//! Owns what stands behind one, as far as the tree has to know it.

use unoclp_core::isa::Opcode;

/// The number of the label that this code is.
pub fn label(code: i32) -> Option<u8> {
    let number = code.wrapping_sub(Opcode::Label.row().code);
    u8::try_from(number)
        .ok()
        .filter(|number| (1..=99).contains(number))
}

/// Whether acc is 1 behind this code, and a label may stand there.
pub fn begins(code: i32) -> bool {
    let opcodes = [Opcode::NewRung, Opcode::If, Opcode::Else, Opcode::EndIf];
    opcodes.iter().any(|opcode| opcode.row().code == code) || label(code).is_some()
}
