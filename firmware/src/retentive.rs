//! Retentive markers: M 57 to M 64, kept in the EEPROM over a power cut (NC-12).
//!
//! Owns how often they are written: one after the other as far as their [allowance](crate::board::allowance)
//! goes, then one a minute. Each writing goes to the next of 32 places, so each place is written every 32nd time: at
//! the 100,000 writings that the chip is good for that is 6 years of a marker that changes every minute, day and night.
//!
//! A place is two bytes: the markers, inverted so that an EEPROM that is new holds none; then a number,
//! by one higher than that of the place before. The number is written last: a place that the supply
//! did not last for has no number that follows, and the place before it counts.

use crate::board::allowance::{self, LAST, MARKERS_USED};
use crate::board::eeprom::Eeprom;
use unoclp_modbus::eeprom::markers::{FIRST, PLACE_BYTES, PLACES};

/// The ring, and what is being written to it.
pub struct Retentive {
    place: u8,
    number: u8,
    /// What was written last, or is being written.
    markers: u8,
    /// Whether the number is still to be written.
    half: bool,
}

impl Retentive {
    /// Finds what was kept.
    #[inline(never)]
    pub fn find(eeprom: &Eeprom) -> Retentive {
        let mut place = 0;
        let mut number = eeprom.read(address(0) + 1);
        while place + 1 < PLACES {
            let next = eeprom.read(address(place + 1) + 1);
            if next != number.wrapping_add(1) {
                break;
            }
            number = next;
            place += 1;
        }
        Retentive {
            place,
            number,
            markers: !eeprom.read(address(place)),
            half: false,
        }
    }

    /// The markers that are kept, bit 0 M 57.
    pub fn markers(&self) -> u8 {
        self.markers
    }

    /// One step, to be called between scans with the markers as they are; it waits for nothing.
    #[inline(never)]
    pub fn step(&mut self, eeprom: &Eeprom, markers: u8) {
        if eeprom.is_busy() {
            return;
        }
        if self.half {
            self.half = false;
            eeprom.write(address(self.place) + 1, self.number);
        } else if markers != self.markers && allowance::take(&MARKERS_USED, LAST) {
            self.place = (self.place + 1) % PLACES;
            self.number = self.number.wrapping_add(1);
            self.markers = markers;
            self.half = true;
            eeprom.write(address(self.place), !markers);
        }
    }
}

fn address(place: u8) -> u16 {
    FIRST + PLACE_BYTES * u16::from(place)
}
