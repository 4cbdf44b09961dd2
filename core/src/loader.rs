//! From the bytes of a file to a checked program: every check of NC-1 … NC-11.
//!
//! Owns the order of codes, the limits of operands, and memory; must not know where the bytes
//! come from.

use crate::isa::{self, Opcode, Operand};
use crate::rung::Rung;
use crate::text::Text;
use crate::{Cause, Fault, Point, Profile, Program};
use core::mem;

/// What the next code of the file must be.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Expect {
    /// Program start.
    Start,
    /// Any instruction.
    Instruction,
    /// Any instruction; a branch point would be recalled, since a branch has just been opened.
    Branch,
    /// The preset of a timer block.
    Preset,
    /// The output of a timer block.
    TimerOutput,
}

/// Takes the bytes of a program file one at a time and checks all of it before anything runs.
///
/// Each call reports at most one fault. After a fault the loader goes on, so that a tool can show
/// the other faults that can be told; but [`finish`](Loader::finish) then gives no program.
pub struct Loader<'m> {
    text: Text,
    rung: Rung,
    expect: Expect,
    /// The line of the next byte, from 1.
    line: u32,
    /// The line of the last timer block.
    block: u32,
    first_fault: Option<Fault>,
    profile: Profile,
    memory: &'m mut [u8],
    code_bytes: usize,
    timers: usize,
    codes: u16,
    /// Whether a code did not fit; what follows is checked, and no longer stored.
    full: bool,
}

impl<'m> Loader<'m> {
    /// A loader into this run memory for this board. Where the memory is smaller than the
    /// profile's `linked_bytes`, the memory decides what fits.
    // Loaders stand in large frames, whose far end AVR reaches only by detours: what fills and uses
    // one goes by its address.
    #[inline(never)]
    pub fn new(memory: &'m mut [u8], profile: Profile) -> Loader<'m> {
        Loader {
            text: Text::new(),
            rung: Rung::new(),
            expect: Expect::Start,
            line: 1,
            block: 0,
            first_fault: None,
            profile,
            memory,
            code_bytes: 0,
            timers: 0,
            codes: 0,
            full: false,
        }
    }

    /// Takes the next byte of the file.
    #[inline(never)]
    pub fn push(&mut self, byte: u8) -> Result<(), Fault> {
        let read = self.text.push(byte);
        let checked = self.take(read);
        let result = self.report(checked);
        if byte == b'\n' {
            self.line = self.line.wrapping_add(1);
        }
        result
    }

    /// Takes a program in its stored form in place of a file, with the same checks: memory that
    /// keeps a program for years is a claim too. Then [`finish`](Loader::finish).
    #[inline(never)]
    pub fn restore(&mut self, stored: impl IntoIterator<Item = u8>) -> Result<(), Fault> {
        self.expect = Expect::Instruction;
        self.codes = 1;
        let mut stored = stored.into_iter();
        let mut checked = Ok(());
        while let (Ok(()), Some(byte)) = (checked, stored.next()) {
            checked = self.stored_instruction(byte, &mut stored);
        }
        self.report(checked)
    }

    /// Tells that the file has ended. Each call reports one more of the faults that show only
    /// then, until there is none.
    pub fn end(&mut self) -> Result<(), Fault> {
        let read = self.text.end();
        let mut checked = self.take(read);
        if checked.is_ok() {
            checked = match mem::replace(&mut self.expect, Expect::Instruction) {
                Expect::Start => Err(Cause::EmptyFile),
                Expect::Preset | Expect::TimerOutput => Err(Cause::OperandsMissing),
                Expect::Instruction | Expect::Branch => self.rung.end(),
            };
        }
        self.report(checked)
    }

    /// The checked program, or the first fault of the file.
    ///
    /// The loader is used up: a second call gives an empty program. (It is lent and not given
    /// away, because giving it away would cost a copy on a stack that has no room for one.)
    pub fn finish(&mut self) -> Result<Program<'m>, Fault> {
        while self.end().is_err() {}
        match self.first_fault {
            Some(fault) => Err(fault),
            None => Ok(Program {
                memory: mem::take(&mut self.memory),
                code_bytes: mem::take(&mut self.code_bytes),
                timers: mem::take(&mut self.timers),
                codes: mem::take(&mut self.codes),
            }),
        }
    }

    /// Checks what the text gave.
    fn take(&mut self, read: Result<bool, Cause>) -> Result<(), Cause> {
        match read {
            Ok(false) => Ok(()),
            Ok(true) => self.code(self.text.code()),
            Err(cause) => {
                // The line was meant to be what was expected: do not take the next one for it.
                self.expect = match self.expect {
                    Expect::Preset => Expect::TimerOutput,
                    _ => Expect::Instruction,
                };
                Err(cause)
            }
        }
    }

    /// Gives a fault its line, and remembers the first.
    fn report(&mut self, checked: Result<(), Cause>) -> Result<(), Fault> {
        let Err(cause) = checked else { return Ok(()) };
        let line = match cause {
            Cause::EmptyFile => None,
            Cause::BranchLeftOpen => Some(self.rung.left_open()),
            Cause::OperandsMissing => Some(self.block),
            _ => Some(self.line),
        };
        let fault = Fault { cause, line };
        self.first_fault.get_or_insert(fault);
        Err(fault)
    }

