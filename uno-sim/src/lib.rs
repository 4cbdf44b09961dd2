//! The unoclp firmware on a simulated Arduino UNO.
//!
//! [`Uno`] runs the very ELF file that is flashed to the board, instruction by instruction and with exact cycle counts,
//! on [simavr](https://github.com/buserror/simavr). Around the chip stand what the wiring says: four buttons, four
//! outputs, the LED L, a serial line, and a slot for a virtual SD card ([`sd::SdCard`]), which answers as a card does
//! and can be given faults.
//!
//! ```no_run
//! use unoclp_uno_sim::sd::{Kind, SdCard};
//! use unoclp_uno_sim::{Slot, Uno, firmware_elf};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let card = SdCard::new(Kind::Sdhc, std::fs::read("card.img")?)?;
//! let mut uno = Uno::new(&firmware_elf()?, Slot::Card(card))?;
//! uno.run_ms(500)?;
//! print!("{}", uno.serial());
//! uno.set_input(0, true);
//! uno.run_ms(50)?;
//! println!("outputs {:04b}", uno.outputs());
//! # Ok(())
//! # }
//! ```
//!
//! What simavr does not model, and this crate adds: the time that an EEPROM write takes, what a power cut leaves behind
//! ([`Uno::power_up`]), the supply voltage, and the stock boot loader's way with MCUSR ([`Uno::set_boot_loader`]).
//!
//! What simavr does not model, and this crate does not add:
//!
//! - the two-byte receive buffer of the serial port: simavr has 64 bytes, and counts a byte as 11 bits;
//! - the time of a conversion of the ADC: simavr takes 24 of its clocks, 168 for the first, where the chip takes 13 and
//!   25. It scales to 1023 at the reference, the chip to 1024; and the internal reference needs no time to settle;
//! - brown-out detection, the interrupt EE_READY, the tolerance of the watchdog's own oscillator;
//! - contact bounce, and the speed limits of a card.
//!
//! simavr is under the GPL, version 3 or later, and so is this crate.

mod avr;
mod eeprom;
mod elf;
pub mod engine;
mod error;
mod halt;
mod pins;
pub mod sd;
mod size;
mod stack;
#[cfg(test)]
mod tests;
mod uno;
mod wiring;

pub use eeprom::{EEPROM_WRITE_CYCLES, EepromWrite};
pub use elf::{EEPROM_LEN, FLASH_LEN, Program, RAM_END, RAM_START, Space, Symbol, firmware_elf};
pub use error::Error;
pub use halt::Halt;
pub use pins::{Edge, POINTS, Pin};
pub use uno::{CYCLES_PER_MS, STALL, Slot, Uno};
