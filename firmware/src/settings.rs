//! The settings of the serial line and of its server, kept in the EEPROM in the form of [`unoclp_modbus::eeprom::settings`].

use crate::board::allowance::{self, LAST, SETTINGS_USED};
use crate::board::clock::CLOCK_HZ;
use crate::board::eeprom::Eeprom;
use crate::board::serial::Line;
use crate::store;
use unoclp_core::Crc16;
use unoclp_modbus::Exception;
use unoclp_modbus::eeprom::settings::{BYTES, FIRST, OLD, OLD_BYTES, SECOND, VALID};
use unoclp_modbus::map::{Parity, Setting, setting};

// The numbers of the settings.
const ADDRESS: u8 = 0;
const RATE: u8 = 1;
const PARITY: u8 = 2;
const DIRECTION: u8 = 3;
const LOCK: u8 = 4;

// The defaults are set over zeros.
const _: () =
    assert!(setting::PARITY.default | setting::DIRECTION.default | setting::LOCK.default == 0);

/// Clock cycles of 8 in a second, in hundreds.
const EIGHTHS: u16 = (CLOCK_HZ / 8 / 100) as u16;

/// The server's address; the rate in 100 baud; parity, 0 none, 1 even, 2 odd; whether A4 is the direction of
/// an RS-485 driver; what the server refuses.
#[repr(C)]
pub struct Settings {
    /// A word each, low byte first, and the checksum.
    bytes: [u8; BYTES],
    /// Whether they are as they are kept.
    kept: Kept,
}

/// Whether settings are as they are kept. As a byte any bits are a value.
type Kept = u8;
const AS_KEPT: Kept = 0;
/// The defaults took the place of what is kept: whichever is set, all of them are to be kept.
const DEFAULTS: Kept = 1;
const CHANGED: Kept = 2;

impl Settings {
    /// None yet.
    pub const fn new() -> Settings {
        Settings {
            bytes: [0; BYTES],
            kept: AS_KEPT,
        }
    }

    /// Takes what is kept, or the defaults. They are as they are [made](Settings::new), in their place: given back,
    /// they would stand on the stack too.
    #[inline(never)]
    pub fn load(&mut self, eeprom: &Eeprom, defaults: bool) {
        if !defaults {
            if self.read_slot(eeprom, FIRST) || self.read_slot(eeprom, SECOND) {
                // A slot that is damaged is mended, as far as the other can.
                self.keep(eeprom);
                return;
            }
            if self.read(eeprom, OLD, OLD_BYTES) {
                return;
            }
        }
        self.bytes.fill(0);
        self.set(ADDRESS, setting::ADDRESS.default);
        self.set(RATE, setting::RATE.default);
        self.kept = DEFAULTS;
    }

    #[inline(always)]
    fn read_slot(&mut self, eeprom: &Eeprom, slot: u16) -> bool {
        eeprom.read(slot) == VALID && self.read(eeprom, slot + 1, BYTES)
    }

    /// Takes what stands here, so many bytes with their checksum; says whether it is sound. Settings after it
    /// are 0.
    #[inline(never)]
    fn read(&mut self, eeprom: &Eeprom, address: u16, bytes: usize) -> bool {
        self.bytes.fill(0);
        let kept = self.bytes.get_mut(..bytes).unwrap_or_default();
        store::read(eeprom, address, kept);
        let is_sound = Crc16::of(kept).value() == 0;
        if let [.., high, low] = kept {
            (*high, *low) = (0, 0);
        }
        is_sound && self.address() != 0
    }

    /// Keeps them, where they have changed. Takes 110 ms at most.
    #[inline(never)]
    pub fn save(&mut self, eeprom: &Eeprom) {
        if self.kept != CHANGED {
            return;
        }
        self.kept = AS_KEPT;
        allowance::take(&SETTINGS_USED, LAST);
        self.keep(eeprom);
    }

    /// Writes them to both slots, bytes that differ. While one is being written, the other counts.
    #[inline(never)]
    fn keep(&mut self, eeprom: &Eeprom) {
        let [values @ .., high, low] = &mut self.bytes;
        [*high, *low] = Crc16::of(values).to_be_bytes();
        self.write_slot(eeprom, SECOND);
        self.write_slot(eeprom, FIRST);
        eeprom.write(OLD, 0);
    }

    #[inline(never)]
    fn write_slot(&self, eeprom: &Eeprom, slot: u16) {
        store::write(eeprom, slot + 1, &self.bytes);
        eeprom.write(slot, VALID);
    }

    /// A setting, by its number.
    pub fn get(&self, number: u8) -> u16 {
        match self.bytes.get(usize::from(number) * 2..) {
            Some([low, high, ..]) => u16::from_le_bytes([*low, *high]),
            _ => 0,
        }
    }

    /// Sets one.
    #[inline(never)]
    pub fn set(&mut self, number: u8, value: u16) {
        if let Some([low, high, ..]) = self.bytes.get_mut(usize::from(number) * 2..) {
            let old = u16::from_le_bytes([*low, *high]);
            if old != value || self.kept == DEFAULTS {
                [*low, *high] = value.to_le_bytes();
                self.kept = CHANGED;
            }
        }
    }

    /// Whether one may have this value now.
    ///
    /// # Errors
    /// The exception to answer: out of its range, or a lock less than there is; or they have been kept too often.
    #[inline(never)]
    pub fn check(&self, number: u8, value: u16) -> Result<(), Exception> {
        const fn range(setting: Setting) -> (u16, u16) {
            (setting.least, setting.most)
        }
        let (least, most) = match number {
            ADDRESS => const { range(setting::ADDRESS) },
            RATE => const { range(setting::RATE) },
            PARITY => const { range(setting::PARITY) },
            DIRECTION => const { range(setting::DIRECTION) },
            _ => const { range(setting::LOCK) },
        };
        let lifts = number == LOCK && self.locks() & !(value as u8) != 0;
        if value < least || value > most || lifts {
            Err(Exception::IllegalDataValue)
        } else if SETTINGS_USED.get() > LAST {
            Err(Exception::ServerDeviceBusy)
        } else {
            Ok(())
        }
    }

    /// What the server refuses: bits of [`lock`](unoclp_modbus::lock).
    pub fn locks(&self) -> u8 {
        self.low(LOCK)
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
        self.bytes[2 * usize::from(number)]
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
