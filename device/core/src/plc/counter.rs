//! Counters (NC-15).

use crate::isa::COUNTER_DATA;

/// The data of one counter.
#[derive(Clone, Copy)]
pub(super) struct Counter {
    pub(super) value: i32,
    pub(super) preset: i32,
    /// acc at CTU and at CTD when they were last reached.
    up: bool,
    down: bool,
}

impl Counter {
    pub(super) fn load(data: [u8; COUNTER_DATA]) -> Counter {
        let [a, b, c, d, e, f, g, h, inputs] = data;
        Counter {
            value: i32::from_le_bytes([a, b, c, d]),
            preset: i32::from_le_bytes([e, f, g, h]),
            up: inputs & 1 != 0,
            down: inputs & 2 != 0,
        }
    }

    pub(super) fn store(self) -> [u8; COUNTER_DATA] {
        let [a, b, c, d] = self.value.to_le_bytes();
        let [e, f, g, h] = self.preset.to_le_bytes();
        let inputs = u8::from(self.up) | u8::from(self.down) << 1;
        [a, b, c, d, e, f, g, h, inputs]
    }

    /// CTU: counts a rise of IN, and stays at the largest number.
    pub(super) fn up(&mut self, input: bool) -> bool {
        if input && !self.up {
            self.value = self.value.saturating_add(1);
        }
        self.up = input;
        self.is_reached()
    }

    /// CTD: counts a rise of IN, and stays at the smallest number.
    pub(super) fn down(&mut self, input: bool) -> bool {
        if input && !self.down {
            self.value = self.value.saturating_sub(1);
        }
        self.down = input;
        self.is_zero()
    }

    /// As seen from outside. No rise is counted: the board has counted it.
    pub(super) fn seen(&mut self, value: i32, preset: i32) {
        (self.value, self.preset) = (value, preset);
        (self.up, self.down) = (true, true);
    }

    pub(super) fn is_reached(&self) -> bool {
        self.value >= self.preset
    }

    pub(super) fn is_zero(&self) -> bool {
        self.value <= 0
    }
}
