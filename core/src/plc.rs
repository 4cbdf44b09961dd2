//! The running PLC: images, timers and the scan.

use crate::isa::Instruction;
use crate::timer::{self, Delay, Timer, TimerBlock};
use crate::{Image, Program, Steps};

/// A time in ms, or a reading of the millisecond clock; the clock wraps after 49.7 days.
pub type Millis = u32;

/// A program with everything it needs to run.
#[derive(Debug)]
pub struct Plc<'m> {
    code: &'m [u8],
    timers: &'m mut [[u8; timer::DATA_BYTES]],
    outputs: Image,
}

/// A timer as an observer sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TimerState {
    /// TON or TOF.
    pub delay: Delay,
    /// Preset and output.
    pub block: TimerBlock,
    /// Elapsed time of the delay in ms, at most the preset.
    pub elapsed: Millis,
    /// The timer's output.
    pub q: bool,
}

impl<'m> Plc<'m> {
    /// Makes a checked program ready to run: all outputs 0 (NC-7), no timer started.
    pub fn new(program: Program<'m>) -> Plc<'m> {
        // The loader has reserved the timers' data; a shorter memory would only mean fewer timers.
        let (code, data) = program
            .memory
            .split_at_mut_checked(program.code_bytes)
            .unwrap_or_default();
        let (timers, _) = data.as_chunks_mut();
        let timers = timers.get_mut(..program.timers).unwrap_or_default();
        timers.fill([0; timer::DATA_BYTES]);
        Plc {
            code,
            timers,
            outputs: Image::default(),
        }
    }

    /// One scan (NC-5): runs the program once on this input image with this time stamp, and gives
    /// the output image. It cannot fail.
    pub fn scan(&mut self, inputs: Image, now: Millis) -> Image {
        self.scan_observed(inputs, now, |_| ())
    }

    /// A scan that tells an observer acc after each instruction, in the order of [`Plc::steps`].
    pub fn scan_observed(
        &mut self,
        inputs: Image,
        now: Millis,
        mut observe: impl FnMut(bool),
    ) -> Image {
        // The result of the rung so far (NC-6).
        let mut acc = true;
        // One bit for each open branch, the innermost in bit 0: acc as it was when the branch
        // opened. Eight are enough, because the loader allows no deeper nesting.
        let mut open = 0u8;
        // One bit for each branch point of the rung.
        let mut points = Image::default();
        let outputs = &mut self.outputs;
        let mut timers = self.timers.iter_mut();

        for instruction in Steps::new(self.code) {
            match instruction {
                Instruction::NewRung => acc = true,
                Instruction::InputContact(point) => acc &= inputs.get(point),
                Instruction::InputContactNot(point) => acc &= !inputs.get(point),
                Instruction::OutputContact(point) => acc &= outputs.get(point),
                Instruction::OutputContactNot(point) => acc &= !outputs.get(point),
                Instruction::Coil(point) => outputs.set(point, acc),
                Instruction::SetCoil(point) if acc => outputs.set(point, true),
                Instruction::ResetCoil(point) if acc => outputs.set(point, false),
                Instruction::SetCoil(_) | Instruction::ResetCoil(_) => {}
                Instruction::StoreBranch(point) => points.set(point, acc),
                Instruction::RecallBranch(point) => acc = points.get(point),
                Instruction::OpenBranch => {
                    open = open << 1 | u8::from(acc);
                    acc = true;
                }
                Instruction::CloseBranch => {
                    acc |= open & 1 != 0;
                    open >>= 1;
                }
                Instruction::OnDelay(block) => {
                    acc = scan_timer(timers.next(), Delay::On, block, acc, now);
                    outputs.set(block.output, acc);
                }
                Instruction::OffDelay(block) => {
                    acc = scan_timer(timers.next(), Delay::Off, block, acc, now);
                    outputs.set(block.output, acc);
                }
            }
            observe(acc);
        }
        self.outputs
    }

    /// Starts anew, as after power-up: all outputs 0 (NC-7), no timer started.
    pub fn restart(&mut self) {
        self.timers.fill([0; timer::DATA_BYTES]);
        self.outputs = Image::default();
    }

    /// The stored form of the program, as it stands in run memory.
    pub fn stored(&self) -> &[u8] {
        self.code
    }

    /// The output image as the last scan left it.
    pub fn outputs(&self) -> Image {
        self.outputs
    }

    /// The instructions in order.
    pub fn steps(&self) -> Steps<'_> {
        Steps::new(self.code)
    }

    /// The timers in file order, as they stand at this time.
    pub fn timers(&self, now: Millis) -> impl Iterator<Item = TimerState> {
        let blocks = self.steps().filter_map(Instruction::timer);
        blocks
            .zip(self.timers.iter())
            .map(move |((delay, block), data)| {
                let timer = Timer::load(*data);
                TimerState {
                    delay,
                    block,
                    elapsed: timer.elapsed(delay, block.preset, now),
                    q: timer.output(delay),
                }
            })
    }
}

/// One scan of a timer whose data stands in run memory; gives Q. The loader has reserved the data
/// of every timer, so the block without data, whose Q is 0, does not occur.
fn scan_timer(
    data: Option<&mut [u8; timer::DATA_BYTES]>,
    delay: Delay,
    block: TimerBlock,
    input: bool,
    now: Millis,
) -> bool {
    let Some(data) = data else { return false };
    let mut timer = Timer::load(*data);
    let q = timer.scan(delay, input, block.preset, now);
    *data = timer.store();
    q
}
