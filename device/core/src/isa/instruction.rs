//! An instruction of a checked program, with its operands.

use super::{
    BYTE_CONSTANT, Class, Kind, MARKER_OPERAND, MARKER_TARGET, OUTPUT_OPERAND, Opcode, POPPED,
    REGISTER_OPERAND, TIMER_OPERAND, TIMER_TARGET, WORD_CONSTANT, holds_point,
};
use crate::{Millis, Target, TimerBlock};
use core::fmt;

/// An instruction of a checked program: its operands exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instruction<'c> {
    /// What it does.
    pub opcode: Opcode,
    /// What it works on: of the variant that the opcode's kind says.
    pub operand: Operand<'c>,
}

/// What an instruction works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operand<'c> {
    /// Nothing.
    None,
    /// XX of the code, as it is written.
    Number(u8),
    /// A timer block ([`Kind::Timer`]).
    Timer(TimerBlock),
    /// A register, a constant or what was pushed ([`Kind::Value`], [`Kind::Real`]).
    Value(Value),
    /// A counter and its preset ([`Kind::Count`]).
    Count {
        /// The counter, from 1.
        counter: u8,
        /// 0 to 2147483647.
        preset: i32,
    },
    /// A block of registers ([`Kind::Move`]).
    Move {
        /// The first register that is read, from 1.
        from: u8,
        /// The first that is written, from 1.
        to: u8,
        /// How many.
        count: u8,
    },
    /// A step table ([`Kind::Drum`]).
    Drum {
        /// The register that holds the step, from 1.
        register: u8,
        /// The outputs of each step, bit 0 output 01.
        steps: &'c [u8],
    },
    /// Ranges ([`Kind::Scale`]).
    Scale {
        /// The lower and the upper bound of what comes.
        from: [i16; 2],
        /// What the bounds become.
        to: [i16; 2],
    },
    /// A filter ([`Kind::Filter`]).
    Filter {
        /// 1–8: each sample counts one part in 2 to this power.
        strength: u8,
        /// ms from sample to sample, 0–30000.
        time: u16,
    },
    /// A table ([`Kind::Table`]).
    Table {
        /// Its first register, from 1.
        first: u8,
        /// How many registers it has, from 1.
        length: u8,
    },
    /// A jump ([`Kind::Jump`]).
    Jump {
        /// The label, from 1.
        label: u8,
        /// The line of the jump in its file; 65535 for that and all beyond.
        line: u16,
    },
}

/// Where an operation takes its operand from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value {
    /// A register, from 1.
    Register(u8),
    /// A constant; of a REAL operation the bits of a REAL number.
    Constant(i32),
    /// The value itself is the operand, and what was pushed becomes the value before (NC-22).
    Popped,
}

