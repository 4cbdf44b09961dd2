//! The analogue inputs, as knobs that keys turn.

use std::collections::BTreeMap;
use unoclp_core::Inputs;

/// What the analogue inputs read, and the one that keys turn.
#[derive(Clone, Debug, Default)]
pub struct Knobs {
    readings: BTreeMap<u8, u16>,
    /// Those that the program reads.
    used: Vec<u8>,
    /// Which of them, counted from 0.
    selected: usize,
}

/// The largest reading.
const MOST: u16 = 1023;

impl Knobs {
    /// All at 0.
    pub fn new(used: impl IntoIterator<Item = u8>) -> Knobs {
        Knobs {
            used: used.into_iter().collect(),
            ..Knobs::default()
        }
    }

    /// The input that keys turn, from 0; none where the program reads none.
    pub fn selected(&self) -> Option<u8> {
        self.used.get(self.selected).copied()
    }

    /// Goes on to the next one.
    pub fn select_next(&mut self) {
        self.selected = (self.selected + 1) % self.used.len().max(1);
    }

    /// Turns it so far, within its bounds.
    pub fn turn(&mut self, by: i16) {
        if let Some(input) = self.selected() {
            let reading = self.readings.entry(input).or_default();
            *reading = reading.saturating_add_signed(by).min(MOST);
        }
    }

    /// Sets the readings of these inputs.
    pub fn apply(&self, inputs: &mut Inputs) {
        for (&input, &reading) in &self.readings {
            if let Some(place) = inputs.analogue.get_mut(usize::from(input)) {
                *place = reading;
            }
        }
    }
}
