//! The names of points, and the words of operations.

use unoclp_core::isa::{Opcode, Operand, Value};
use unoclp_core::{Instruction, Target};

/// The name of a contact's point, and whether it is inverted.
pub(super) fn contact(step: Instruction<'_>) -> Option<(String, bool)> {
    let n = step.number()?;
    Some(match step.opcode {
        Opcode::InputContact => (format!("I{n}"), false),
        Opcode::InputContactNot => (format!("I{n}"), true),
        Opcode::OutputContact => (format!("Q{n}"), false),
        Opcode::OutputContactNot => (format!("Q{n}"), true),
        Opcode::MarkerContact => (format!("M{n}"), false),
        Opcode::MarkerContactNot => (format!("M{n}"), true),
        Opcode::SystemContact => (format!("S{n}"), false),
        Opcode::SystemContactNot => (format!("S{n}"), true),
        Opcode::TimerContact => (format!("T{n}.Q"), false),
        Opcode::TimerContactNot => (format!("T{n}.Q"), true),
        Opcode::CounterContact => (format!("C{n}.QU"), false),
        Opcode::CounterContactNot => (format!("C{n}.QU"), true),
        Opcode::ZeroContact => (format!("C{n}.QD"), false),
        Opcode::ZeroContactNot => (format!("C{n}.QD"), true),
        _ => return None,
    })
}

/// The name of a number that is loaded.
pub(super) fn load(step: Instruction<'_>) -> Option<String> {
    let n = step.number().unwrap_or(0);
    Some(match step.opcode {
        Opcode::Load => operand(step)?,
        Opcode::LoadAnalogue => format!("IW{n}"),
        Opcode::LoadTimer => format!("T{n}.ET"),
        Opcode::LoadCount => format!("C{n}.CV"),
        Opcode::LoadMarkers => format!("MB{n}"),
        Opcode::LoadInputs => "IB0".to_owned(),
        Opcode::LoadOutputs => "QB0".to_owned(),
        _ => return None,
    })
}

/// Where a number is stored.
pub(super) fn number_target(step: Instruction<'_>) -> Option<String> {
    let n = step.number().unwrap_or(0);
    Some(match step.opcode {
        Opcode::Store => format!("D{n}"),
        Opcode::StoreCount => format!("C{n}.CV"),
        Opcode::StorePwm => format!("QW{n}"),
        Opcode::StoreMarkers => format!("MB{n}"),
        Opcode::StoreOutputs => "QB0".to_owned(),
        Opcode::PresetCounter => format!("C{n}.PV"),
        Opcode::PresetTimer => format!("T{n}.PT"),
        _ => return None,
    })
}

/// The register or constant of an operation.
fn operand(step: Instruction<'_>) -> Option<String> {
    match step.operand {
        Operand::Value(Value::Register(register)) => Some(format!("D{register}")),
        Operand::Value(Value::Constant(number)) => Some(number.to_string()),
        _ => None,
    }
}

/// An operation on a number, and its operand.
pub(super) fn operation(step: Instruction<'_>) -> Option<(&'static str, String)> {
    Some(match step.opcode {
        Opcode::Negate => ("NEG", String::new()),
        Opcode::SquareRoot => ("SQRT", String::new()),
        Opcode::ShiftLeft | Opcode::ShiftRight => {
            (step.opcode.row().letters, step.number()?.to_string())
        }
        Opcode::Load => return None,
        opcode => (opcode.row().letters, operand(step)?),
    })
}

pub(super) fn comparison(opcode: Opcode) -> bool {
    matches!(
        opcode,
        Opcode::Greater
            | Opcode::GreaterOrEqual
            | Opcode::Equal
            | Opcode::NotEqual
            | Opcode::LessOrEqual
            | Opcode::Less
    )
}

pub(super) fn target(target: Target) -> String {
    match target {
        Target::Output(n) => format!("Q{n}"),
        Target::Marker(n) => format!("M{n}"),
    }
}