impl<'c> Instruction<'c> {
    /// The instruction at the head of these stored bytes, and how many of them are its own; none where
    /// no loader writes such bytes.
    pub(crate) fn from_stored(bytes: &'c [u8]) -> Option<(Instruction<'c>, usize)> {
        let (&first, mut rest) = bytes.split_first()?;
        let opcode = Opcode::of_stored(first)?;
        let kind = opcode.row().kind;
        let number = if holds_point(first) {
            (first & 0x0F) + 1
        } else if kind.has_number() {
            take::<1>(&mut rest)?[0]
        } else {
            0
        };
        let operand = match kind {
            Kind::None => Operand::None,
            Kind::Timer => Operand::Timer(TimerBlock {
                preset: Millis::from_le_bytes(take(&mut rest)?),
                target: Target::from_stored(take::<1>(&mut rest)?[0]),
            }),
            Kind::Count => Operand::Count {
                counter: number,
                preset: i32::from_le_bytes(take(&mut rest)?),
            },
            Kind::Value | Kind::Real => Operand::Value(match number {
                0 => Value::Constant(i32::from_le_bytes(take(&mut rest)?)),
                BYTE_CONSTANT => Value::Constant(i8::from_le_bytes(take(&mut rest)?).into()),
                WORD_CONSTANT => Value::Constant(i16::from_le_bytes(take(&mut rest)?).into()),
                POPPED => Value::Popped,
                register => Value::Register(register),
            }),
            Kind::Table => {
                let [length] = take(&mut rest)?;
                Operand::Table {
                    first: number,
                    length,
                }
            }
            Kind::Move => {
                let [to, count] = take(&mut rest)?;
                Operand::Move {
                    from: number,
                    to,
                    count,
                }
            }
            Kind::Drum => {
                let [count] = take(&mut rest)?;
                let (steps, behind) = rest.split_at_checked(count.into())?;
                rest = behind;
                Operand::Drum {
                    register: number,
                    steps,
                }
            }
            Kind::Scale => {
                let mut bound = || Some(i16::from_le_bytes(take(&mut rest)?));
                Operand::Scale {
                    from: [bound()?, bound()?],
                    to: [bound()?, bound()?],
                }
            }
            Kind::Filter => Operand::Filter {
                strength: number,
                time: u16::from_le_bytes(take(&mut rest)?),
            },
            Kind::Jump => Operand::Jump {
                label: number,
                line: u16::from_le_bytes(take(&mut rest)?),
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
        let size = bytes.len() - rest.len();
        Some((Instruction { opcode, operand }, size))
    }

    /// An instruction that has no operand but its XX.
    pub const fn numbered(opcode: Opcode, number: u8) -> Instruction<'static> {
        Instruction {
            opcode,
            operand: Operand::Number(number),
        }
    }

    /// An instruction that has no operand.
    pub const fn plain(opcode: Opcode) -> Instruction<'static> {
        Instruction {
            opcode,
            operand: Operand::None,
        }
    }

    /// The number that the code names, XX; none where it has none. A constant is 0.
    pub const fn number(self) -> Option<u8> {
        match self.operand {
            Operand::None | Operand::Timer(_) | Operand::Scale { .. } => None,
            Operand::Number(number) => Some(number),
            Operand::Value(Value::Register(register)) => Some(register),
            Operand::Value(Value::Constant(_)) => Some(0),
            Operand::Value(Value::Popped) => Some(POPPED),
            Operand::Table { first, .. } => Some(first),
            Operand::Count { counter, .. } => Some(counter),
            Operand::Move { from, .. } => Some(from),
            Operand::Drum { register, .. } => Some(register),
            Operand::Filter { strength, .. } => Some(strength),
            Operand::Jump { label, .. } => Some(label),
        }
    }

    /// The operands of a timer block.
    pub const fn timer(self) -> Option<TimerBlock> {
        match self.operand {
            Operand::Timer(block) => Some(block),
            _ => None,
        }
    }

    /// Whether it is a timer of its own, which has a number.
    pub const fn is_own_timer(self) -> bool {
        matches!(self.operand, Operand::Timer(block) if block.is_own())
    }

    /// The lines of a program file that say this instruction: its code, then its operands.
    pub fn codes(self) -> impl Iterator<Item = i32> + use<'c> {
        let row = self.opcode.row();
        let code = row.code + row.code.signum() * i32::from(self.number().unwrap_or(0));
        let (fixed, steps): ([Option<i32>; 4], &[u8]) = match self.operand {
            Operand::Timer(block) => {
                // A preset fits 31 bits (NC-9).
                let lines = [block.preset.cast_signed(), block.target.code()];
                ([Some(lines[0]), Some(lines[1]), None, None], &[])
            }
            Operand::Value(Value::Constant(number)) | Operand::Count { preset: number, .. } => {
                ([Some(number), None, None, None], &[])
            }
            Operand::Move { to, count, .. } => {
                let to = REGISTER_OPERAND + i32::from(to);
                ([Some(to), Some(count.into()), None, None], &[])
            }
            Operand::Drum { steps, .. } => ([Some(steps.len() as i32), None, None, None], steps),
            Operand::Scale { from, to } => {
                let line = |bound: i16| Some(i32::from(bound));
                (
                    [line(from[0]), line(from[1]), line(to[0]), line(to[1])],
                    &[],
                )
            }
            Operand::Filter { time, .. } => ([Some(time.into()), None, None, None], &[]),
            Operand::Table { length, .. } => ([Some(length.into()), None, None, None], &[]),
            Operand::None
            | Operand::Number(_)
            | Operand::Jump { .. }
            | Operand::Value(Value::Register(_) | Value::Popped) => ([None; 4], &[]),
        };
        let steps = steps.iter().map(|step| step_code(*step));
        core::iter::once(code)
            .chain(fixed.into_iter().flatten())
            .chain(steps)
    }
}

