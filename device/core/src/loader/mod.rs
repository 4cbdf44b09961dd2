//! From the bytes of a file to a checked program: every check of NC-1 … NC-28.
//!
//! Owns the order of codes and the limits of their numbers; must not know where the bytes come from.
//! `lines` takes the operand lines, `room` what a program takes of memory, `labels` where jumps lead.

mod labels;
mod lines;
mod room;

use crate::isa::{self, By, Entry, Kind, Line, Opcode};
use crate::kept;
use crate::needs::Needs;
use crate::rung::Rung;
use crate::text::{Part, Text};
use crate::{Board, Cause, Facts, Fault, Point, Program};
use core::mem;
use labels::Labels;
use room::Room;

/// What the next code of the file must be.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Expect {
    /// Program start.
    Start,
    /// Any instruction.
    Instruction,
    /// Any instruction, at the head of a rung.
    Head,
    /// Any instruction; a branch point would be recalled, since a branch has just been opened.
    Branch,
    /// An operand line.
    Line(Line),
}

/// Takes the bytes of a program file one at a time and checks all of it before anything runs.
///
/// Each call reports at most one fault. After a fault the loader goes on, so that a tool can show
/// the other faults that can be told; but [`finish`](Loader::finish) then gives no program.
// In this order, what is used most is reached by a short way on AVR, which has 64 bytes of it.
#[repr(C)]
pub struct Loader<'m, F = Board> {
    expect: Expect,
    /// The line of the next byte, from 1.
    line: u32,
    /// The line of the last code that lines must follow.
    block: u32,
    codes: u16,
    /// The highest timer that is named, and the line of the first code that names it.
    timer: u8,
    timer_line: u32,
    /// Steps of a drum that are still to come.
    steps: u8,
    /// How many IFs are open, and of which the ELS has come: the innermost in the lowest bit (NC-28).
    ifs: u8,
    elses: u8,
    /// Whether constants keep the size that they are stored in.
    restores: bool,
    room: Room<'m>,
    text: Text,
    labels: Labels,
    needs: Needs,
    first_fault: Option<Fault>,
    rung: Rung,
    facts: F,
}

