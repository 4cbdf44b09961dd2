//! The receiver: it samples each bit in its middle, at its own rate, so a line of another rate or form is misread as on
//! the chip.

use super::line::Setting;
use super::wire::Wire;
use std::collections::VecDeque;

/// Characters that the receive buffer holds. One more can wait in the shift register.
const BUFFER: usize = 2;

/// A character that has been received.
#[derive(Clone, Copy, Debug)]
pub(super) struct Received {
    byte: u8,
    /// The stop bit was 0.
    pub framing_error: bool,
    pub parity_error: bool,
    /// Characters before it were lost.
    pub after_loss: bool,
}

#[derive(Default)]
pub(super) struct Receiver {
    /// Where it is on, from when it looks for the next start bit.
    awaits: Option<u64>,
    buffer: VecDeque<Received>,
    /// Stands in the shift register, until the next start bit.
    waiting: Option<Received>,
    lost: bool,
}

impl Receiver {
    /// Switches it on or off, which forgets what it has received.
    pub fn switch(&mut self, on: bool, now: u64) {
        if on != self.awaits.is_some() {
            *self = Receiver {
                awaits: on.then_some(now),
                ..Receiver::default()
            };
        }
    }

    /// What the next read gives.
    pub fn first(&self) -> Option<&Received> {
        self.buffer.front()
    }

    /// The program reads; 0 where there is nothing.
    pub fn take(&mut self, wire: &Wire, now: u64) -> u8 {
        if self.start_bit(wire).is_some_and(|start| start <= now) {
            self.lose_waiting();
        }
        let byte = self.buffer.pop_front().map_or(0, |first| first.byte);
        self.buffer.extend(self.waiting.take());
        byte
    }

    /// When the next character has been received: in the middle of its first stop bit.
    pub fn due(&self, wire: &Wire, setting: Setting) -> Option<u64> {
        let start = self.start_bit(wire)?;
        Some(start + middle(setting.bits_before_stop(), setting))
    }

    /// Takes all characters that are due.
    pub fn pass(&mut self, wire: &mut Wire, now: u64, setting: Setting) {
        while let Some(start) = self.start_bit(wire) {
            let due = start + middle(setting.bits_before_stop(), setting);
            if due > now {
                break;
            }
            let noise = wire.level(start + middle(0, setting));
            if noise {
                self.awaits = Some(start + middle(0, setting));
                continue;
            }
            self.lose_waiting();
            let received = self.sample(wire, start, setting);
            if self.buffer.len() < BUFFER {
                self.buffer.push_back(received);
            } else {
                self.waiting = Some(received);
            }
            self.awaits = Some(due);
        }
        wire.forget(self.awaits.unwrap_or(now));
    }

    fn start_bit(&self, wire: &Wire) -> Option<u64> {
        wire.falling_edge(self.awaits?)
    }

    /// A start bit comes while a character stands in the shift register.
    fn lose_waiting(&mut self) {
        self.lost |= self.waiting.take().is_some();
    }

    fn sample(&mut self, wire: &Wire, start: u64, setting: Setting) -> Received {
        let level = |bit| wire.level(start + middle(bit, setting));
        let data = 1..=setting.data_bits;
        let byte = data.fold(0, |byte, bit| byte | u8::from(level(bit)) << (bit - 1));
        let parity = setting.parity.bit(byte);
        Received {
            byte,
            framing_error: !level(setting.bits_before_stop()),
            parity_error: parity.is_some_and(|parity| parity != level(setting.data_bits + 1)),
            after_loss: std::mem::take(&mut self.lost),
        }
    }
}

/// Cycles from the start of a character to the middle of a bit.
fn middle(bit: u64, setting: Setting) -> u64 {
    bit * setting.cycles_per_bit + setting.cycles_per_bit / 2
}
