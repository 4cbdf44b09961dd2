//! Which chip a board has, and what that decides: memories, interrupts, and where the pins of the wiring are.

use crate::inputs::{Driven, FIRST_D, Inputs};
use std::ffi::CStr;
use unoclp_core::Board;

/// Flash of the ATmega328P, bytes.
pub const FLASH_LEN: usize = 0x8000;
/// First address of the SRAM in data space; below are the registers.
pub const RAM_START: u32 = 0x100;
/// Last address of the SRAM (RAMEND), where the stack starts.
pub const RAM_END: u32 = 0x8FF;
/// EEPROM of the ATmega328P, bytes.
pub const EEPROM_LEN: usize = 0x400;

/// The chip of a board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chip {
    /// That of the UNO and of the Nano.
    Atmega328p,
    /// That of the Mega 2560.
    Atmega2560,
}

/// The kind of AVR that an ELF file of avr-gcc says it is for, in the low bits of its flags, where it is the ATmega2560.
const AVR6: u32 = 6;
const KINDS: u32 = 0x7F;

/// D6 and D5, D9 and D10.
const UNO_UNITS: &[([u8; 4], u32, [u8; 4], u32)] = &[
    (*b"tmr0", 0, *b"iogD", 6),
    (*b"tmr0", 1, *b"iogD", 5),
    (*b"tmr1", 0, *b"iogB", 1),
    (*b"tmr1", 1, *b"iogB", 2),
];

/// The outputs that timers 3, 4 and 5 can drive.
const MEGA_UNITS: &[([u8; 4], u32, [u8; 4], u32)] = &[
    (*b"tmr3", 0, *b"iogE", 3),
    (*b"tmr3", 1, *b"iogE", 4),
    (*b"tmr3", 2, *b"iogE", 5),
    (*b"tmr4", 0, *b"iogH", 3),
    (*b"tmr4", 1, *b"iogH", 4),
    (*b"tmr4", 2, *b"iogH", 5),
    (*b"tmr5", 0, *b"iogL", 3),
    (*b"tmr5", 1, *b"iogL", 4),
    (*b"tmr5", 2, *b"iogL", 5),
];

impl Chip {
    /// That which the flags of an ELF file name.
    pub(crate) fn of_flags(flags: u32) -> Chip {
        match flags & KINDS {
            AVR6 => Chip::Atmega2560,
            _ => Chip::Atmega328p,
        }
    }

    /// That whose SRAM has this last address.
    pub(crate) fn of_ram_end(address: u32) -> Option<Chip> {
        [Chip::Atmega328p, Chip::Atmega2560]
            .into_iter()
            .find(|chip| chip.ram_end() == address)
    }

    /// The board of the chip.
    pub fn board(self) -> Board {
        match self {
            Chip::Atmega328p => Board::UNO,
            Chip::Atmega2560 => Board::MEGA,
        }
    }

    pub(crate) fn name(self) -> &'static CStr {
        match self {
            Chip::Atmega328p => c"atmega328p",
            Chip::Atmega2560 => c"atmega2560",
        }
    }

    /// Bytes of flash.
    pub fn flash_len(self) -> usize {
        match self {
            Chip::Atmega328p => FLASH_LEN,
            Chip::Atmega2560 => 0x4_0000,
        }
    }

    /// First address of the SRAM in data space; below are the registers.
    pub fn ram_start(self) -> u32 {
        match self {
            Chip::Atmega328p => RAM_START,
            Chip::Atmega2560 => 0x200,
        }
    }

    /// Last address of the SRAM.
    pub fn ram_end(self) -> u32 {
        match self {
            Chip::Atmega328p => RAM_END,
            Chip::Atmega2560 => 0x21FF,
        }
    }

    /// Bytes of EEPROM.
    pub fn eeprom_len(self) -> usize {
        match self {
            Chip::Atmega328p => EEPROM_LEN,
            Chip::Atmega2560 => 0x1000,
        }
    }

    /// The interrupt of the clock, which overflows each millisecond, as the program names it.
    pub(crate) fn tick(self) -> &'static str {
        match self {
            Chip::Atmega328p => "__vector_13",
            Chip::Atmega2560 => "__vector_20",
        }
    }

    /// The first of the three interrupts of USART0.
    pub(crate) fn serial_interrupt(self) -> u8 {
        match self {
            Chip::Atmega328p => 18,
            Chip::Atmega2560 => 25,
        }
    }

    /// The first of those of USART1, which a bus stands at.
    pub(crate) fn bus_interrupt(self) -> Option<u8> {
        match self {
            Chip::Atmega328p => None,
            Chip::Atmega2560 => Some(36),
        }
    }

    /// The interrupt of the converter.
    pub(crate) fn conversion_interrupt(self) -> u8 {
        match self {
            Chip::Atmega328p => 21,
            Chip::Atmega2560 => 29,
        }
    }

    /// The direction register of the port whose pins the converter reads.
    pub(crate) fn analogue_port(self) -> u16 {
        match self {
            Chip::Atmega328p => 0x27,
            Chip::Atmega2560 => 0x30,
        }
    }

    /// Bits of port B: the clock of the card, and the data to it.
    pub(crate) fn card_pins(self) -> (u8, u8) {
        match self {
            Chip::Atmega328p => (1 << 5, 1 << 3),
            Chip::Atmega2560 => (1 << 1, 1 << 2),
        }
    }

    /// Compare units of timers that simavr connects to pins: peripheral, unit, port, bit.
    pub(crate) fn wired_units(self) -> &'static [([u8; 4], u32, [u8; 4], u32)] {
        match self {
            Chip::Atmega328p => UNO_UNITS,
            Chip::Atmega2560 => MEGA_UNITS,
        }
    }

    /// The ports that inputs stand at: letter, data address of the direction register, and what is driven there.
    pub(crate) fn input_ports(self, inputs: &Inputs) -> Vec<(u8, u16, Driven)> {
        let [first, second, third, _] = inputs.closed.to_le_bytes();
        let closed = |mask| Driven { mask, levels: 0 };
        match self {
            Chip::Atmega328p => vec![(b'D', 0x2A, inputs.port_d()), (b'C', 0x27, inputs.port_c())],
            Chip::Atmega2560 => vec![
                (b'A', 0x21, closed(first)),
                (b'K', 0x107, closed(second)),
                (b'C', 0x27, closed(third)),
                (b'D', 0x2A, closed(inputs.stop.into())),
            ],
        }
    }

    /// The bits of a port that inputs stand at.
    pub(crate) fn input_pins(self, port: u8) -> std::ops::Range<u8> {
        match (self, port) {
            (Chip::Atmega328p, b'D') => FIRST_D..FIRST_D + 4,
            (Chip::Atmega328p, _) => 0..6,
            (Chip::Atmega2560, b'D') => 0..1,
            (Chip::Atmega2560, _) => 0..8,
        }
    }
}
