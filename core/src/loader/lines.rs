//! The operand lines behind a code.

use super::{Expect, Loader};
use crate::isa::{self, Kind, Line, MARKER_TARGET, xx};
use crate::{Board, Cause};

/// The longest time of a filter, ms (NC-17).
const FILTER_TIME: i16 = 30_000;

impl<B: Board> Loader<'_, B> {
    /// Takes an operand line as the file has it.
    pub(super) fn operand_line(&mut self, line: Line, code: i32) -> Result<(), Cause> {
        let number = match line {
            Line::Target => target(code),
            Line::MoveTo => xx(code, isa::REGISTER_OPERAND).map(i32::from),
            Line::Step => step(code),
            _ => Some(code),
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

    /// Takes an operand line as it is stored.
    #[inline(never)]
    pub(super) fn stored_line(&mut self, line: Line, number: i32) -> Result<(), Cause> {
        if line == Line::Steps && number > 0 && number <= i32::from(isa::REGISTERS) {
            self.steps = number as u8;
        }
        self.expect = self.behind(line);
        self.check_line(line, number)?;
        let bytes = number.to_le_bytes();
        if line == Line::Constant && !self.restores {
            self.room.constant(isa::stored_constant(number))?;
        }
        let size = self.line_bytes(line);
        let more = match line {
            // The room of all steps, taken at once.
            Line::Steps => self.room.reserve(bytes[0].into(), bytes[0].into()),
            Line::Target => self.room.target(bytes[0]),
            _ => Ok(()),
        };
        for &byte in bytes.iter().take(size.into()) {
            self.room.put(byte);
        }
        more
    }

    /// How many bytes store this line; of a constant, what stands before it says.
    pub(super) fn line_bytes(&self, line: Line) -> u8 {
        match line {
            Line::Constant => isa::constant_bytes(self.room.before(1).unwrap_or(0)),
            _ => line.bytes(),
        }
    }

    /// What is expected behind a line.
    pub(super) fn behind(&mut self, line: Line) -> Expect {
        Expect::Line(match line {
            Line::TimerPreset => Line::Target,
            Line::MoveTo => Line::MoveCount,
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
            Line::MoveTo | Line::Steps => (1, isa::REGISTERS.into()),
            Line::MoveCount => {
                // From and to, each with so many registers from it on.
                let highest = self.room.before(1).max(self.room.before(2));
                // Behind a line that was refused, something else stands there.
                let highest = highest.filter(|&highest| highest <= isa::REGISTERS);
                (1, i16::from(isa::REGISTERS + 1 - highest.unwrap_or(1)))
            }
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
        if stored >= MARKER_TARGET {
            return if stored < MARKER_TARGET + isa::MARKERS {
                Ok(())
            } else {
                Err(Cause::NoSuchPoint)
            };
        }
        if stored < self.board.profile().outputs {
            self.needs.note(Kind::Output, stored + 1)
        } else {
            Err(Cause::NoSuchOutput)
        }
    }
}

/// What a timer drives, as it is stored. What does not exist stays so: it is told with its own cause.
fn target(code: i32) -> Option<i32> {
    let (xx, base) = match xx(code, isa::OUTPUT_OPERAND) {
        Some(xx) => (xx, 0),
        None => (xx(code, isa::MARKER_OPERAND)?, MARKER_TARGET),
    };
    let index = xx.wrapping_sub(1).min(MARKER_TARGET - 1 + base);
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
