//! The settings of the serial line, kept in the EEPROM in the form of [`unoclp_modbus::eeprom::settings`].

use crate::board::clock::CLOCK_HZ;
use crate::board::eeprom::Eeprom;
use crate::board::serial::Line;
use crate::store;
use unoclp_core::Crc16;
use unoclp_modbus::eeprom::settings::{BYTES, FIRST};
use unoclp_modbus::map::{Parity, Setting, setting};

// The numbers of the settings.
const ADDRESS: u8 = 0;
const RATE: u8 = 1;
const PARITY: u8 = 2;
const DIRECTION: u8 = 3;

// The defaults are set over zeros.
const _: () = assert!(setting::PARITY.default == 0 && setting::DIRECTION.default == 0);

/// Clock cycles of 8 in a second, in hundreds.
const EIGHTHS: u16 = (CLOCK_HZ / 8 / 100) as u16;

/// The server's address; the rate in 100 baud; parity, 0 none, 1 even, 2 odd; whether A4 is the direction of
/// an RS-485 driver.
#[derive(Clone, Copy)]
pub struct Settings([u8; BYTES]);

impl Settings {
    /// What is kept, or the defaults.
    #[inline(never)]
    pub fn load(eeprom: &Eeprom, defaults: bool) -> Settings {
        let mut settings = Settings([0; BYTES]);
        for (address, byte) in (FIRST..).zip(&mut settings.0) {
            *byte = eeprom.read(address);
        }
        if defaults || Crc16::of(&settings.0).value() != 0 || settings.address() == 0 {
            settings.0.fill(0);
            settings.set(ADDRESS, setting::ADDRESS.default);
            settings.set(RATE, setting::RATE.default);
        }
        settings
    }

    /// Keeps them. Takes 34 ms at most.
    #[inline(never)]
    pub fn save(&mut self, eeprom: &Eeprom) {
        let [values @ .., high, low] = &mut self.0;
        [*high, *low] = Crc16::of(values).value().to_be_bytes();
        store::write(eeprom, FIRST, &self.0);
    }

    /// A setting, by its number.
    #[inline(never)]
    pub fn get(&self, number: u8) -> u16 {
        match self.0.get(usize::from(number) * 2..) {
            Some([low, high, ..]) => u16::from_le_bytes([*low, *high]),
            _ => 0,
        }
    }

    /// Sets one.
    #[inline(never)]
    pub fn set(&mut self, number: u8, value: u16) {
        if let Some([low, high, ..]) = self.0.get_mut(usize::from(number) * 2..) {
            [*low, *high] = value.to_le_bytes();
        }
    }

    /// The line that they describe.
    #[inline(always)]
    pub fn line(&self) -> Line {
        Line {
            address: self.address(),
            divider: self.divider(),
            parity_bits: self.parity_bits(),
            has_direction: self.low(DIRECTION) != 0,
        }
    }

    /// The server's address.
    fn address(&self) -> u8 {
        self.low(ADDRESS)
    }

    /// The low byte of a setting.
    #[inline(always)]
    fn low(&self, number: u8) -> u8 {
        self.0[2 * usize::from(number)]
    }

    /// The divider of the rate with U2X, rounded: at 115200 baud 17, which is 117647 baud, 2.1 % fast, as the
    /// Arduino core has it. By subtraction, since a division would cost flash.
    fn divider(&self) -> u16 {
        let rate = self.get(RATE);
        let mut rest = EIGHTHS + rate / 2;
        let mut divider = 0;
        while rest >= rate {
            rest -= rate;
            divider += 1;
        }
        divider
    }

    /// UPM0, in its place.
    fn parity_bits(&self) -> u8 {
        match Parity::of(self.low(PARITY).into()) {
            Some(Parity::None) => 0,
            Some(Parity::Even) => 0b10 << 4,
            _ => 0b11 << 4,
        }
    }
}

/// Whether a setting may have this value.
#[inline(never)]
pub fn allows(number: u8, value: u16) -> bool {
    const fn range(setting: Setting) -> (u16, u16) {
        (setting.least, setting.most)
    }
    let (least, most) = match number {
        ADDRESS => const { range(setting::ADDRESS) },
        RATE => const { range(setting::RATE) },
        PARITY => const { range(setting::PARITY) },
        _ => const { range(setting::DIRECTION) },
    };
    value >= least && value <= most
}
