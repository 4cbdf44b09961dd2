//! The points of a program by their numbers, as a scan reads and writes them.

use super::Plc;
use super::scan::Pass;
use crate::{Image, ImageBits, Millis};

impl Plc<'_> {
    pub(super) fn input(&self, number: u8) -> bool {
        self.state.inputs.image().0 & mask(number) != 0
    }

    pub(super) fn output(&self, number: u8) -> bool {
        self.state.outputs.0 & mask(number) != 0
    }

    pub(super) fn set_output(&mut self, number: u8, state: bool) {
        self.state.outputs.0 &= !mask(number);
        self.state.outputs.0 |= if state { mask(number) } else { 0 };
    }

    /// So many outputs at once, from 01 on, but for those that are PWM.
    pub(super) fn set_outputs(&mut self, outputs: u8, count: u8) {
        let all = !(!0 << count.min(self.board.outputs));
        let outputs = ImageBits::from(outputs) & all & !(self.needs.pwm as ImageBits);
        self.state.outputs = Image(self.state.outputs.0 & !all | outputs);
    }

    pub(super) fn marker(&self, number: u8) -> bool {
        self.state.markers >> (number.wrapping_sub(1) & 127) & 1 != 0
    }

    pub(super) fn system(&self, pass: &Pass, number: u8) -> bool {
        match number {
            1 => self.state.first,
            2 => self.state.clocks.slow(),
            3 => self.state.clocks.fast(),
            _ => pass.error,
        }
    }

    pub(super) fn register(&self, number: u8) -> i32 {
        let index = usize::from(number).wrapping_sub(1);
        self.state.registers.get(index).copied().unwrap_or_default()
    }

    pub(super) fn elapsed(&mut self, number: u8, now: Millis) -> Millis {
        let index = usize::from(number).wrapping_sub(1);
        let timer = self.timers(now).nth(index);
        timer.map_or(0, |timer| timer.elapsed)
    }
}

/// The bit of an input or output.
fn mask(number: u8) -> ImageBits {
    1 << (number.wrapping_sub(1) & (ImageBits::BITS as u8 - 1))
}
