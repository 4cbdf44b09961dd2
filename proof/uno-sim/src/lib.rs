//! The unoclp firmware on a simulated Arduino UNO.
//!
//! [`Uno`] runs the very program that is flashed to the board, instruction by instruction and with exact cycle counts,
//! on [simavr](https://github.com/buserror/simavr). Around the chip stand what the wiring says: eight inputs, four
//! outputs, the LED L, a serial line, and a slot for a virtual SD card ([`sd::SdCard`]), which answers as a card does
//! and can be given faults.
//!
//! ```no_run
//! use unoclp_uno_sim::sd::{Kind, SdCard};
//! use unoclp_uno_sim::{Slot, Uno, firmware_file};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let card = SdCard::new(Kind::Sdhc, std::fs::read("card.img")?)?;
//! let mut uno = Uno::new(&firmware_file()?, Slot::Card(card))?;
//! uno.run_ms(500)?;
//! print!("{}", uno.serial());
//! uno.set_input(0, true);
//! uno.run_ms(50)?;
//! println!("outputs {:04b}", uno.outputs());
//! # Ok(())
//! # }
//! ```
//!
//! What simavr does not model as the chip has it, and this crate does: the serial port (buffers, errors, interrupts and
//! times of the line, [`Uno::send_serial`]), the converter ([`Uno::set_analogue`]), the time that an EEPROM write takes,
//! what a power cut leaves behind ([`Uno::power_up`]), the supply voltage, and the stock boot loader's way with MCUSR
//! ([`Uno::set_boot_loader`]).
//!
//! What simavr does not model, and this crate does not add:
//!
//! - the pulses of the timers on the pins, which are told from the registers instead ([`Uno::pwm`]);
//! - nine data bits of the serial port, and the wait for its next baud clock before a start bit; noise of the converter;
//! - brown-out detection, the interrupt EE_READY, the tolerance of the watchdog's own oscillator;
//! - contact bounce, and the speed limits of a card.
//!
//! Owns the simulated chips, what stands around them, and the firmware as an engine of the suite. Must not know the command
//! line.
//!
//! simavr is under the GPL, version 3 or later, and so is this crate.

mod adc;
mod avr;
pub mod avr8js;
mod boot_loader;
mod chip;
mod eeprom;
mod elf;
pub mod engine;
mod error;
mod files;
mod halt;
mod hex;
mod inputs;
mod pins;
pub mod port;
mod program;
mod pwm;
pub mod sd;
mod size;
mod stack;
#[cfg(test)]
mod tests;
mod uart;
mod uno;
mod wiring;

pub use boot_loader::BootLoader;
pub use chip::{Chip, EEPROM_LEN, FLASH_LEN, RAM_END, RAM_START};
pub use eeprom::{EEPROM_WRITE_CYCLES, EepromWrite};
pub use error::Error;
pub use files::{firmware_file, mega_file, nano_file, unshortened_file};
pub use halt::Halt;
pub use inputs::{ANALOGUE_INPUTS, Analogue, INPUTS};
pub use pins::{Edge, OUTPUTS, Pin};
pub use program::{ENLARGED_FLASH_LEN, Program, Space, Symbol};
pub use pwm::Pwm;
pub use uart::{Flaw, Line, Parity, SentByte};
pub use uno::{CYCLES_PER_MS, STALL, Slot, Uno};