impl<'m, F: Facts> Loader<'m, F> {
    /// A loader into this run memory for this board. Where the memory is smaller than the board's
    /// `linked_bytes`, the memory decides what fits. After the board's `stored_bytes` it notes which IFs are open and of which
    /// kind each timer is: where the memory ends before, no timer is called again (fault 29).
    // Loaders stand in large frames, whose far end AVR reaches only by detours: what fills and uses
    // one goes by its address.
    #[inline(never)]
    pub fn new(memory: &'m mut [u8], facts: F) -> Loader<'m, F> {
        let room = Room::new(memory, facts.board());
        Loader {
            text: Text::new(),
            rung: Rung::new(),
            expect: Expect::Start,
            line: 1,
            block: 0,
            first_fault: None,
            facts,
            room,
            labels: Labels::default(),
            needs: Needs::default(),
            timer: 0,
            timer_line: 0,
            steps: 0,
            codes: 0,
            ifs: 0,
            elses: 0,
            restores: false,
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
    pub fn restore(&mut self, stored: &mut impl Iterator<Item = u8>) -> Result<(), Fault> {
        self.expect = Expect::Head;
        self.codes = 1;
        self.restores = true;
        let mut checked = Ok(());
        while let (Ok(()), Some(byte)) = (checked, stored.next()) {
            checked = self.stored_instruction(byte, stored);
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
                Expect::Line(_) => Err(Cause::OperandsMissing),
                _ => self.rung.end(),
            };
        }
        if checked.is_ok() && self.ifs > 0 {
            self.ifs -= 1;
            checked = Err(Cause::IfLeftOpen);
        }
        if checked.is_ok() {
            checked = self.references();
        }
        self.report(checked)
    }

    /// The checked program, or the first fault of the file.
    ///
    /// The loader is used up: a second call gives an empty program. (It is lent and not given
    /// away, because giving it away would cost a copy on a stack that has no room for one.)
    #[inline(never)]
    pub fn finish(&mut self) -> Result<Program<'m>, Fault> {
        while self.end().is_err() {}
        match self.first_fault {
            Some(fault) => Err(fault),
            None => Ok(self.room.program(self.codes, self.needs)),
        }
    }

    /// What the byte taken last belongs to, for a tool that shows where the codes of a file stand.
    pub fn part(&self) -> Part {
        self.text.part()
    }

    /// How many codes have come so far, counted as [`Program::codes`] counts them: where a line makes it
    /// more, that line began an instruction; other codes are operands of the one before.
    pub fn codes(&self) -> u16 {
        self.codes
    }

    /// Bytes of program memory and of run memory that the codes so far would need beyond what there is; what is kept
    /// takes program memory too (NC-21).
    pub fn lacking(&self) -> [usize; 2] {
        self.room.lacking()
    }

    /// Checks what the text gave.
    fn take(&mut self, read: Result<bool, Cause>) -> Result<(), Cause> {
        match read {
            Ok(false) => Ok(()),
            Ok(true) => self.code(self.text.code()),
            Err(cause) => {
                // The line was meant to be what was expected: do not take the next one for it.
                self.expect = match self.expect {
                    Expect::Line(line) => self.behind(line),
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
            Cause::BranchLeftOpen => Some(self.line_before(self.rung.left_open())),
            Cause::IfLeftOpen => {
                let low = self.room.noted(self.ifs);
                Some(self.line_before(low))
            }
            Cause::OperandsMissing => Some(self.block),
            // At the end of the file; a timer 00 is told where it stands.
            Cause::NoSuchTimer if self.timer == 0 && self.timer_line > 0 => Some(self.timer_line),
            Cause::NoSuchLabel => Some(self.labels.missing_line().into()),
            _ => Some(self.line),
        };
        let fault = Fault { cause, line };
        self.first_fault.get_or_insert(fault);
        Err(fault)
    }

    /// The last line up to this one whose number has this low half.
    fn line_before(&self, low: u16) -> u32 {
        let ago = (self.line as u16).wrapping_sub(low);
        self.line.wrapping_sub(ago.into())
    }

    fn code(&mut self, code: i32) -> Result<(), Cause> {
        let expected = mem::replace(&mut self.expect, Expect::Instruction);
        match expected {
            Expect::Start if code == isa::START => {
                self.expect = Expect::Head;
                self.codes = 1;
                Ok(())
            }
            Expect::Start => {
                // The code may still open a branch or begin a block: follow it, but tell only
                // what is missing.
                let _ = self.instruction(code, Expect::Head);
                Err(Cause::NoStart)
            }
            Expect::Line(line) => self.operand_line(line, code),
            _ => self.instruction(code, expected),
        }
    }

    fn instruction(&mut self, code: i32, expected: Expect) -> Result<(), Cause> {
        if code == isa::START {
            return Err(Cause::SecondStart);
        }
        let (entry, xx) = isa::find(&self.facts, By::Code(code)).ok_or(Cause::UnknownCode)?;
        let line = u16::try_from(self.line).unwrap_or(u16::MAX);
        let xx = match xx {
            // As it is stored, until its line tells more.
            0 if entry.kind.is_value() => isa::BYTE_CONSTANT,
            _ => xx,
        };
        self.checked(entry, xx, expected, line)
    }

    fn stored_instruction(
        &mut self,
        byte: u8,
        rest: &mut impl Iterator<Item = u8>,
    ) -> Result<(), Cause> {
        let expected = mem::replace(&mut self.expect, Expect::Instruction);
        let (entry, _) = isa::find(&self.facts, By::Stored(byte)).ok_or(Cause::UnknownCode)?;
        let mut next = || rest.next().ok_or(Cause::OperandsMissing);
        let xx = if isa::holds_point(byte) {
            (byte & 0x0F) + 1
        } else if entry.kind.has_number() {
            next()?
        } else {
            0
        };
        #[cfg(any(not(target_arch = "avr"), mega))]
        if isa::is_far(byte) && (xx <= isa::POINTS || !self.has_far_points()) {
            // What has fewer points knows the byte as that of a branch point.
            return Err(Cause::NoSuchBranchPoint);
        }
        let line = if entry.kind == Kind::Jump {
            u16::from_le_bytes([next()?, next()?])
        } else {
            0
        };
        self.checked(entry, xx, expected, line)?;
        while let Expect::Line(line) = self.expect {
            let mut bytes = [0; 4];
            let size = self.line_bytes(line);
            for place in bytes.iter_mut().take(size.into()) {
                *place = next()?;
            }
            let number = match (size, line, bytes) {
                (2, _, [low, high, ..]) => i16::from_le_bytes([low, high]).into(),
                (1, Line::Constant, [low, ..]) => low.cast_signed().into(),
                _ => i32::from_le_bytes(bytes),
            };
            self.stored_line(line, number)?;
        }
        Ok(())
    }

    /// Whether the board has points that no byte of their row holds.
    #[cfg(any(not(target_arch = "avr"), mega))]
    fn has_far_points(&self) -> bool {
        let board = self.facts.board();
        board.inputs.max(board.outputs) > isa::POINTS
    }

    /// Checks an instruction with its XX, and stores it.
    #[inline(never)]
    fn checked(&mut self, entry: Entry, xx: u8, expected: Expect, line: u16) -> Result<(), Cause> {
        self.codes = self.codes.wrapping_add(1);
        let kind = entry.kind;
        let mut stored = entry.stored;
        if let Some(line) = entry.line
            && (!kind.is_value() || isa::constant_bytes(xx) > 0)
        {
            self.block = self.line;
            self.expect = Expect::Line(line);
        }
        let mut last = entry.last;
        if kind == Kind::Input {
            last = self.facts.board().inputs;
        }
        if kind == Kind::Output {
            last = self.facts.board().outputs;
        }
        if xx < entry.first || xx > last {
            return Err(no_such(kind));
        }
        if !self.facts.board().real && isa::is_real(stored) {
            return Err(Cause::UnknownCode);
        }
        self.needs.note(self.room.held, kind, xx)?;
        if kind.is_value() && xx == isa::POPPED || stored == Opcode::StoreTable as u8 {
            self.rung.pop()?;
        }
        if kept::declares(stored) {
            self.room.keep()?;
            self.expect = Expect::Head;
        }
        // A match that tells all kinds apart would take more of the firmware.
        if kind == Kind::None {
            self.balance(stored)?;
        } else if kind == Kind::Branch {
            // It exists: the numbers have been checked.
            let point = Point::new(xx, isa::BRANCH_POINTS).ok_or(Cause::NoSuchBranchPoint)?;
            stored = if expected == Expect::Branch {
                self.rung.recall(point)?;
                Opcode::RecallBranch as u8
            } else {
                self.rung.store(point);
                Opcode::StoreBranch as u8
            };
        } else if kind == Kind::TimerQ {
            if xx > self.timer {
                self.timer = xx;
                self.timer_line = self.line;
            }
        } else if kind == Kind::Label {
            if expected != Expect::Head {
                return Err(Cause::LabelInRung);
            }
            self.expect = Expect::Head;
            self.labels.define(xx)?;
        } else if kind == Kind::Jump {
            if self.rung.is_open() {
                return Err(Cause::JumpInBranch);
            }
            self.labels.jump();
        }
        let entry = Entry { stored, ..entry };
        self.room.instruction(&entry, xx, line)
    }

    /// Checks that rungs and branches are balanced (NC-8).
    fn balance(&mut self, stored: u8) -> Result<(), Cause> {
        // By their bytes: a match of opcodes would first tell all of them apart.
        if stored == Opcode::OpenBranch as u8
            || stored == Opcode::OpenAnd as u8
            || stored == Opcode::OpenXor as u8
        {
            self.expect = Expect::Branch;
            return self.rung.open(self.line);
        }
        if stored == Opcode::CloseBranch as u8 {
            return self.rung.close();
        }
        if stored == Opcode::NewRung as u8 {
            self.expect = Expect::Head;
            return self.rung.end();
        }
        if stored == Opcode::Push as u8 {
            return self.rung.push();
        }
        let brackets = stored >= Opcode::If as u8;
        let returns = stored == Opcode::Return as u8 || stored == Opcode::ReturnNot as u8;
        if (brackets || returns) && self.rung.is_open() {
            return Err(Cause::JumpInBranch);
        }
        if brackets {
            self.bracket(stored)?;
        }
        Ok(())
    }

    /// Checks that IF, ELS and END are balanced (NC-28). What stands before is a rung, and a rung begins.
    #[inline(never)]
    fn bracket(&mut self, stored: u8) -> Result<(), Cause> {
        self.expect = Expect::Head;
        self.rung.end()?;
        if stored == Opcode::If as u8 {
            self.room.note(self.ifs, self.line as u16);
            // Counted also where it is too deep, so that its END is not one too many.
            self.ifs = self.ifs.wrapping_add(1);
            self.elses <<= 1;
            return if self.ifs > isa::DEEPEST {
                Err(Cause::IfTooDeep)
            } else {
                Ok(())
            };
        }
        if self.ifs == 0 {
            return Err(Cause::NoIf);
        }
        if stored == Opcode::Else as u8 {
            let first = self.elses & 1 == 0;
            self.elses |= 1;
            return if first { Ok(()) } else { Err(Cause::NoIf) };
        }
        self.ifs -= 1;
        self.elses >>= 1;
        Ok(())
    }

    /// What is named before it can be known: timers and labels.
    fn references(&mut self) -> Result<(), Cause> {
        if mem::take(&mut self.timer) > self.room.timers() {
            return Err(Cause::NoSuchTimer);
        }
        self.labels.check_jumps(&self.facts, self.room.stored())
    }
}

/// What is told of a number that this kind does not have.
fn no_such(kind: Kind) -> Cause {
    if kind == Kind::Input {
        Cause::NoSuchInput
    } else if kind == Kind::Output {
        Cause::NoSuchOutput
    } else if kind == Kind::Branch {
        Cause::NoSuchBranchPoint
    } else if kind == Kind::TimerQ {
        Cause::NoSuchTimer
    } else {
        Cause::NoSuchPoint
    }
}
