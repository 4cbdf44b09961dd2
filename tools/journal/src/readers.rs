//! How far each reader is, and what it has missed.

use std::collections::BTreeMap;

/// A reader.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// The number of the last entry that it has taken, or missed.
    pub number: u64,
    /// Entries that were dropped before it could take them.
    pub dropped: u64,
}

/// All of them, by name.
pub(crate) type Readers = BTreeMap<String, Place>;

/// Up to which number each reader has taken all; without readers, nothing is waited for.
pub(crate) fn taken_by_all(readers: &Readers, last: u64) -> u64 {
    let numbers = readers.values().map(|place| place.number);
    numbers.min().unwrap_or(last)
}

/// The entries up to this number are dropped: who had not taken them has missed them.
pub(crate) fn drop_up_to(readers: &mut Readers, number: u64) {
    for place in readers.values_mut() {
        place.dropped += number.saturating_sub(place.number);
        place.number = place.number.max(number);
    }
}
