//! Taking over what another board tells of itself, to show what its program does there.

use super::{Plc, TimerState};
use crate::timer::{Target, Timer};
use crate::{Image, Millis};

/// A board that runs the same program, as seen from outside. What it does not tell is empty, and stays.
#[derive(Clone, Copy, Debug, Default)]
pub struct Snapshot<'s> {
    /// The image of the outputs.
    pub outputs: Image,
    /// The markers, bit 0 M 01.
    pub markers: u128,
    /// D 01 and those after it.
    pub registers: &'s [i32],
    /// Elapsed time and preset of T 01 and those after it.
    pub timers: &'s [(Millis, Millis)],
    /// Value and preset of C 01 and those after it.
    pub counters: &'s [(i32, i32)],
}

impl Plc<'_> {
    /// Takes over a snapshot, so that a scan with this time stamp and the board's inputs does what a scan of
    /// the board does. Edges, filters and integrations keep what is theirs.
    pub fn adopt(&mut self, board: &Snapshot<'_>, now: Millis) {
        self.state.outputs = board.outputs;
        self.state.markers = board.markers;
        for (register, value) in self.state.registers.iter_mut().zip(board.registers) {
            *register = *value;
        }
        // The blocks stand in the program, the data in run memory.
        for (index, &(elapsed, preset)) in board.timers.iter().enumerate() {
            let timer = self.timers(now).nth(index);
            let Some(TimerState { delay, target, .. }) = timer else {
                break;
            };
            let on = self.reads(target);
            if let Some(data) = self.timers.get_mut(index) {
                *data = Timer::seen(delay, elapsed, preset, on, now).store();
            }
        }
        for (number, &(value, preset)) in (1..).zip(board.counters) {
            self.with_counter(number, |counter| counter.seen(value, preset));
        }
    }

    /// The state of what a timer drives.
    fn reads(&self, target: Target) -> bool {
        match target {
            Target::Output(number) => self.output(number),
            Target::Marker(number) => self.marker(number),
            Target::Timer(_) => false,
        }
    }
}
