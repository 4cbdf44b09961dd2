//! The operand lines after a code.

use super::{Expect, Loader};
use crate::isa::{self, Kind, Line, MARKER_TARGET, TIMER_TARGET, xx};
use crate::{Cause, Facts};

/// The longest time of a filter, ms (NC-17).
const FILTER_TIME: i16 = 30_000;
/// The most steps of a drum (NC-17).
const STEPS: i16 = 32;
const BEHIND_REGISTERS: i16 = isa::REGISTERS as i16 + 1;

impl<F: Facts> Loader<'_, F> {
    /// Takes an operand line as the file has it.
    pub(super) fn operand_line(&mut self, line: Line, code: i32) -> Result<(), Cause> {
        let number = match line {
            Line::Target => target(code),
            Line::MoveTo => xx(code, isa::REGISTER_OPERAND).map(i32::from),
            Line::Step => step(code),
            _ => Some(code),
        };
        #[cfg(not(target_arch = "avr"))]
        if line == Line::Target && code == isa::OUTPUT_OPERAND && self.has_far_targets() {
            self.expect = self.behind(line);
            return Err(Cause::NoSuchOutput);
        }
        #[cfg(not(target_arch = "avr"))]
        let number = match xx(code, isa::OUTPUT_OPERAND) {
            Some(output) if line == Line::Target && self.has_far_targets() => {
                Some(isa::stored_target(output).into())
            }
            _ => number,
        };
        match number {
            Some(number) => self.stored_line(line, number),
            None => {
                self.expect = self.behind(line);
                Err(match line {
                    Line::Target => Cause::BadTimerOutput,
                    _ => Cause::BadOperand,
                })
            }
        }
    }

    /// Whether a timer may drive outputs whose index is no stored byte of an output.
    #[cfg(not(target_arch = "avr"))]
    fn has_far_targets(&self) -> bool {
        self.facts.board().outputs > MARKER_TARGET
    }

    /// The index of the output above 64 that a timer's stored target names.
    #[cfg(not(target_arch = "avr"))]
    fn far_output(&self, stored: u8) -> Option<u8> {
        isa::far_output(stored).filter(|_| self.has_far_targets())
    }

    /// Takes an operand line as it is stored.
    #[inline(never)]
    pub(super) fn stored_line(&mut self, line: Line, number: i32) -> Result<(), Cause> {
        let checked = self.check_line(line, number);
        if line == Line::Steps && checked.is_ok() {
            self.steps = number as u8;
        }
        self.expect = self.behind(line);
        checked?;
        let bytes = number.to_le_bytes();
        if matches!(line, Line::Constant | Line::Real) && !self.restores {
            self.room.constant(isa::stored_constant(number))?;
        }
        let size = self.line_bytes(line);
        let more = match line {
            // The room of all steps, taken at once.
            Line::Steps => self.room.reserve(bytes[0], self.room.linked_only(bytes[0])),
            Line::Target => self.room.target(bytes[0]),
            Line::Count => {
                let last = self.highest() as u8 + bytes[0] - 1;
                self.room.register(last);
                self.room.reserve(0, 0)
            }
            _ => Ok(()),
        };
        for &byte in bytes.iter().take(size.into()) {
            self.room.put(byte);
        }
        more
    }

    /// How many bytes store this line.
    pub(super) fn line_bytes(&self, line: Line) -> u8 {
        match line {
            Line::Constant | Line::Real => isa::constant_bytes(self.room.before(1).unwrap_or(0)),
            _ => line.bytes(),
        }
    }

    /// The higher of the registers from which so many are counted: one, or after the first of a move another.
    fn highest(&self) -> i16 {
        self.register_before(1).max(self.register_before(2)).into()
    }

    /// The register that was stored so many bytes ago. The code of an instruction is no register's number.
    fn register_before(&self, ago: usize) -> u8 {
        match self.room.before(ago) {
            Some(register) if register <= isa::REGISTERS => register,
            _ => 0,
        }
    }

    /// What is expected behind a line.
    pub(super) fn behind(&mut self, line: Line) -> Expect {
        Expect::Line(match line {
            Line::TimerPreset => Line::Target,
            Line::MoveTo => Line::Count,
            Line::FromLow => Line::FromHigh,
            Line::FromHigh => Line::ToLow,
            Line::ToLow => Line::ToHigh,
            Line::Steps if self.steps > 0 => Line::Step,
            Line::Step if self.steps > 1 => {
                self.steps -= 1;
                Line::Step
            }
            _ => {
                self.steps = 0;
                return Expect::Instruction;
            }
        })
    }

    fn check_line(&mut self, line: Line, number: i32) -> Result<(), Cause> {
        match line {
            Line::Constant => return Ok(()),
            Line::Real => {
                // The exponent of what is none, or not finite, is all ones.
                let [.., low, high] = number.to_le_bytes();
                return if low & 0x80 != 0 && high & 0x7F == 0x7F {
                    Err(Cause::NotReal)
                } else {
                    Ok(())
                };
            }
            Line::TimerPreset | Line::CounterPreset => {
                return if number < 0 {
                    Err(Cause::BadPreset)
                } else {
                    Ok(())
                };
            }
            _ => {}
        }
        // All others fit 16 bits, and are compared so.
        let small = number as i16;
        let (least, most) = match line {
            Line::Target => return self.check_target(small as u8),
            Line::MoveTo => (1, isa::REGISTERS.into()),
            Line::Steps => (1, STEPS),
            // So many registers from each that stands before it on.
            Line::Count => (1, BEHIND_REGISTERS - self.highest()),
            Line::Step => (0, 15),
            Line::FromHigh => match (self.room.before(2), self.room.before(1)) {
                // Nothing is above the highest number.
                (Some(low), Some(high)) => match i16::from_le_bytes([low, high]).checked_add(1) {
                    Some(least) => (least, i16::MAX),
                    None => (1, 0),
                },
                _ => (i16::MIN, i16::MAX),
            },
            Line::FilterTime => (0, FILTER_TIME),
            _ => (i16::MIN, i16::MAX),
        };
        if i32::from(small) == number && small >= least && small <= most {
            Ok(())
        } else {
            Err(Cause::BadOperand)
        }
    }

    /// What a timer drives exists.
    fn check_target(&mut self, stored: u8) -> Result<(), Cause> {
        #[cfg(not(target_arch = "avr"))]
        if let Some(index) = self.far_output(stored) {
            return match index < self.facts.board().outputs {
                true => self.needs.note(self.room.held, Kind::Output, index + 1),
                false => Err(Cause::NoSuchOutput),
            };
        }
        if stored >= TIMER_TARGET {
            return Ok(()); // The room knows the timers before.
        }
        if stored >= MARKER_TARGET {
            return if stored < MARKER_TARGET + self.facts.board().markers {
                Ok(())
            } else {
                Err(Cause::NoSuchPoint)
            };
        }
        if stored < self.facts.board().outputs {
            self.needs.note(self.room.held, Kind::Output, stored + 1)
        } else {
            Err(Cause::NoSuchOutput)
        }
    }
}

/// What a timer drives, as it is stored. What does not exist stays so: it is told with its own cause.
fn target(code: i32) -> Option<i32> {
    let (xx, base, last) = match (xx(code, isa::OUTPUT_OPERAND), xx(code, isa::MARKER_OPERAND)) {
        (Some(xx), _) => (xx, 0, MARKER_TARGET - 1),
        (_, Some(xx)) => (xx, MARKER_TARGET, 2 * MARKER_TARGET - 1),
        _ => (
            xx(code, isa::TIMER_OPERAND)?,
            TIMER_TARGET,
            isa::CALLED_AGAIN,
        ),
    };
    let index = xx.wrapping_sub(1).min(last);
    Some(i32::from(base + index))
}

/// The outputs of a drum's step: a digit, 0 or 1, for each of 01 02 03 04.
fn step(code: i32) -> Option<i32> {
    let mut rest = code;
    let mut step = 0;
    let mut digit = 1000;
    let mut bit = 1;
    while bit < 16 {
        if rest >= digit {
            rest -= digit;
            step |= bit;
        }
        bit <<= 1;
        digit = match digit {
            1000 => 100,
            100 => 10,
            _ => 1,
        };
    }
    (rest == 0).then_some(step)
}
