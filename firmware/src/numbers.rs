//! Numbers that are kept over a power cut (NC-21): when a record of them is written.
//!
//! What is written is a snapshot in run memory, a byte at a time. An allowance, which outlives a reset, tells
//! whether another record may be begun: each minute adds as much to it as there are records, and each
//! record takes [`RECORDED`] from it. So every place is written once in 53 minutes in the long run.

use crate::board::eeprom::Eeprom;
use crate::board::watchdog::{self, RECORDED_MOST};
use crate::engine::Linked;
use crate::ring::{Record, Ring};
use unoclp_core::{Crc16, RECORDED};

/// What one record takes from the allowance.
const COST: u16 = RECORDED as u16;
/// What RUN leaves for STOP.
const FOR_STOP: u16 = 4 * COST;

/// The ring of the program that runs, and what is being written to it.
pub struct Numbers {
    ring: Ring,
    /// The newest record, or the one that is being written.
    record: Record,
    /// The byte of the record that is written next; 0 where none is being written.
    at: u8,
    /// The check sum of what has been written.
    sum: Crc16,
    /// The number that is looked at next.
    next: u8,
    /// Whether the snapshot is newer than the newest record.
    changed: bool,
}

impl Numbers {
    /// Finds what was kept, and gives it to the program, which has not made a scan yet.
    #[inline(never)]
    pub fn find(plc: &mut Linked<'_>, eeprom: &Eeprom) -> Numbers {
        let ring = plc.ring();
        let mut record = Record {
            address: 0,
            sequence: 0,
        };
        if !ring.is_empty() {
            record = ring.newest(eeprom, false);
        }
        if record.address != 0 {
            let mut address = record.address;
            for byte in plc.snapshot() {
                address += 1;
                *byte = eeprom.read(address);
            }
            plc.copy(eeprom, false);
        }
        Numbers {
            ring,
            record,
            at: 0,
            sum: ring.sum(),
            next: 0,
            changed: false,
        }
    }

    /// A minute has passed.
    pub fn minute(&mut self) {
        let more = watchdog::recording() + self.ring.records();
        watchdog::set_recording(more.min(RECORDED_MOST));
    }

    /// One step, to be made between scans; it waits for nothing.
    #[inline(never)]
    pub fn step(&mut self, plc: &mut Linked<'_>, eeprom: &Eeprom, runs: bool) {
        if self.ring.is_empty() || eeprom.is_busy() {
            return;
        }
        if self.at == 0 {
            let reserve = if runs { FOR_STOP } else { 0 };
            let Some(left) = watchdog::recording().checked_sub(COST) else {
                return;
            };
            if left < reserve || !self.has_changed(plc, eeprom) {
                return;
            }
            watchdog::set_recording(left);
            self.changed = false;
            self.record.address = self.ring.behind(self.record.address);
            self.record.sequence = self.record.sequence.wrapping_add(1);
            self.sum = self.ring.sum();
            self.sum.push(self.record.sequence);
            self.at = 1;
        }
        let Record { address, sequence } = self.record;
        if self.at == self.ring.record {
            self.at = 0;
            return eeprom.write(address, sequence);
        }
        let address = address + u16::from(self.at);
        let number = plc.snapshot().get(usize::from(self.at) - 1).copied();
        // Behind the numbers the check sum itself, which makes it 0.
        let byte = number.unwrap_or(self.sum.to_be_bytes()[0]);
        self.sum.push(byte);
        self.at += 1;
        eeprom.write(address, byte);
    }

    /// Whether there is something to be written; then the snapshot holds it. Of the numbers, each call looks at one.
    fn has_changed(&mut self, plc: &mut Linked<'_>, eeprom: &Eeprom) -> bool {
        if self.changed {
            return true;
        }
        let index = self.next;
        self.next = index + 1;
        match plc.kept(eeprom, index) {
            None => self.next = 0,
            Some((number, snapshot)) if number == snapshot => {}
            Some(_) => return plc.copy(eeprom, true),
        }
        false
    }

    /// Before the program begins anew: ends what is being written, and takes the snapshot.
    #[inline(never)]
    pub fn finish(&mut self, plc: &mut Linked<'_>, eeprom: &Eeprom) {
        while self.at != 0 {
            watchdog::feed();
            self.step(plc, eeprom, true);
        }
        if plc.copy(eeprom, true) {
            self.changed = true;
        }
    }
}
