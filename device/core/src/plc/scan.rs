//! The scan: one pass through the program.

use super::{Inputs, Plc};
use crate::isa::{JUMP_BUDGET, Opcode};
use crate::width::ANALOGUE;
use crate::{Cause, Fault, Image, Instruction, Millis, Needs, Steps};

/// What an instruction leaves behind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct After {
    /// The result of the rung so far (NC-6).
    pub acc: bool,
    /// The value accumulator (NC-16).
    pub value: i32,
}

/// What lives as long as one scan.
#[derive(Clone, Debug)]
pub(super) struct Pass {
    /// The instruction that comes next: its stored byte, and what jumping back over those before it costs.
    at: usize,
    cost: usize,
    pub(super) now: Millis,
    pub(super) analogue: [u16; ANALOGUE as usize],
    pub(super) scan_time: u16,
    /// The result of the rung so far (NC-6).
    pub(super) acc: bool,
    /// The value accumulator (NC-16).
    pub(super) value: i32,
    /// What is pushed (NC-22), the last first. Eight are enough, because the loader allows no more.
    pub(super) pushed: [i32; 8],
    /// How many of them there are.
    pub(super) depth: u8,
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

/// A scan that is under way: [`Plc::begin`] and [`Plc::step`] make it instruction by instruction.
#[derive(Clone, Debug)]
pub struct Scan {
    pass: Pass,
    /// The instruction that comes next.
    index: usize,
}

impl Scan {
    /// The index of the instruction that comes next, in the order of [`Plc::steps`]; at the end as many as there are, or
    /// less where the program returned before.
    pub fn next(&self) -> usize {
        self.index
    }

    /// What that instruction finds.
    pub fn found(&self) -> After {
        self.pass.after()
    }

    /// What is pushed (NC-22), the last first.
    pub fn pushed(&self) -> &[i32] {
        let pushed = &self.pass.pushed;
        pushed.get(..self.pass.depth.into()).unwrap_or(pushed)
    }
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
        let mut scan = self.begin(inputs, now);
        while let Some((step, after)) = self.step(&mut scan)? {
            observe(step, after);
        }
        Ok(self.state.outputs)
    }

    /// Begins a scan (NC-5) on these inputs with this time stamp; [`Plc::step`] goes on with it. Another may begin when
    /// it is over.
    pub fn begin(&mut self, inputs: impl Into<Inputs>, now: Millis) -> Scan {
        let inputs = inputs.into();
        let first = self.state.first;
        let Needs { filter, .. } = self.needs;
        let points = Image(inputs.points.0 & self.needs.digital(&self.board));
        self.state.inputs.scan(points, filter, first, now);
        self.state.clocks.scan(first, now);
        let pass = Pass {
            at: 0,
            cost: 0,
            now,
            analogue: inputs.analogue,
            scan_time: inputs.scan_time,
            acc: true,
            value: 0,
            pushed: [0; 8],
            depth: 0,
            open: 0,
            opened: [Opcode::OpenBranch; 8],
            points: 0,
            timers: 0,
            own: 0,
            budget: JUMP_BUDGET.into(),
            error: false,
        };
        Scan { pass, index: 0 }
    }

    /// The next instruction of a scan: its index, in the order of [`Plc::steps`], and what it has left behind; none at the
    /// end of the scan, whose output image is [`Plc::outputs`] then.
    ///
    /// # Errors
    /// As [`Plc::scan`].
    pub fn step(&mut self, scan: &mut Scan) -> Result<Option<(usize, After)>, Fault> {
        let code = self.code;
        let Scan { pass, index } = scan;
        let Some(instruction) = pass.take_next(code) else {
            self.state.first = false;
            return Ok(None);
        };
        let step = *index;
        *index += 1;
        let next = self.run(pass, instruction);
        let after = pass.after();
        match next {
            Next::Step => pass.pass_over(&instruction),
            Next::End => pass.at = usize::MAX,
            Next::Behind(part) => {
                pass.pass_over(&instruction);
                *index += pass.go_behind(code, part);
            }
            Next::Label { label, line } => {
                let from = pass.cost;
                *index = pass.go_to(code, label);
                // What lies between is what has been passed over to come back here.
                if let Some(back) = from.checked_sub(pass.cost) {
                    match pass.budget.checked_sub(back) {
                        Some(left) => pass.budget = left,
                        None => return Err(self.too_many_jumps(line)),
                    }
                }
            }
        }
        Ok(Some((step, after)))
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

impl Pass {
    /// The next instruction.
    #[inline]
    fn take_next<'c>(&mut self, code: &'c [u8]) -> Option<Instruction<'c>> {
        let mut steps = Steps::new(code).behind(self.at, self.cost);
        let instruction = steps.next();
        (self.at, self.cost) = (steps.at(), steps.cost());
        instruction
    }

    /// Goes on after a label, where a new rung begins; gives the index of the instruction there. The
    /// loader has seen to it that the label exists; the program would end where it did not.
    fn go_to(&mut self, code: &[u8], label: u8) -> usize {
        (self.at, self.cost) = (0, 0);
        (self.timers, self.own, self.acc) = (0, 0, true);
        let mut index = 0;
        loop {
            let before = (self.at, self.cost);
            let Some(step) = self.take_next(code) else {
                return index;
            };
            if step.opcode == Opcode::Label && step.number() == Some(label) {
                (self.at, self.cost) = before;
                return index;
            }
            index += 1;
            self.pass_over(&step);
        }
    }

    /// Goes on after a part of the IF that is open, its END at the latest; gives how many instructions that
    /// passes over. The loader has seen to it that the END exists.
    fn go_behind(&mut self, code: &[u8], part: Opcode) -> usize {
        self.acc = true;
        let (mut count, mut inner) = (0, 0_u32);
        while let Some(step) = self.take_next(code) {
            count += 1;
            self.pass_over(&step);
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
    fn pass_over(&mut self, step: &Instruction<'_>) {
        self.timers += u8::from(step.is_own_timer());
        self.own += usize::from(step.opcode.row().own);
    }
}
