//! What a program does at the moment.

use std::collections::BTreeMap;
use unoclp_core::{CounterState, Plc, TimerState};
use unoclp_ladder::Address;

/// What a program does at the moment, for its rungs to show.
#[derive(Clone, Debug, Default)]
pub struct Flow {
    /// acc behind each instruction that the last scan has run; empty before the first scan.
    pub acc: Vec<Option<bool>>,
    /// The timers as they stand.
    pub(super) timers: Vec<TimerState>,
    /// The counters as they stand.
    pub(super) counters: Vec<CounterState>,
    /// The registers as they stand, D 01 first.
    registers: Vec<i32>,
    /// The value behind the steps of which it is shown.
    pub values: BTreeMap<usize, i32>,
}

impl Flow {
    /// Takes up timers, counters and registers as they stand at this time.
    pub fn look(&mut self, plc: &Plc<'_>, now: u32) {
        self.timers = plc.timers(now).collect();
        self.counters = plc.counters().collect();
        self.registers = plc.registers().to_vec();
    }

    /// The value behind this step, if the last scan has run it.
    pub fn value(&self, step: usize) -> Option<i32> {
        self.acc.get(step).copied().flatten()?;
        self.values.get(&step).copied()
    }

    /// What this point holds, if it is a register or a counter.
    pub fn number(&self, point: Address) -> Option<i32> {
        let index = |number: u8| usize::from(number).checked_sub(1);
        match point {
            Address::Register(number) => self.registers.get(index(number)?).copied(),
            Address::Counter(number) => Some(self.counters.get(index(number)?)?.value),
            _ => None,
        }
    }
}
