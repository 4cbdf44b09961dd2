//! Where the firmware keeps what scenarios look at and set.

use super::error::EngineError;
use crate::{Program, Space};

/// Where the firmware keeps what scenarios look at and set: in `PAGE`, from there so many bytes on
/// (`firmware/src/engine/data.rs`).
#[derive(Clone, Copy)]
pub(super) struct Memory {
    page: Option<u32>,
}

/// The data of the program, which ends where the page does, so that registers go on after it.
const DATA: u32 = 512 - 227;
/// Two bytes for each reading of an analogue input, A 00 first.
const READINGS: u32 = DATA + 17;
/// A byte for each marker, M 01 first; its highest bit counts.
const MARKERS: u32 = DATA + 35;
/// Four bytes for each register, D 01 first.
const REGISTERS: u32 = DATA + 99;
/// A marker that is 1.
pub(super) const ON: u8 = 0x80;

impl Memory {
    pub fn of(program: &Program) -> Memory {
        let page = program.symbol("PAGE");
        let page = page.filter(|symbol| symbol.space == Space::Data);
        Memory {
            page: page.map(|symbol| symbol.address),
        }
    }

    /// The reading of analogue input A 00.
    pub fn readings(self) -> Result<u32, EngineError> {
        self.at(READINGS)
    }

    /// This marker, from 1.
    pub fn marker(self, number: u8) -> Result<u32, EngineError> {
        self.at(MARKERS + u32::from(number) - 1)
    }

    /// This register, from 1.
    pub fn register(self, number: u8) -> Result<u32, EngineError> {
        self.at(REGISTERS + 4 * (u32::from(number) - 1))
    }

    /// The address of this place in the page.
    fn at(self, place: u32) -> Result<u32, EngineError> {
        self.page
            .map(|page| page + place)
            .ok_or(EngineError::NoSymbol("PAGE"))
    }
}