/// The next bytes.
fn take<const N: usize>(rest: &mut &[u8]) -> Option<[u8; N]> {
    let (taken, behind) = rest.split_first_chunk()?;
    *rest = behind;
    Some(*taken)
}

/// The line of a drum's step: a decimal digit for each output, that of output 01 first.
fn step_code(step: u8) -> i32 {
    (0..4).fold(0, |code, output| code * 10 + i32::from(step >> output & 1))
}

impl Target {
    /// The target that this stored byte tells.
    pub(crate) fn from_stored(byte: u8) -> Target {
        #[cfg(not(target_arch = "avr"))]
        if let Some(output) = super::far_output(byte) {
            return Target::Output(output + 1);
        }
        if byte >= TIMER_TARGET {
            return Target::Timer(byte - TIMER_TARGET + 1);
        }
        match byte.checked_sub(MARKER_TARGET) {
            Some(marker) => Target::Marker(marker + 1),
            None => Target::Output(byte.saturating_add(1)),
        }
    }

    /// The operand line that names it.
    pub fn code(self) -> i32 {
        match self {
            Target::Output(number) => OUTPUT_OPERAND + i32::from(number),
            Target::Marker(number) => MARKER_OPERAND + i32::from(number),
            Target::Timer(number) => TIMER_OPERAND + i32::from(number),
        }
    }
}

impl fmt::Display for Target {
    /// `O 04`, `M 12`, `T 03`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Target::Output(number) => write!(f, "O {number:02}"),
            Target::Marker(number) => write!(f, "M {number:02}"),
            Target::Timer(number) => write!(f, "T {number:02}"),
        }
    }
}

impl fmt::Display for Instruction<'_> {
    /// The letters and the operands: `RI 01`, `-RO 02`, `TON 500 ms O 01`, `ADD 12`, `ADD D 03`, `ADD popped`,
    /// `RAD 0.5`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.opcode.row().letters)?;
        match self.operand {
            Operand::None => Ok(()),
            Operand::Number(number) => write!(f, " {number:02}"),
            Operand::Timer(block) => write!(f, " {} ms {}", block.preset, block.target),
            Operand::Value(Value::Register(register)) => write!(f, " D {register:02}"),
            Operand::Value(Value::Constant(number)) if self.opcode.row().kind == Kind::Real => {
                write!(f, " {:?}", f32::from_bits(number.cast_unsigned()))
            }
            Operand::Value(Value::Constant(number)) => write!(f, " {number}"),
            Operand::Value(Value::Popped) => f.write_str(" popped"),
            Operand::Table { first, length } => write!(f, " {length} from D {first:02}"),
            Operand::Count { counter, preset } => write!(f, " {counter:02} {preset}"),
            Operand::Move { from, to, count } => {
                write!(f, " {count} from D {from:02} to D {to:02}")
            }
            Operand::Drum { register, steps } => {
                write!(f, " D {register:02}")?;
                steps
                    .iter()
                    .try_for_each(|step| write!(f, " {:04}", step_code(*step)))
            }
            Operand::Scale { from, to } => {
                write!(f, " {}..{} to {}..{}", from[0], from[1], to[0], to[1])
            }
            Operand::Filter { strength, time } => write!(f, " {strength:02} {time} ms"),
            Operand::Jump { label, .. } => write!(f, " {label:02}"),
        }
    }
}

impl Opcode {
    /// The part that the instruction plays in a rung.
    pub const fn class(self) -> Class {
        self.row().class
    }

    /// Whether the instruction opens a branch or block.
    pub const fn opens(self) -> bool {
        self.class().opens()
    }

    /// Whether the code is negative: where another has the same digits, this one is its opposite.
    pub const fn is_inverted(self) -> bool {
        self.row().code < 0
    }
}
