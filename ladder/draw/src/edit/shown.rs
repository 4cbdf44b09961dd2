//! What a step looks like, complete or not.

use super::step::{Step, target};
use crate::words::{NO_PRESET, picture};
use crate::{Element, Symbol};
use unoclp_core::isa::{Kind, Opcode, Operand, REGISTER_OPERAND, Value};
use unoclp_core::{Instruction, Target, TimerBlock};
use unoclp_point::UNKNOWN;

/// The outputs of a drum's steps, bit 0 output 01; those that are missing are 0.
pub(crate) fn drum(step: &Step) -> Vec<u8> {
    let lines = step.lines().iter().skip(1);
    let digit = |line: i32, at: u32| line / 10_i32.pow(3 - at) % 10 == 1;
    let outputs = |line: &Option<i32>| {
        let line = line.unwrap_or(0);
        (0..4).fold(0, |step, at| step | u8::from(digit(line, at)) << at)
    };
    match step.opcode().row().kind {
        Kind::Drum => lines.map(outputs).collect(),
        _ => Vec::new(),
    }
}

/// The instruction that the step is, with what is missing as the drawing shows it; `drum` is what [`drum`] gives.
pub(crate) fn instruction<'d>(step: &Step, drum: &'d [u8]) -> Instruction<'d> {
    let number = step.number().unwrap_or(UNKNOWN);
    let line = |index: usize| step.lines().get(index).copied().flatten();
    let byte = |index: usize| line(index).map_or(UNKNOWN, as_byte);
    let bound = |index: usize| line(index).map_or(0, as_bound);
    let operand = match step.opcode().row().kind {
        Kind::None => Operand::None,
        Kind::Timer => Operand::Timer(TimerBlock {
            preset: line(0).unwrap_or(NO_PRESET).cast_unsigned(),
            target: line(1).and_then(target).unwrap_or(Target::Output(UNKNOWN)),
        }),
        Kind::Count => Operand::Count {
            counter: number,
            preset: line(0).unwrap_or(NO_PRESET),
        },
        Kind::Value | Kind::Real => Operand::Value(match (number, line(0)) {
            (0, Some(constant)) => Value::Constant(constant),
            (0, None) => Value::Register(UNKNOWN),
            (unoclp_core::isa::POPPED, _) => Value::Popped,
            (register, _) => Value::Register(register),
        }),
        Kind::Table => Operand::Table {
            first: number,
            length: byte(0),
        },
        Kind::Move => Operand::Move {
            from: number,
            to: line(0).map_or(UNKNOWN, |line| {
                as_byte(line.saturating_sub(REGISTER_OPERAND))
            }),
            count: byte(1),
        },
        Kind::Drum => Operand::Drum {
            register: number,
            steps: drum,
        },
        Kind::Scale => Operand::Scale {
            from: [bound(0), bound(1)],
            to: [bound(2), bound(3)],
        },
        Kind::Filter => Operand::Filter {
            strength: number,
            time: line(0).map_or(0, |line| u16::try_from(line).unwrap_or(u16::MAX)),
        },
        Kind::Jump => Operand::Jump {
            label: number,
            line: 0,
        },
        Kind::Input | Kind::Output | Kind::Branch | Kind::Marker | Kind::System => {
            Operand::Number(number)
        }
        Kind::TimerQ | Kind::Counter | Kind::Register | Kind::Analogue | Kind::Pwm => {
            Operand::Number(number)
        }
        Kind::Reading | Kind::Group | Kind::Bit | Kind::Time | Kind::Label => {
            Operand::Number(number)
        }
    };
    let opcode = step.opcode();
    Instruction { opcode, operand }
}

/// Puts `?` in place of operands that have no number for what is missing.
pub(crate) fn question(step: &Step, symbol: &mut Symbol) {
    let several = matches!(
        step.opcode().row().kind,
        Kind::Table | Kind::Move | Kind::Scale | Kind::Filter
    );
    if let Symbol::Box { text, .. } = symbol
        && several
        && !step.is_complete()
    {
        *text = picture(step.opcode()).replace("operand", "?");
    }
}

/// An instruction that the form of a rung asks for.
pub(crate) fn form(opcode: Opcode, number: Option<u8>) -> Instruction<'static> {
    match number {
        Some(number) => Instruction::numbered(opcode, number),
        None => Instruction::plain(opcode),
    }
}

fn as_byte(line: i32) -> u8 {
    line.clamp(0, UNKNOWN.into()) as u8
}

fn as_bound(line: i32) -> i16 {
    line.clamp(i16::MIN.into(), i16::MAX.into()) as i16
}

/// What stands for a path on which nothing stands.
pub(crate) const HOLE: Instruction<'static> = Instruction::numbered(Opcode::InputContact, UNKNOWN);

/// Lets the symbol of a [`HOLE`] say that nothing stands there.
pub(crate) fn nothing(element: &mut Element) {
    element.point = None;
    element.symbol = Symbol::Contact {
        closed: false,
        text: "?".to_owned(),
    };
}
