//! The words of a symbol: those of the instruction table, with the operands put in.

use unoclp_core::Instruction;
use unoclp_core::isa::{Kind, Opcode, Operand, Value};
use unoclp_point::{Address, UNKNOWN};

/// The value where its source is not known.
pub(crate) const VALUE: &str = "V";

macro_rules! pictures {
    ($($name:ident $kind:ident $class:ident $code:literal $letters:literal $stored:literal $own:literal
        $effect:literal $il:literal $picture:literal;)*) => {
        /// How the instruction table pictures an instruction: `XX`, `operand` and `value` stand for what
        /// `words` puts in.
        pub const fn picture(opcode: Opcode) -> &'static str {
            match opcode {
                $(Opcode::$name => $picture,)*
            }
        }
    };
}
unoclp_core::instructions!(pictures);

/// What the symbol of an instruction says, where the value accumulator holds `value`.
pub(crate) fn words(instruction: Instruction<'_>, value: &str) -> String {
    picture(instruction.opcode)
        .replace("XX", &point(instruction))
        .replace("operand", &operand(instruction))
        .replace("value", value)
}

/// What XX of an instruction is called.
fn point(instruction: Instruction<'_>) -> String {
    let xx = instruction.number().unwrap_or(0);
    match instruction.opcode.row().kind {
        Kind::Group if xx == UNKNOWN => "M?".to_owned(),
        Kind::Group => {
            let last = u32::from(xx) * 8;
            format!("M{}-{last}", last.saturating_sub(7))
        }
        Kind::Reading if xx == 1 => "scan µs".to_owned(),
        Kind::Reading if xx != UNKNOWN => "time ms".to_owned(),
        Kind::Reading | Kind::Bit | Kind::Time if xx == UNKNOWN => "?".to_owned(),
        Kind::Reading
        | Kind::None
        | Kind::Branch
        | Kind::Bit
        | Kind::Time
        | Kind::Timer
        | Kind::Scale => xx.to_string(),
        Kind::Filter => xx.to_string(),
        Kind::Input | Kind::Output | Kind::Marker | Kind::System | Kind::TimerQ | Kind::Counter => {
            address(instruction)
        }
        Kind::Register | Kind::Analogue | Kind::Pwm | Kind::Label | Kind::Jump | Kind::Count => {
            address(instruction)
        }
        Kind::Value | Kind::Real | Kind::Move | Kind::Drum | Kind::Table => address(instruction),
    }
}

fn address(instruction: Instruction<'_>) -> String {
    Address::of(instruction).map_or_else(String::new, |point| point.to_string())
}

/// What follows the code.
fn operand(instruction: Instruction<'_>) -> String {
    match instruction.operand {
        Operand::Value(Value::Register(UNKNOWN)) => "?".to_owned(),
        Operand::Value(Value::Register(register)) => Address::Register(register).to_string(),
        Operand::Value(Value::Constant(number)) if instruction.opcode.row().kind == Kind::Real => {
            format!("{:?}", f32::from_bits(number.cast_unsigned()))
        }
        Operand::Value(Value::Constant(number)) => number.to_string(),
        Operand::Value(Value::Popped) => VALUE.to_owned(),
        Operand::Table { first, length } => {
            format!(
                "D{first}-{}",
                first.saturating_add(length).saturating_sub(1)
            )
        }
        Operand::Count { preset, .. } => amount(preset),
        Operand::Move { from, to, count } => {
            let last = |first: u8| first.saturating_add(count).saturating_sub(1);
            format!("D{from}-{} to D{to}-{}", last(from), last(to))
        }
        Operand::Scale { from, to } => format!("{}..{} to {}..{}", from[0], from[1], to[0], to[1]),
        Operand::Filter { strength, time } => {
            let part = 1u32.checked_shl(strength.into());
            let part = part.map_or_else(|| "?".to_owned(), |part| part.to_string());
            format!("1/{part} {time} ms")
        }
        Operand::Timer(block) => format!("{} ms", amount(block.preset.cast_signed())),
        // The steps stand below the box.
        Operand::Drum { .. } => String::new(),
        Operand::None | Operand::Number(_) | Operand::Jump { .. } => String::new(),
    }
}

/// A preset; `?` where a person has not given it yet.
pub(crate) fn amount(preset: i32) -> String {
    match preset {
        NO_PRESET => "?".to_owned(),
        preset => preset.to_string(),
    }
}

/// A preset that a person has not given yet: no program has it.
pub(crate) const NO_PRESET: i32 = i32::MIN;
