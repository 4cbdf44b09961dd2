//! The operand lines behind a code.

use super::{Expect, Loader};
use crate::Cause;
use crate::isa::{self, Kind, Line, MARKER_TARGET, xx};

/// The longest time of a filter, ms (NC-17).
const FILTER_TIME: i32 = 60_000;

impl Loader<'_> {
    /// Takes an operand line as the file has it.
    pub(super) fn operand_line(&mut self, line: Line, code: i32) -> Result<(), Cause> {
        let number = match line {
            Line::Target => xx(code, isa::OUTPUT_OPERAND)
                .map(|xx| i32::from(xx) - 1)
                .or_else(|| {
                    xx(code, isa::MARKER_OPERAND)
                        .map(|xx| i32::from(xx) - 1 + i32::from(MARKER_TARGET))
                }),
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
        let more = match line {
            // The room of all steps, taken at once.
            Line::Steps => self.room.reserve(bytes[0].into(), bytes[0].into()),
            Line::Target => self.room.reserve(0, line.more_run_bytes(bytes[0]).into()),
            _ => Ok(()),
        };
        for &byte in bytes.iter().take(line.bytes().into()) {
            self.room.put(byte);
        }
        more
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

    /// A timer drives this output.
    fn needs_output(&mut self, index: u8) -> Result<(), Cause> {
        self.needs.note(Kind::Output, index + 1)
    }

    fn check_line(&mut self, line: Line, number: i32) -> Result<(), Cause> {
        let before = |bytes: usize| self.room.before(bytes);
        let small = number as u8;
        let right = match line {
            Line::Constant => true,
            Line::TimerPreset | Line::CounterPreset => {
                return if number < 0 {
                    Err(Cause::BadPreset)
                } else {
                    Ok(())
                };
            }
            Line::Target => {
                let cause = if number < i32::from(MARKER_TARGET) {
                    if number >= 0 && number < self.profile.outputs.into() {
                        return self.needs_output(small);
                    }
                    Cause::NoSuchOutput
                } else {
                    Cause::NoSuchPoint
                };
                return if (i32::from(MARKER_TARGET)..i32::from(MARKER_TARGET + isa::MARKERS))
                    .contains(&number)
                {
                    Ok(())
                } else {
                    Err(cause)
                };
            }
            Line::MoveTo => number >= 1 && number <= isa::REGISTERS.into(),
            Line::MoveCount => {
                // From and to, each with so many registers from it on.
                let fits = |first: Option<u8>| {
                    first.is_none_or(|first| {
                        number <= i32::from(isa::REGISTERS) + 1 - i32::from(first)
                    })
                };
                number >= 1 && fits(before(1)) && fits(before(2))
            }
            Line::Steps => number >= 1 && number <= isa::REGISTERS.into(),
            Line::Step => (0..16).contains(&number),
            Line::FromHigh => {
                let low = match (before(2), before(1)) {
                    (Some(low), Some(high)) => i16::from_le_bytes([low, high]),
                    _ => i16::MIN,
                };
                number as i16 as i32 == number && number > low.into()
            }
            Line::FromLow | Line::ToLow | Line::ToHigh => number as i16 as i32 == number,
            Line::FilterTime => (0..=FILTER_TIME).contains(&number),
        };
        if right {
            Ok(())
        } else {
            Err(Cause::BadOperand)
        }
    }
}

/// The outputs of a drum's step: a digit, 0 or 1, for each of 01 02 03 04.
fn step(code: i32) -> Option<i32> {
    let mut rest = code;
    let mut step = 0;
    for (digit, bit) in [(1000, 1), (100, 2), (10, 4), (1, 8)] {
        if rest >= digit {
            rest -= digit;
            step |= bit;
        }
    }
    (rest == 0).then_some(step)
}
