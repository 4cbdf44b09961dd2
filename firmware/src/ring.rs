//! The records of the numbers that a program keeps, in the EEPROM behind the program, in the form of
//! [`unoclp_modbus::eeprom::numbers`].
//!
//! Owns where each record stands and which are whole; must not know when one is written.

use crate::board::eeprom::Eeprom;
use unoclp_core::Crc16;
use unoclp_modbus::eeprom::numbers;
use unoclp_modbus::eeprom::program::END;

/// The ring of a program.
#[derive(Clone, Copy)]
pub struct Ring {
    /// Where the first record stands.
    first: u16,
    /// Bytes of a record.
    pub record: u8,
    /// The check sum of the program, with which that of a record begins.
    seed: u16,
}

/// A record, or none where its address is 0.
#[derive(Clone, Copy)]
pub struct Record {
    pub address: u16,
    pub sequence: u8,
}

impl Ring {
    /// That of a program of this length, which keeps so many numbers and has this check sum.
    pub fn new(length: u16, numbers: u8, seed: u16) -> Ring {
        Ring {
            first: numbers::first(length),
            record: numbers::record(numbers),
            seed,
        }
    }

    /// Whether nothing is kept.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.record == numbers::record(0)
    }

    /// Where the record behind this one stands; behind the last, which the loader leaves room for, the first.
    #[inline(never)]
    pub fn behind(&self, address: u16) -> u16 {
        let record = u16::from(self.record);
        let next = address + record;
        if address < self.first || next > END - record {
            self.first
        } else {
            next
        }
    }

    /// How many records there are.
    pub fn records(&self) -> u16 {
        let mut records = 0;
        let mut at = self.first;
        loop {
            records += 1;
            at = self.behind(at);
            if at == self.first {
                return records;
            }
        }
    }

    /// The check sum of no bytes of a record so far.
    #[inline(always)]
    pub fn sum(&self) -> Crc16 {
        Crc16::starting_at(self.seed)
    }

    /// The newest record that is whole. Where all are to be forgotten, no record is whole from then on.
    #[inline(never)]
    pub fn newest(&self, eeprom: &Eeprom, forget: bool) -> Record {
        let mut newest = Record {
            address: 0,
            sequence: 0,
        };
        let mut address = self.first;
        loop {
            let mut sum = self.sum();
            for byte in 0..self.record {
                sum.push(eeprom.read(address + u16::from(byte)));
            }
            if sum.value() == 0 {
                let sequence = eeprom.read(address);
                if forget {
                    eeprom.write(address, !sequence);
                }
                // Two of them differ by less than half of all sequence numbers.
                if newest.address == 0 || (sequence.wrapping_sub(newest.sequence) as i8) > 0 {
                    newest = Record { address, sequence };
                }
            }
            address = self.behind(address);
            if address == self.first {
                return newest;
            }
        }
    }
}

// Sequence numbers of as many differ by 127 at most.
const _: () = assert!((END - numbers::first(2)) / (numbers::record(1) as u16) <= 128);
