//! How Instruction List writes each instruction, according to the instruction table.

use unoclp_core::Instruction;
use unoclp_core::isa::{Kind, Opcode, Operand, Value};

macro_rules! lines {
    ($($name:ident $kind:ident $class:ident $code:literal $letters:literal $stored:literal $own:literal
        $effect:literal $il:literal $picture:literal;)*) => {
        /// The line of an instruction; for a contact, a load or a store, only its operand. Empty where
        /// Instruction List has no words for it. [`words`] replaces `XX` and `operand`.
        const fn line(opcode: Opcode) -> &'static str {
            match opcode {
                $(Opcode::$name => $il,)*
            }
        }
    };
}
unoclp_core::instructions!(lines);

/// The operator of an instruction; empty where Instruction List has none for it.
pub fn operator(opcode: Opcode) -> &'static str {
    line(opcode).split(' ').next().unwrap_or("")
}

/// The words of an instruction: operator and operands, or the operand alone. None where Instruction List has
/// none.
pub fn words(step: Instruction<'_>) -> Option<(&'static str, String)> {
    let line = line(step.opcode);
    if line.is_empty() {
        return None;
    }
    let (operator, operands) = line.split_once(' ').unwrap_or((line, ""));
    Some((operator, with_operands(operands, step)?))
}

/// The operand of a contact, a load or a store.
pub fn named(step: Instruction<'_>) -> Option<String> {
    let line = line(step.opcode);
    (!line.is_empty())
        .then(|| with_operands(line, step))
        .flatten()
}

fn with_operands(text: &str, step: Instruction<'_>) -> Option<String> {
    let mut text = text.to_owned();
    if text.contains("operand") {
        text = text.replace("operand", &operand(step)?);
    }
    if text.contains("XX") {
        text = text.replace("XX", &point(step)?);
    }
    Some(text)
}

/// The name of the point that a code names.
fn point(step: Instruction<'_>) -> Option<String> {
    let n = step.number()?;
    Some(match step.opcode.row().kind {
        Kind::Input => format!("I{n}"),
        Kind::Output => format!("Q{n}"),
        Kind::Marker => format!("M{n}"),
        Kind::System => format!("S{n}"),
        Kind::TimerQ => format!("T{n}"),
        Kind::Counter | Kind::Count => format!("C{n}"),
        Kind::Register | Kind::Value | Kind::Real | Kind::Move | Kind::Drum | Kind::Table => {
            format!("D{n}")
        }
        Kind::Analogue => format!("IW{n}"),
        Kind::Pwm => format!("QW{n}"),
        Kind::Group => format!("MB{n}"),
        Kind::Label | Kind::Jump => format!("L{n:02}"),
        Kind::Bit | Kind::Time => n.to_string(),
        Kind::None | Kind::Branch | Kind::Reading | Kind::Timer | Kind::Scale | Kind::Filter => {
            return None;
        }
    })
}

/// What follows a code: a register, a constant, a preset.
fn operand(step: Instruction<'_>) -> Option<String> {
    Some(match step.operand {
        Operand::Value(Value::Register(register)) => format!("D{register}"),
        Operand::Value(Value::Constant(number)) if step.opcode.row().kind == Kind::Real => {
            real(number)
        }
        Operand::Value(Value::Constant(number)) => number.to_string(),
        Operand::Value(Value::Popped) => "POP".to_owned(),
        Operand::Table { first, length } => format!("D{first}, {length}"),
        Operand::Count { preset, .. } => preset.to_string(),
        Operand::Timer(block) => block.preset.to_string(),
        Operand::None | Operand::Number(_) | Operand::Jump { .. } => return None,
        Operand::Move { .. } | Operand::Drum { .. } => return None,
        Operand::Scale { .. } | Operand::Filter { .. } => return None,
    })
}

/// The shortest literal of this REAL number: `0.5`, `1E30`.
fn real(bits: i32) -> String {
    format!("{:?}", f32::from_bits(bits.cast_unsigned())).replace('e', "E")
}