    fn code(&mut self, code: i32) -> Result<(), Cause> {
        let expected = mem::replace(&mut self.expect, Expect::Instruction);
        match expected {
            Expect::Start if code == isa::START => {
                self.codes = 1;
                Ok(())
            }
            Expect::Start => {
                // The code may still open a branch or begin a block: follow it, but tell only
                // what is missing.
                let _ = self.instruction(code, expected);
                Err(Cause::NoStart)
            }
            Expect::Instruction | Expect::Branch => self.instruction(code, expected),
            Expect::Preset => self.preset(code),
            Expect::TimerOutput => {
                let xx = isa::xx(code, isa::OUTPUT_OPERAND).ok_or(Cause::BadTimerOutput)?;
                self.timer_output(xx)
            }
        }
    }

    fn instruction(&mut self, code: i32, expected: Expect) -> Result<(), Cause> {
        if code == isa::START {
            return Err(Cause::SecondStart);
        }
        let (opcode, xx) = Opcode::decode(code).ok_or(Cause::UnknownCode)?;
        self.checked(opcode, xx, expected)
    }

    fn stored_instruction(
        &mut self,
        byte: u8,
        rest: &mut impl Iterator<Item = u8>,
    ) -> Result<(), Cause> {
        let expected = mem::replace(&mut self.expect, Expect::Instruction);
        let opcode = Opcode::of_stored(byte).ok_or(Cause::UnknownCode)?;
        self.checked(opcode, (byte & 0x0F) + 1, expected)?;
        if self.expect == Expect::Preset {
            let mut preset = [0; 4];
            for byte in &mut preset {
                *byte = rest.next().ok_or(Cause::OperandsMissing)?;
            }
            self.preset(i32::from_le_bytes(preset))?;
            let output = rest.next().ok_or(Cause::OperandsMissing)?;
            self.timer_output(output.saturating_add(1))?;
        }
        Ok(())
    }

    /// Checks an instruction with its XX, and stores it.
    fn checked(&mut self, opcode: Opcode, xx: u8, expected: Expect) -> Result<(), Cause> {
        self.codes = self.codes.saturating_add(1);
        let (count, cause) = match opcode.operand() {
            Operand::None => {
                self.balance(opcode)?;
                return self.store(opcode as u8, false);
            }
            Operand::Timer => {
                self.expect = Expect::Preset;
                self.block = self.line;
                return self.store(opcode as u8, true);
            }
            Operand::Input => (self.profile.inputs, Cause::NoSuchInput),
            Operand::Output => (self.profile.outputs, Cause::NoSuchOutput),
            Operand::Branch => (isa::BRANCH_POINTS, Cause::NoSuchBranchPoint),
        };
        let point = Point::new(xx, count).ok_or(cause)?;
        let opcode = match opcode {
            Opcode::StoreBranch | Opcode::RecallBranch if expected == Expect::Branch => {
                self.rung.recall(point)?;
                Opcode::RecallBranch
            }
            Opcode::StoreBranch | Opcode::RecallBranch => {
                self.rung.store(point);
                Opcode::StoreBranch
            }
            _ => opcode,
        };
        self.store(opcode as u8 | point.index(), false)
    }

    /// Checks that rungs and branches are balanced (NC-8).
    fn balance(&mut self, opcode: Opcode) -> Result<(), Cause> {
        match opcode {
            Opcode::OpenBranch => {
                self.expect = Expect::Branch;
                self.rung.open(self.line)
            }
            Opcode::CloseBranch => self.rung.close(),
            _ => self.rung.end(),
        }
    }

    fn preset(&mut self, code: i32) -> Result<(), Cause> {
        self.expect = Expect::TimerOutput;
        if code < 0 {
            return Err(Cause::BadPreset);
        }
        for &byte in &code.to_le_bytes() {
            self.put(byte);
        }
        Ok(())
    }

    fn timer_output(&mut self, xx: u8) -> Result<(), Cause> {
        self.expect = Expect::Instruction;
        let output = Point::new(xx, self.profile.outputs).ok_or(Cause::NoSuchOutput)?;
        self.put(output.index());
        Ok(())
    }

    /// Stores the first byte of an instruction; for a timer block, also reserves its other bytes and
    /// the timer.
    fn store(&mut self, byte: u8, timer: bool) -> Result<(), Cause> {
        if self.full {
            return Ok(());
        }
        let bytes = if timer { isa::STORED_TIMER_BYTES } else { 1 };
        let code_bytes = self.code_bytes + bytes;
        let timers = self.timers + usize::from(timer);
        let run_memory = self.memory.len().min(self.profile.linked_bytes.into());
        self.full = true;
        if code_bytes > self.profile.stored_bytes.into() {
            return Err(Cause::ProgramFull);
        }
        if Profile::linked_size(code_bytes, timers) > run_memory {
            return Err(Cause::RunMemoryFull);
        }
        self.full = false;
        self.timers = timers;
        self.put(byte);
        Ok(())
    }

    /// Puts a byte where room has been reserved for it.
    fn put(&mut self, byte: u8) {
        if self.full {
            return;
        }
        if let Some(place) = self.memory.get_mut(self.code_bytes) {
            *place = byte;
            self.code_bytes += 1;
        }
    }
}
