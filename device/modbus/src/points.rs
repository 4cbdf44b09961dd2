//! A server that tells its bits and words one by one, where nobody counts cycles.

use crate::{Access, Addresses, Device, Exception, Table, Word};

/// Bits and words, one by one: whatever has these is a [`Device`].
pub trait Points {
    /// Whether all of the addresses `first` to `first + (count - 1)` of `table` exist for `access`.
    fn has(&self, table: Table, first: u16, count: u16, access: Access) -> bool;

    /// The bit of a coil or discrete input.
    fn bit(&self, table: Table, address: u16) -> bool;

    /// The word of a holding or input register.
    fn word(&self, table: Table, address: u16) -> u16;

    /// Writes a coil.
    fn set_bit(&mut self, address: u16, on: bool);

    /// Whether a holding register may take a value.
    ///
    /// # Errors
    /// The exception to answer.
    fn check_word(&self, address: u16, value: u16) -> Result<(), Exception>;

    /// Writes a holding register.
    fn set_word(&mut self, address: u16, value: u16);

    /// How many words it does at once: to an even address, so that no value of two words is torn.
    fn at_once(&self) -> u8 {
        16
    }

    /// See [`Device::is_written`].
    fn is_written(&mut self) {}

    /// See [`Device::take`].
    fn take(&mut self, first: u16, data: &[u8]) -> Option<Result<(), Exception>> {
        let _ = (first, data);
        None
    }

    /// See [`Device::identification`].
    fn identification(&self, object: u8, index: u8) -> Option<u8>;
}

impl<P: Points> Device for P {
    fn has(&self, addresses: &Addresses) -> bool {
        let Addresses {
            table,
            access,
            first,
            count,
        } = *addresses;
        Points::has(self, table, first, count, access)
    }

    fn bits(&mut self, addresses: &Addresses, count: u8, bits: u8) -> u8 {
        let Addresses {
            table,
            access,
            first,
            ..
        } = *addresses;
        let mut read = 0;
        for (n, address) in (0..count).zip(first..=u16::MAX) {
            match access {
                Access::Read => read |= u8::from(self.bit(table, address)) << n,
                Access::Write => self.set_bit(address, bits >> n & 1 != 0),
            }
        }
        read
    }

    fn words(&mut self, addresses: &Addresses, words: &mut [Word]) -> u8 {
        let Addresses {
            table,
            access,
            first,
            ..
        } = *addresses;
        let mut count = 0;
        let most = usize::from(self.at_once().max(2) & 0xFE) - usize::from(first % 2);
        for (word, address) in words.iter_mut().take(most).zip(first..=u16::MAX) {
            match access {
                Access::Read => *word = self.word(table, address).to_be_bytes(),
                Access::Write => self.set_word(address, u16::from_be_bytes(*word)),
            }
            count += 1;
        }
        count
    }

    fn check_words(&self, first: u16, words: &[Word]) -> Result<(), Exception> {
        let mut all = words.iter().zip(first..=u16::MAX);
        all.try_for_each(|(word, address)| self.check_word(address, u16::from_be_bytes(*word)))
    }

    fn is_written(&mut self) {
        Points::is_written(self);
    }

    fn take(&mut self, first: u16, data: &[u8]) -> Option<Result<(), Exception>> {
        Points::take(self, first, data)
    }

    fn identification(&self, object: u8, index: u8) -> Option<u8> {
        Points::identification(self, object, index)
    }
}
