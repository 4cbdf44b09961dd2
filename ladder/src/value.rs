//! What is known about the value accumulator.

use crate::{Address, Element, Symbol};
use unoclp_core::isa::{Opcode, Operand, Value};
use unoclp_core::{Delay, Instruction};

/// Whether an instruction is a condition on the value accumulator.
pub(crate) fn asks_for_value(opcode: Opcode) -> bool {
    !sign(opcode).is_empty() || matches!(opcode, Opcode::BitContact | Opcode::BitContactNot)
}

/// What the value accumulator holds behind an instruction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Load {
    /// What it was loaded from: `A0`, `D12`, `-5`.
    pub(crate) source: String,
    /// Whether a coil may change what it was loaded from.
    pub(crate) follows_coils: bool,
}

impl Load {
    /// None where the instruction is no load.
    pub(crate) fn of(instruction: Instruction<'_>) -> Option<Load> {
        let xx = instruction.number().unwrap_or(0);
        let (source, follows_coils) = match instruction.opcode {
            Opcode::Load => (operand(instruction), false),
            Opcode::LoadAnalogue => (Address::Analogue(xx).to_string(), false),
            Opcode::LoadTimer => (Address::Timer(xx).to_string(), true),
            Opcode::LoadCount => (Address::Counter(xx).to_string(), true),
            Opcode::LoadSystem if xx == 1 => ("scan µs".to_owned(), false),
            Opcode::LoadSystem => ("time ms".to_owned(), false),
            Opcode::LoadMarkers => (group(xx), true),
            Opcode::LoadInputs => ("I".to_owned(), false),
            Opcode::LoadOutputs => ("Q".to_owned(), true),
            _ => return None,
        };
        Some(Load {
            source,
            follows_coils,
        })
    }

    /// Whether it is still what the value holds behind an instruction that is no load.
    pub(crate) fn survives(&self, element: &Element, opcode: Opcode) -> bool {
        let changes_nothing = asks_for_value(opcode)
            || matches!(element.symbol, Symbol::Contact { .. } | Symbol::Inline(_));
        let drives = element.is_output()
            || Delay::of(opcode).is_some()
            || matches!(opcode, Opcode::CountUp | Opcode::CountDown);
        changes_nothing || drives && !self.follows_coils
    }
}

/// The point that an operand or a load names.
pub(crate) fn point_of(instruction: Instruction<'_>) -> Option<Address> {
    let xx = instruction.number()?;
    Some(match (instruction.opcode, instruction.operand) {
        (Opcode::LoadAnalogue, _) => Address::Analogue(xx),
        (Opcode::LoadTimer, _) => Address::Timer(xx),
        (Opcode::LoadCount, _) => Address::Counter(xx),
        (_, Operand::Value(Value::Register(register))) => Address::Register(register),
        _ => return None,
    })
}

/// A register or a constant.
pub(crate) fn operand(instruction: Instruction<'_>) -> String {
    match instruction.operand {
        Operand::Value(Value::Register(register)) => Address::Register(register).to_string(),
        Operand::Value(Value::Constant(number)) => number.to_string(),
        _ => String::new(),
    }
}

/// Eight markers.
pub(crate) fn group(number: u8) -> String {
    let last = u32::from(number) * 8;
    format!("M{}-{last}", last.saturating_sub(7))
}

/// The sign of a comparison; empty for what is none.
pub(crate) fn sign(opcode: Opcode) -> &'static str {
    match opcode {
        Opcode::Greater => ">",
        Opcode::GreaterOrEqual => ">=",
        Opcode::Equal => "=",
        Opcode::NotEqual => "<>",
        Opcode::LessOrEqual => "<=",
        Opcode::Less => "<",
        _ => "",
    }
}
