//! Where the firmware keeps what scenarios look at and set.

use super::error::EngineError;
use crate::{Chip, Program, Space};

/// Where the firmware keeps what scenarios look at and set: in `PAGE`, from there so many bytes on
/// (`firmware/src/engine/data.rs`).
#[derive(Clone, Copy)]
pub(super) struct Memory {
    page: Option<u32>,
    places: Places,
}

/// Where the data of the program begins, and in it the readings of analogue inputs, two bytes each, A 00 first; the
/// markers, a byte each, M 01 first; and the registers, four bytes each, D 01 first. The data ends where the page does, so
/// that registers go on after it.
#[derive(Clone, Copy)]
struct Places {
    readings: u32,
    markers: u32,
    registers: u32,
}

impl Places {
    const fn of(bytes: u32, readings: u32, markers: u32, registers: u32) -> Places {
        let data = 512 - bytes;
        Places {
            readings: data + readings,
            markers: data + markers,
            registers: data + registers,
        }
    }
}

const UNO: Places = Places::of(227, 17, 35, 99);
const MEGA: Places = Places::of(273, 16, 81, 145);

/// A marker that is 1.
pub(super) const ON: u8 = 0x80;

impl Memory {
    pub fn of(program: &Program) -> Memory {
        let page = program.symbol("PAGE");
        let page = page.filter(|symbol| symbol.space == Space::Data);
        Memory {
            page: page.map(|symbol| symbol.address),
            places: match program.chip() {
                Chip::Atmega328p => UNO,
                Chip::Atmega2560 => MEGA,
            },
        }
    }

    /// The reading of analogue input A 00.
    pub fn readings(self) -> Result<u32, EngineError> {
        self.at(self.places.readings)
    }

    /// This marker, from 1.
    pub fn marker(self, number: u8) -> Result<u32, EngineError> {
        self.at(self.places.markers + u32::from(number) - 1)
    }

    /// This register, from 1.
    pub fn register(self, number: u8) -> Result<u32, EngineError> {
        self.at(self.places.registers + 4 * (u32::from(number) - 1))
    }

    /// The address of this place in the page.
    fn at(self, place: u32) -> Result<u32, EngineError> {
        self.page
            .map(|page| page + place)
            .ok_or(EngineError::NoSymbol("PAGE"))
    }
}
