//! The scan: one pass through the program.

use super::{Inputs, Plc};
use crate::isa::{Class, JUMP_BUDGET, Opcode};
use crate::width::ANALOGUE;
use crate::{Cause, Fault, Image, Millis, Needs, Steps};

/// What an instruction leaves behind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct After {
    /// The result of the rung so far (NC-6).
    pub acc: bool,
    /// The value accumulator (NC-16).
    pub value: i32,
}

/// What lives as long as one scan.
pub(super) struct Pass<'c> {
    pub(super) steps: Steps<'c>,
    pub(super) now: Millis,
    pub(super) analogue: [u16; ANALOGUE as usize],
    pub(super) scan_time: u16,
    /// The result of the rung so far (NC-6).
    pub(super) acc: bool,
    /// The value accumulator (NC-16).
    pub(super) value: i32,
    /// What is pushed (NC-22), the last first. Eight are enough, because the loader allows no more.
    pub(super) pushed: [i32; 8],
    /// One bit for each open branch, the innermost in bit 0: acc as it was when the branch opened. Eight
    /// are enough, because the loader allows no deeper nesting.
    pub(super) open: u8,
    /// How each of them is closed: the opcode that has opened it.
    pub(super) opened: [Opcode; 8],
    /// One bit for each branch point of the rung.
    pub(super) points: u8,
    /// Timers that have been passed, and bytes of own data.
    pub(super) timers: u8,
    pub(super) own: usize,
    /// What is left for jumps back (NC-19).
    pub(super) budget: usize,
    /// S 04: an arithmetic error in this scan.
    pub(super) error: bool,
}

impl Plc<'_> {
    /// One scan (NC-5): runs the program once on these inputs with this time stamp, and gives the
    /// output image.
    ///
    /// # Errors
    /// [`Cause::TooManyJumps`] with the line of the jump, the one thing that no check can know before
    /// (NC-19). All outputs are 0 then.
    pub fn scan(&mut self, inputs: impl Into<Inputs>, now: Millis) -> Result<Image, Fault> {
        self.scan_observed(inputs, now, |_, _| ())
    }

    /// A scan that tells an observer the index of each instruction that was run, in the order of
    /// [`Plc::steps`], and what it has left behind.
    ///
    /// # Errors
    /// As [`Plc::scan`].
    pub fn scan_observed(
        &mut self,
        inputs: impl Into<Inputs>,
        now: Millis,
        mut observe: impl FnMut(usize, After),
    ) -> Result<Image, Fault> {
        let inputs = inputs.into();
        let first = self.state.first;
        let Needs { filter, .. } = self.needs;
        let points = Image(inputs.points.0 & self.needs.digital(&self.board));
        self.state.inputs.scan(points, filter, first, now);
        self.state.clocks.scan(first, now);
        let code = self.code;
        let mut pass = Pass {
            steps: Steps::new(code),
            now,
            analogue: inputs.analogue,
            scan_time: inputs.scan_time,
            acc: true,
            value: 0,
            pushed: [0; 8],
            open: 0,
            opened: [Opcode::OpenBranch; 8],
            points: 0,
            timers: 0,
            own: 0,
            budget: JUMP_BUDGET.into(),
            error: false,
        };
        let mut index = 0;
        while let Some(instruction) = pass.steps.next() {
            let step = index;
            index += 1;
            match self.run(&mut pass, instruction) {
                Next::Step => {
                    pass.pass_over(instruction.opcode);
                    observe(step, pass.after());
                }
                Next::End => {
                    observe(step, pass.after());
                    break;
                }
                Next::Behind(part) => {
                    observe(step, pass.after());
                    pass.pass_over(instruction.opcode);
                    index += pass.go_behind(part);
                }
                Next::Label { label, line } => {
                    observe(step, pass.after());
                    let from = pass.steps.cost();
                    index = pass.go_to(code, label);
                    // What lies between is what has been passed over to come back here.
                    if let Some(back) = from.checked_sub(pass.steps.cost()) {
                        match pass.budget.checked_sub(back) {
                            Some(left) => pass.budget = left,
                            None => return Err(self.too_many_jumps(line)),
                        }
                    }
                }
            }
        }
        self.state.first = false;
        Ok(self.state.outputs)
    }

    fn too_many_jumps(&mut self, line: u16) -> Fault {
        self.state.outputs = Image(0);
        Fault {
            cause: Cause::TooManyJumps,
            line: Some(line.into()),
        }
    }
}

/// Where a scan goes on after an instruction.
pub(super) enum Next {
    /// With the next instruction.
    Step,
    /// At a label, where a new rung begins. The line is that of the jump in its file.
    Label { label: u8, line: u16 },
    /// After the END of the IF that is open, or after this before it: a new rung begins there.
    Behind(Opcode),
    /// It ends.
    End,
}

impl<'c> Pass<'c> {
    /// Goes on after a label, where a new rung begins; gives the index of the instruction there. The
    /// loader has seen to it that the label exists; the program would end where it did not.
    fn go_to(&mut self, code: &'c [u8], label: u8) -> usize {
        self.steps = Steps::new(code);
        (self.timers, self.own, self.acc) = (0, 0, true);
        let mut index = 0;
        loop {
            let at = self.steps.clone();
            let Some(step) = self.steps.next() else {
                return index;
            };
            if step.opcode == Opcode::Label && step.number() == Some(label) {
                self.steps = at;
                return index;
            }
            index += 1;
            self.pass_over(step.opcode);
        }
    }

    /// Goes on after a part of the IF that is open, its END at the latest; gives how many instructions that
    /// passes over. The loader has seen to it that the END exists.
    fn go_behind(&mut self, part: Opcode) -> usize {
        self.acc = true;
        let (mut count, mut inner) = (0, 0_u32);
        while let Some(step) = self.steps.next() {
            count += 1;
            self.pass_over(step.opcode);
            match step.opcode {
                Opcode::If => inner += 1,
                Opcode::EndIf if inner > 0 => inner -= 1,
                Opcode::EndIf => break,
                opcode if opcode == part && inner == 0 => break,
                _ => {}
            }
        }
        count
    }

    /// What an observer sees after an instruction.
    fn after(&self) -> After {
        After {
            acc: self.acc,
            value: self.value,
        }
    }

    /// What the next instruction finds after this one.
    fn pass_over(&mut self, opcode: Opcode) {
        let row = opcode.row();
        self.timers += u8::from(row.class == Class::Timer);
        self.own += usize::from(row.own);
    }
}
