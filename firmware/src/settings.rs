//! The settings of the serial line, kept in the EEPROM.
//!
//! | byte | |
//! | --- | --- |
//! | 908 … 915 | address, rate, parity, direction: a word each, low byte first |
//! | 916, 917 | CRC-16 of these, low byte first |
//!
//! What is damaged or was written in part are the defaults.

use crate::board::eeprom::Eeprom;
use unoclp_core::Crc16;

const PLACE: u16 = 908;
/// How many settings there are; they have the numbers 0 address, 1 rate, 2 parity, 3 direction.
pub const COUNT: u8 = 4;

/// Clock cycles of 8 in a second, in hundreds.
const EIGHTHS: u16 = (crate::board::CLOCK_HZ / 8 / 100) as u16;

/// The settings that the line has until the next start.
pub struct Settings {
    /// The server's address.
    pub address: u8,
    /// In 100 baud.
    rate: u16,
    /// 0 none, 1 even, 2 odd.
    parity: u8,
    /// Whether A4 is the direction of an RS-485 driver.
    pub direction: bool,
}

impl Settings {
    /// What is kept, or the defaults.
    pub fn load(eeprom: &Eeprom, defaults: bool) -> Settings {
        let setting = |number| {
            if defaults {
                default(number)
            } else {
                read(eeprom, number)
            }
        };
        Settings {
            address: setting(0) as u8,
            rate: setting(1),
            parity: setting(2) as u8,
            direction: setting(3) != 0,
        }
    }

    /// The divider of the rate with U2X, rounded: at 115200 baud 17, which is 117647 baud, 2.1 % fast, as the
    /// Arduino core has it. By subtraction, since a division would cost flash.
    pub fn divider(&self) -> u16 {
        let mut rest = EIGHTHS + self.rate / 2;
        let mut divider = 0;
        while rest >= self.rate {
            rest -= self.rate;
            divider += 1;
        }
        divider
    }

    /// UPM0.
    pub fn parity_bits(&self) -> u8 {
        match self.parity {
            0 => 0,
            1 => 0b10 << 4,
            _ => 0b11 << 4,
        }
    }
}

fn default(number: u8) -> u16 {
    match number {
        0 => 1,
        1 => 1152,
        _ => 0,
    }
}

/// Whether a setting may have this value.
#[inline(never)]
pub fn allows(number: u8, value: u16) -> bool {
    let (least, most) = match number {
        0 => (1, 247),
        1 => (24, 1152),
        2 => (0, 2),
        _ => (0, 1),
    };
    value >= least && value <= most
}

/// A setting that is kept, or its default.
#[inline(never)]
pub fn read(eeprom: &Eeprom, number: u8) -> u16 {
    let mut crc = Crc16::default();
    let mut sound = true;
    let mut found = 0;
    for index in 0..COUNT {
        let value = word(eeprom, index);
        let [low, high] = value.to_le_bytes();
        crc.push(low);
        crc.push(high);
        sound &= allows(index, value);
        if index == number {
            found = value;
        }
    }
    if sound && word(eeprom, COUNT) == crc.value() {
        found
    } else {
        default(number)
    }
}

/// Keeps a setting. It takes up to 14 ms.
#[inline(never)]
pub fn write(eeprom: &Eeprom, number: u8, value: u16) {
    let mut values = [0; COUNT as usize];
    let mut index = 0;
    for place in &mut values {
        *place = if index == number {
            value
        } else {
            read(eeprom, index)
        };
        index += 1;
    }
    let mut crc = Crc16::default();
    let mut address = PLACE;
    for value in values {
        for byte in value.to_le_bytes() {
            crc.push(byte);
            eeprom.write(address, byte);
            address += 1;
        }
    }
    for byte in crc.value().to_le_bytes() {
        eeprom.write(address, byte);
        address += 1;
    }
}

fn word(eeprom: &Eeprom, index: u8) -> u16 {
    let address = PLACE + u16::from(index) * 2;
    u16::from_le_bytes([eeprom.read(address), eeprom.read(address + 1)])
}
