//! The transmitter: a shift register, and a buffer of one byte before it.

use super::Parity;
use super::line::Setting;

/// A byte that the program has sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SentByte {
    /// The byte.
    pub byte: u8,
    /// When the program wrote it: cycles since the board was made.
    pub written: u64,
    /// When its start bit begins.
    pub start: u64,
    /// When its last stop bit is over.
    pub end: u64,
    /// The parity bit that goes with it.
    pub parity: Parity,
}

#[derive(Default)]
pub(crate) struct Transmitter {
    /// When the character in the shift register is over.
    shifting: Option<u64>,
    /// When the one in the buffer will be.
    buffered: Option<u64>,
    /// TXC.
    complete: bool,
    bytes: Vec<u8>,
    log: Vec<SentByte>,
}

impl Transmitter {
    /// A reset of the chip. What it was sending is broken off, but stays in the log.
    pub fn reset(&mut self) {
        (self.shifting, self.buffered) = (None, None);
        self.complete = false;
    }

    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    pub fn log(&self) -> &[SentByte] {
        &self.log
    }

    /// The log up to the last byte that is over at this time, and forgets that.
    pub fn take_until(&mut self, now: u64) -> Vec<SentByte> {
        let over = self.log.partition_point(|sent| sent.end <= now);
        self.bytes.drain(..over);
        self.log.drain(..over).collect()
    }

    /// UDRE.
    pub fn has_room(&self) -> bool {
        self.buffered.is_none()
    }

    /// TXC.
    pub fn is_complete(&self) -> bool {
        self.complete
    }

    pub fn clear_complete(&mut self) {
        self.complete = false;
    }

    /// The program writes a byte, which is ignored where there is no room.
    pub fn send(&mut self, byte: u8, now: u64, setting: Setting) {
        if self.buffered.is_some() {
            return;
        }
        let start = self.shifting.unwrap_or(now);
        let end = start + setting.cycles();
        let place = match self.shifting {
            None => &mut self.shifting,
            Some(_) => &mut self.buffered,
        };
        *place = Some(end);
        self.bytes.push(byte);
        self.log.push(SentByte {
            byte,
            written: now,
            start,
            end,
            parity: setting.parity,
        });
    }

    /// When the shift register is done.
    pub fn due(&self) -> Option<u64> {
        self.shifting
    }

    pub fn pass(&mut self, now: u64) {
        while self.shifting.is_some_and(|end| end <= now) {
            self.shifting = self.buffered.take();
            self.complete |= self.shifting.is_none();
        }
    }
}
