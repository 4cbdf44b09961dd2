//! Numbers that are kept over a power cut (NC-21), in the form of [`unoclp_modbus::eeprom::numbers`].
//!
//! Owns the ring of records, and when one is written: what is written is a snapshot in run memory, a byte at a time.
//! Must not know which numbers these are.

use crate::board::allowance::{self, FIFTH_LAST, LAST, NUMBERS_USED};
use crate::board::eeprom::Eeprom;
use crate::board::watchdog;
use crate::engine::Linked;
use crate::store;
use unoclp_core::Crc16;
use unoclp_modbus::eeprom::numbers;
use unoclp_modbus::eeprom::program::END;

/// More records are not told apart by their sequence numbers.
const MOST_PLACES: u8 = 127;

/// The ring of the program that runs, and what is being written to it.
pub struct Numbers {
    /// Bytes of a record, and how many there are; none where nothing is kept.
    size: u8,
    places: u8,
    /// Where the first record stands.
    first: u16,
    /// Where the newest stands, or the one that is being written; and its sequence number.
    address: u16,
    sequence: u8,
    /// The byte of the record that is written next; 0 where none is being written.
    at: u8,
    /// The checksum of what has been written, and of nothing.
    sum: Crc16,
    seed: Crc16,
    /// Counts steps: at each eighth the numbers are looked at.
    step: u8,
    /// Whether the snapshot is newer than the newest record.
    changed: bool,
}

impl Numbers {
    /// Finds what was kept, and gives it to the program, which has not made a scan yet.
    #[inline(never)]
    pub fn find(plc: &mut Linked<'_>, eeprom: &Eeprom) -> Numbers {
        let stored = plc.stored();
        let first = numbers::first(stored.length);
        let seed = Crc16::starting_at(stored.sum);
        let mut ring = Numbers {
            size: numbers::record(stored.numbers),
            places: 0,
            first,
            // After this one stands the first.
            address: END,
            sequence: 0,
            at: 0,
            sum: seed,
            seed,
            step: 0,
            changed: false,
        };
        if stored.numbers == 0 {
            return ring;
        }
        let size = u16::from(ring.size);
        let mut address = first;
        while address + size <= END && (!cfg!(mega) || ring.places < MOST_PLACES) {
            let mut sum = seed;
            for at in address..address + size {
                sum = sum.then(eeprom.read(at));
            }
            let sequence = eeprom.read(address);
            // Two records differ by less than half of all sequence numbers.
            let is_newer = ring.address == END || (sequence.wrapping_sub(ring.sequence) as i8) > 0;
            if sum.value() == 0 && is_newer {
                (ring.address, ring.sequence) = (address, sequence);
            }
            ring.places += 1;
            address += size;
        }
        let found = ring.address != END;
        if found {
            store::read(eeprom, ring.address + 1, plc.snapshot());
        }
        plc.keep(!found);
        ring
    }

    /// Where the last record may end.
    #[inline(always)]
    fn end(&self) -> u16 {
        if cfg!(mega) {
            self.first + u16::from(self.size) * u16::from(self.places)
        } else {
            END
        }
    }

    /// How many records there are: as many more may be written in [`COST`] minutes.
    pub fn places(&self) -> u8 {
        self.places
    }

    /// One step, to be made between scans; it waits for nothing.
    #[inline(never)]
    pub fn step(&mut self, plc: &mut Linked<'_>, eeprom: &Eeprom, runs: bool) {
        if self.places == 0 || eeprom.is_busy() {
            return;
        }
        if self.at == 0 {
            // Sixteen of them take 80 µs.
            self.step = self.step.wrapping_add(1);
            if !self.step.is_multiple_of(8) {
                return;
            }
            self.changed |= plc.keep(true);
            // RUN leaves some for STOP.
            let most = if runs { FIFTH_LAST } else { LAST };
            if !self.changed || !allowance::take(&NUMBERS_USED, most) {
                return;
            }
            self.changed = false;
            let size = u16::from(self.size);
            self.address += size;
            if self.address + size > self.end() {
                self.address = self.first;
            }
            self.sequence = self.sequence.wrapping_add(1);
            self.sum = self.seed.then(self.sequence);
            self.at = 1;
            return;
        }
        let (mut address, mut byte) = (self.address, self.sequence);
        if self.at == self.size {
            self.at = 0;
        } else {
            // After the numbers the checksum itself, which makes it 0.
            let number = plc.snapshot().get(usize::from(self.at) - 1).copied();
            byte = number.unwrap_or(self.sum.to_be_bytes()[0]);
            self.sum = self.sum.then(byte);
            address += u16::from(self.at);
            self.at += 1;
        }
        eeprom.write(address, byte);
    }

    /// Before the program begins again or goes: ends what is being written, and takes the snapshot.
    #[inline(never)]
    pub fn finish(&mut self, plc: &mut Linked<'_>, eeprom: &Eeprom) {
        while self.at != 0 {
            watchdog::feed();
            self.step(plc, eeprom, true);
        }
        self.changed |= plc.keep(true);
    }
}

// Sequence numbers of as many differ by 127 at most.
#[cfg(not(mega))]
const _: () = assert!((END - numbers::first(2)) / (numbers::record(1) as u16) <= 128);
