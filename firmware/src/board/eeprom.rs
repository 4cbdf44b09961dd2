//! The EEPROM: 1,024 bytes that outlast power (ATmega328P datasheet, section 8.4).

use super::chip::EEPROM;
use avr_device::interrupt;

/// The EEPROM.
pub struct Eeprom {
    registers: EEPROM,
}

impl Eeprom {
    /// Takes the registers.
    pub fn new(registers: EEPROM) -> Eeprom {
        Eeprom { registers }
    }

    /// The byte at an address; addresses beyond the last begin again.
    pub fn read(&self, address: u16) -> u8 {
        self.wait();
        self.registers.eear().write(|w| w.set(address));
        self.registers.eecr().write(|w| w.eere().set_bit());
        self.registers.eedr().read().bits()
    }

    /// Writes a byte where it differs from what is there. Takes 3.4 ms in the background; the
    /// next read or write waits for it.
    pub fn write(&self, address: u16, byte: u8) {
        if self.read(address) == byte {
            return;
        }
        self.registers.eedr().write(|w| w.set(byte));
        // The second bit must follow the first within four cycles.
        interrupt::free(|_| {
            self.registers.eecr().write(|w| w.eempe().set_bit());
            self.registers.eecr().modify(|_, w| w.eepe().set_bit());
        });
    }

    /// Whether a byte is still being written.
    pub fn is_busy(&self) -> bool {
        self.registers.eecr().read().eepe().bit_is_set()
    }

    fn wait(&self) {
        while self.is_busy() {}
    }
}
