//! Rate and form of the characters on a serial line.

use crate::avr::CLOCK_HZ;

/// The bit after the data bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Parity {
    /// There is none.
    #[default]
    None,
    /// It makes the number of ones even.
    Even,
    /// It makes the number of ones odd.
    Odd,
}

impl Parity {
    /// The bit that belongs to a byte.
    pub(super) fn bit(self, byte: u8) -> Option<bool> {
        let odd = byte.count_ones() % 2 == 1;
        match self {
            Parity::None => None,
            Parity::Even => Some(odd),
            Parity::Odd => Some(!odd),
        }
    }
}

/// How the other end of the line sends: 8 data bits, 1 stop bit. At first 115200 8N1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// Bits a second; not 0.
    pub baud: u32,
    /// The bit after the data bits.
    pub parity: Parity,
}

impl Default for Line {
    fn default() -> Line {
        Line {
            baud: 115_200,
            parity: Parity::None,
        }
    }
}

impl Line {
    /// Cycles of so many characters sent without a gap. That of each is rounded.
    pub fn cycles(self, characters: u64) -> u64 {
        let bits = if self.parity == Parity::None { 10 } else { 11 };
        characters * self.bits(bits)
    }

    /// Cycles of so many bits, rounded.
    pub(super) fn bits(self, bits: u64) -> u64 {
        let baud = u64::from(self.baud);
        (bits * u64::from(CLOCK_HZ) + baud / 2) / baud
    }
}

/// What is wrong with a character on the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flaw {
    /// The stop bit is 0.
    Framing,
    /// The parity bit is inverted; without parity the last data bit is, and nobody can tell.
    Parity,
}

/// How the chip sends and receives, from its registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Setting {
    pub cycles_per_bit: u64,
    pub data_bits: u64,
    pub parity: Parity,
    pub stop_bits: u64,
}

impl Setting {
    /// From UBRR0, UCSR0A and UCSR0C (tables 19-1, 19-9 to 19-11).
    pub fn of(divider: u16, status: u8, form: u8) -> Setting {
        let clocks = if status & super::U2X == 0 { 16 } else { 8 };
        Setting {
            // UBRR0 has twelve bits.
            cycles_per_bit: clocks * (u64::from(divider & 0x0FFF) + 1),
            data_bits: 5 + u64::from(form >> 1 & 3),
            parity: match form >> 4 & 3 {
                2 => Parity::Even,
                3 => Parity::Odd,
                _ => Parity::None,
            },
            stop_bits: 1 + u64::from(form >> 3 & 1),
        }
    }

    /// Bits before the first stop bit.
    pub(super) fn bits_before_stop(self) -> u64 {
        1 + self.data_bits + u64::from(self.parity != Parity::None)
    }

    /// Cycles of a character.
    pub(super) fn cycles(self) -> u64 {
        (self.bits_before_stop() + self.stop_bits) * self.cycles_per_bit
    }
}
