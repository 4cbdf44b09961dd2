//! What is known about the value accumulator.

use crate::words::{VALUE, words};
use crate::{Element, Symbol};
use unoclp_core::Instruction;
use unoclp_core::isa::{Class, Opcode};

/// Whether an instruction is a condition on the value accumulator.
pub(crate) fn asks_for_value(opcode: Opcode) -> bool {
    matches!(opcode.class(), Class::Comparison | Class::ValueContact)
}

/// What the value accumulator holds after an instruction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Load {
    /// What it was loaded from: `A0`, `D12`, `-5`.
    pub(crate) source: String,
    /// Whether a coil may change what it was loaded from.
    follows_coils: bool,
}

impl Load {
    /// None where the instruction is no load.
    pub(crate) fn of(instruction: Instruction<'_>) -> Option<Load> {
        (instruction.opcode.class() == Class::Load).then(|| Load {
            source: words(instruction, VALUE),
            follows_coils: follows_coils(instruction.opcode),
        })
    }

    /// What the box of a load from this source says.
    pub(crate) fn text(source: &str) -> String {
        format!("LD {source}")
    }

    /// Whether it is still what the value holds after an instruction that is no load.
    pub(crate) fn survives(&self, element: &Element, opcode: Opcode) -> bool {
        let changes_nothing = asks_for_value(opcode)
            || matches!(element.symbol, Symbol::Contact { .. } | Symbol::Inline(_));
        let drives = element.is_output() || matches!(opcode.class(), Class::Timer | Class::Count);
        changes_nothing || drives && !self.follows_coils
    }
}

/// Whether a coil, a timer or a counter may change what this loads. Inputs, readings, registers and constants
/// stay as they are; whatever else there is may change.
fn follows_coils(load: Opcode) -> bool {
    let stays = [
        Opcode::Load,
        Opcode::LoadAnalogue,
        Opcode::LoadSystem,
        Opcode::LoadInputs,
    ];
    !stays.contains(&load)
}
