//! A scan in slow motion: what of a program is shown while a board stands in the middle of one.
//!
//! A board's engine runs several instructions at once where it can. Its page tells where it has stood, and this finds what lies
//! between: contacts, branches and coils, whose acc follows from inputs and outputs.
//!
//! Owns the way from where an engine has stood to acc after each instruction. Must not know how a board is stopped.

use crate::answer::answer;
use crate::board::{Live, Watched};
use unoclp_core::isa::Opcode;
use unoclp_core::{After, Instruction};
use unoclp_exercise::live::Flow;

/// Some instructions in a row that an engine has run at once.
#[derive(Clone, Copy, Debug)]
pub struct Left {
    /// The first of them, and the last.
    pub from: usize,
    pub to: usize,
    /// acc after them.
    pub acc: bool,
    /// The value after them, and the inputs and outputs as the scan has them, bit 0 point 01; none where the engine went by
    /// at full speed.
    pub value: Option<i32>,
    pub inputs: Option<u32>,
    pub outputs: Option<u32>,
}

answer! {
    /// How the core stands in the middle of a scan.
    pub struct Stood as "Stood" {
        /// The instruction that comes next, from 0; none at the end of a scan.
        pub step: Option<usize>,
        /// Those from it to before this one are run at once.
        pub until: usize,
        pub acc: bool,
        pub value: i32,
        /// What is pushed, the last first.
        pub pushed: Vec<i32>,
        /// Bit n: input n + 1, as the scan has it, and as it is at its contact; likewise the outputs.
        pub inputs: u32,
        pub closed: u32,
        pub outputs: u32,
        pub driven: u32,
        pub live: Option<Live>,
    }
}

/// What there is to show of a program whose scan has come so far.
pub fn live(watched: &mut Watched, left: &[Left]) -> Live {
    let flow = watched.machine().with_plc(|plc| {
        let steps: Vec<Instruction<'_>> = plc.steps().collect();
        flow(&steps, left)
    });
    watched.show(&flow)
}

/// acc and value after each instruction that has been run.
fn flow(steps: &[Instruction<'_>], left: &[Left]) -> Flow {
    let mut flow = Flow::new(steps.len());
    let mut before: Option<&Left> = None;
    for one in left {
        let follows = before.filter(|before| before.to + 1 == one.from);
        // A scan begins with acc 1, and so does what is jumped to.
        let begin = follows.is_none_or(|before| before.acc);
        let run = steps.get(one.from..=one.to).unwrap_or_default();
        within(run, begin, one, &mut flow);
        match (one.value, one.acc) {
            (Some(value), acc) => flow.observe(one.to, After { acc, value }),
            (None, acc) => {
                if let Some(place) = flow.acc.get_mut(one.to) {
                    *place = Some(acc);
                }
            }
        }
        before = Some(one);
    }
    flow
}

/// acc after each of some instructions but the last, which are run at once on these images.
fn within(run: &[Instruction<'_>], begin: bool, left: &Left, flow: &mut Flow) {
    let (Some(inputs), Some(outputs)) = (left.inputs, left.outputs) else {
        return;
    };
    let is_on = |points: u32, number: u8| {
        let shifted = points.checked_shr(u32::from(number.wrapping_sub(1)));
        shifted.is_some_and(|points| points & 1 == 1)
    };
    let (mut acc, mut open) = (begin, Vec::new());
    for (step, one) in (left.from..left.to).zip(run) {
        let xx = one.number().unwrap_or_default();
        match one.opcode {
            Opcode::NewRung => acc = true,
            Opcode::OpenBranch => {
                open.push(acc);
                acc = true;
            }
            Opcode::CloseBranch => acc |= open.pop().unwrap_or_default(),
            // The engine joins branches only where acc has not changed since the point was stored.
            Opcode::RecallBranch => acc = begin,
            Opcode::InputContact => acc &= is_on(inputs, xx),
            Opcode::InputContactNot => acc &= !is_on(inputs, xx),
            Opcode::OutputContact => acc &= is_on(outputs, xx),
            Opcode::OutputContactNot => acc &= !is_on(outputs, xx),
            Opcode::Coil => {}
            // What takes no byte changes nothing, and all else stands alone.
            _ => continue,
        }
        if let Some(place) = flow.acc.get_mut(step) {
            *place = Some(acc);
        }
    }
}
