//! What a program does at the moment.

use unoclp_core::{After, CounterState, Plc, TimerState};

/// What a program does at the moment, for its rungs to show.
#[derive(Clone, Debug, Default)]
pub struct Flow {
    /// acc after each instruction that the last scan has run; empty before the first scan.
    pub acc: Vec<Option<bool>>,
    /// The value accumulator after each of them, the last time that acc was 0 there and the last time that it was 1: a
    /// step of a loop is run more than once.
    values: Vec<[Option<i32>; 2]>,
    /// The timers as they stand.
    pub(super) timers: Vec<TimerState>,
    /// The counters as they stand.
    pub(super) counters: Vec<CounterState>,
    /// The counters as the scan has left them.
    counted: Vec<CounterState>,
}

impl Flow {
    /// The flow of a program of so many steps, none of which has been run.
    pub fn new(steps: usize) -> Flow {
        Flow {
            acc: vec![None; steps],
            values: vec![[None; 2]; steps],
            ..Flow::default()
        }
    }

    /// Takes up what a step of the scan has left behind; the last time counts.
    pub fn observe(&mut self, step: usize, after: After) {
        if let (Some(acc), Some(value)) = (self.acc.get_mut(step), self.values.get_mut(step)) {
            *acc = Some(after.acc);
            value[usize::from(after.acc)] = Some(after.value);
        }
    }

    /// Takes up timers and counters as they stand at this time.
    pub fn look(&mut self, plc: &Plc<'_>, now: u32) {
        self.timers = plc.timers(now).collect();
        self.counters = plc.counters().collect();
    }

    /// Takes up what the scan has left.
    pub fn end(&mut self, plc: &Plc<'_>) {
        self.counted = plc.counters().collect();
    }

    /// acc after this step, if the last scan has run it.
    pub fn acc(&self, step: usize) -> Option<bool> {
        self.acc.get(step).copied().flatten()
    }

    /// The value after this step, if the last scan has run it.
    pub fn value(&self, step: usize) -> Option<i32> {
        self.value_where(step, self.acc(step)?)
    }

    /// The value after this step, if the last scan has run it with this acc after it.
    pub fn value_where(&self, step: usize, acc: bool) -> Option<i32> {
        self.values.get(step)?[usize::from(acc)]
    }

    /// The counter with this number, from 1, as the scan has left it.
    pub fn counter(&self, number: u8) -> Option<CounterState> {
        let index = usize::from(number).checked_sub(1)?;
        self.counted.get(index).copied()
    }
}
