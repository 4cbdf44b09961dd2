//! The boxes of timers and counters, with what they have come to: `TON T1  120/5000 ms`.

use super::Flow;
use unoclp_core::isa::Operand;
use unoclp_core::{CounterState, Delay, Instruction, Program, TimerState};

/// What the box of each step counts.
#[derive(Clone, Debug)]
pub struct Boxes(Vec<Option<Count>>);

/// What a box counts.
#[derive(Clone, Copy, Debug)]
enum Count {
    /// The time of the timer with this index.
    Time(usize),
    /// The counter with this index, up or down.
    Events(usize, &'static str),
}

/// What a timer or a counter has come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Now {
    /// Milliseconds.
    Time {
        /// Of them all.
        preset: u32,
        /// That have passed.
        elapsed: u32,
    },
    /// Events.
    Events {
        /// To be counted.
        preset: i32,
        /// That were.
        value: i32,
    },
}

impl Boxes {
    /// Those of this program.
    pub fn new(program: &Program<'_>) -> Boxes {
        let mut timers = 0..;
        let count = |step: Instruction<'_>| match step.operand {
            Operand::Count { counter, .. } => {
                let index = usize::from(counter).saturating_sub(1);
                Some(Count::Events(index, step.opcode.row().letters))
            }
            _ if Delay::of(step.opcode).is_some() => timers.next().map(Count::Time),
            _ => None,
        };
        Boxes(program.steps().map(count).collect())
    }

    /// The steps whose boxes change while the program runs.
    pub fn steps(&self) -> impl Iterator<Item = usize> {
        let counting = self.0.iter().enumerate();
        counting.filter_map(|(step, count)| count.map(|_| step))
    }

    /// What the box of a step has come to.
    pub fn now(&self, step: usize, flow: &Flow) -> Option<Now> {
        Some(match (*self.0.get(step)?)? {
            Count::Time(index) => {
                let timer = flow.timers.get(index)?;
                Now::Time {
                    preset: timer.preset,
                    elapsed: timer.elapsed,
                }
            }
            Count::Events(index, _) => {
                let counter = flow.counters.get(index)?;
                Now::Events {
                    preset: counter.preset,
                    value: counter.value,
                }
            }
        })
    }

    /// `TON T1  120/5000 ms`, `CTU C1 3/10`
    pub fn text(&self, step: usize, flow: &Flow) -> Option<String> {
        match (*self.0.get(step)?)? {
            Count::Time(index) => {
                let TimerState {
                    delay,
                    preset,
                    elapsed,
                    ..
                } = flow.timers.get(index)?;
                let digits = preset.to_string().len();
                let letters = delay.letters();
                let number = index + 1;
                Some(format!(
                    "{letters} T{number} {elapsed:>digits$}/{preset} ms"
                ))
            }
            Count::Events(index, letters) => {
                let CounterState { value, preset, .. } = flow.counters.get(index)?;
                let digits = preset.to_string().len();
                let number = index + 1;
                Some(format!("{letters} C{number} {value:>digits$}/{preset}"))
            }
        }
    }
}
