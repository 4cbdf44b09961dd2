//! A request that is done in slices.

use crate::frame::{FIXED, Frame};
use crate::{Access, Addresses, Device, Table};

/// A valid request that is being done; at first none.
#[derive(Debug)]
pub struct Exchange {
    /// What is left of it.
    pub(crate) addresses: Addresses,
    /// Where that stands in the frame.
    pub(crate) at: u8,
}

/// Bytes of 8 bits in a slice.
const SLICE: u8 = 4;

impl Default for Exchange {
    fn default() -> Exchange {
        let addresses = Addresses {
            table: Table::Coils,
            access: Access::Read,
            first: 0,
            count: 0,
        };
        Exchange { addresses, at: 0 }
    }
}

impl Exchange {
    /// Does the next slice: at most 32 bits, or as many words as the [device](Device::words) does at once. `Some` once
    /// all is done: the length of the reply in the frame, or 0 where nothing is to be sent. It is not called again
    /// then.
    ///
    /// Nobody else may change the frame in between. An exchange may be dropped at any time; what it has
    /// written stays. A write of several slices takes effect over several scans.
    #[inline(never)]
    pub fn fill<D: Device>(&mut self, frame: &mut Frame, device: &mut D) -> Option<u8> {
        let mut slice = SLICE;
        while self.addresses.count != 0 {
            if slice == 0 {
                return None;
            }
            let (done, bytes) = if self.addresses.table.has_words() {
                slice = 0;
                self.words(frame, device)
            } else {
                slice = slice.wrapping_sub(1);
                self.bits(frame, device)
            };
            self.at = self.at.wrapping_add(bytes);
            let Addresses { first, count, .. } = &mut self.addresses;
            *first = first.wrapping_add(done.into());
            *count = count.wrapping_sub(done.into());
        }
        let mut length = self.at;
        if self.addresses.access == Access::Write {
            device.is_written();
            // The reply is what the request began with: function, first address, quantity.
            length = FIXED;
        }
        let broadcast = frame[0] == 0;
        Some(if broadcast { 0 } else { length })
    }

    /// Does words, as many as the device does at once: gives how many, and their bytes. There is one left.
    fn words<D: Device>(&self, frame: &mut Frame, device: &mut D) -> (u8, u8) {
        let words = frame[self.at.into()..].as_chunks_mut().0;
        let words = words
            .get_mut(..self.addresses.count.into())
            .unwrap_or_default();
        let done = device.words(&self.addresses, words);
        // A device that does none would never be done.
        (done.max(1), done.wrapping_mul(2))
    }

    /// The same of the bits in a byte.
    fn bits<D: Device>(&self, frame: &mut Frame, device: &mut D) -> (u8, u8) {
        let count = self.addresses.count.min(8) as u8;
        let byte = &mut frame[usize::from(self.at)];
        let bits = device.bits(&self.addresses, count, *byte);
        if self.addresses.access == Access::Read {
            // Those after the last are 0.
            *byte = bits & u8::MAX >> 8_u8.wrapping_sub(count);
        }
        (count, 1)
    }
}
