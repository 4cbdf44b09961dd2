//! A request that is done in slices.

use crate::frame::{FIXED, Frame};
use crate::{Access, Device, Table};

/// A valid request that is being done.
#[derive(Debug, PartialEq, Eq)]
pub struct Exchange {
    pub(crate) table: Table,
    pub(crate) access: Access,
    /// The next address, and how many there are from it on.
    pub(crate) address: u16,
    pub(crate) left: u16,
    /// Where they stand in the frame.
    pub(crate) at: u8,
}

/// Bytes of 8 bits in a slice.
const SLICE: u8 = 4;

impl Exchange {
    /// Does the next slice: at most 32 bits, or as many words as the [device](Device::words) does at once. `Some` once
    /// all is done: the length of the reply in the frame, or 0 where nothing is to be sent. It is not called again
    /// then.
    ///
    /// Nobody else may change the frame in between. An exchange may be dropped at any time; what it has
    /// written stays. A write of several slices takes effect over several scans.
    #[inline(never)]
    pub fn fill<D: Device>(&mut self, frame: &mut Frame, device: &mut D) -> Option<u8> {
        if self.left != 0 {
            if self.table.has_words() {
                self.words(frame, device);
            } else {
                self.bits(frame, device);
            }
            if self.left != 0 {
                return None;
            }
        }
        let mut length = self.at;
        if self.access == Access::Write {
            device.is_written();
            // The reply is what the request began with: function, first address, quantity.
            length = FIXED;
        }
        let broadcast = frame[0] == 0;
        Some(if broadcast { 0 } else { length })
    }

    /// Does a slice of words. There is one left.
    fn words<D: Device>(&mut self, frame: &mut Frame, device: &mut D) {
        let at = usize::from(self.at);
        let bytes = frame.get_mut(at..at + 2 * usize::from(self.left));
        let words = bytes.unwrap_or_default().as_chunks_mut().0;
        let done = device.words(self.table, self.address, self.access, words);
        // A device that does none would never be done.
        self.advance(done.max(1).into());
        self.at = self.at.wrapping_add(done.wrapping_mul(2));
    }

    /// Does a slice of bits.
    fn bits<D: Device>(&mut self, frame: &mut Frame, device: &mut D) {
        let mut bytes = SLICE;
        while bytes != 0 && self.left != 0 {
            bytes = bytes.wrapping_sub(1);
            let count = self.left.min(8) as u8;
            let byte = &mut frame[usize::from(self.at)];
            let bits = device.bits(self.table, self.address, self.access, count, *byte);
            if self.access == Access::Read {
                // Those behind the last are 0.
                *byte = bits & u8::MAX >> 8_u8.wrapping_sub(count);
            }
            self.at = self.at.wrapping_add(1);
            self.advance(count.into());
        }
    }

    /// Goes on by so many addresses; behind 65535 none is left.
    fn advance(&mut self, by: u16) {
        self.address = self.address.wrapping_add(by);
        self.left = self.left.saturating_sub(by);
    }
}
