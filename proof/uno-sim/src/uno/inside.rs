//! Inside the chip: symbols, RAM, flash, EEPROM, clock and stack.

use super::Uno;
use crate::Error;
use crate::avr::reg;
use crate::eeprom::EepromWrite;
use crate::program::{Program, Symbol};
use crate::stack;
use std::ops::Range;

impl Uno {
    /// The program: its symbols, and where its static data ends.
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// A symbol of the program.
    pub fn symbol(&self, name: &str) -> Option<Symbol> {
        self.program.symbol(name)
    }

    /// `len` bytes of data space from `address`: registers below 0x100, then RAM up to 0x8FF. Registers are read as
    /// they stand, without the side effects that a read by the program has.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where they do not all lie there.
    pub fn read_ram(&self, address: u32, len: usize) -> Result<&[u8], Error> {
        let range = range("RAM", 0..self.chip().ram_end() as usize + 1, address, len)?;
        Ok(&self.avr.data()[range])
    }

    /// Writes bytes into RAM, 0x100 to 0x8FF.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where they do not all lie there.
    pub fn write_ram(&mut self, address: u32, bytes: &[u8]) -> Result<(), Error> {
        let range = range(
            "RAM",
            self.chip().ram_start() as usize..self.chip().ram_end() as usize + 1,
            address,
            bytes.len(),
        )?;
        self.avr.data_mut()[range].copy_from_slice(bytes);
        Ok(())
    }

    /// Copies `len` bytes of the program from byte address `address` of the flash.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where they do not all belong to the program that was loaded.
    pub fn read_flash(&self, address: u32, len: usize) -> Result<Vec<u8>, Error> {
        let range = self.code_range(address, len)?;
        Ok(self.avr.flash()[range].to_vec())
    }

    /// Writes bytes into the program, at once, as an error in it would; low byte of an instruction first. A program that
    /// is to hang somewhere gets a [`STALL`](crate::STALL) there.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where they do not all belong to the program that was loaded.
    pub fn patch_flash(&mut self, address: u32, bytes: &[u8]) -> Result<(), Error> {
        let range = self.code_range(address, bytes.len())?;
        self.avr.flash_mut()[range].copy_from_slice(bytes);
        Ok(())
    }

    fn code_range(&self, address: u32, len: usize) -> Result<Range<usize>, Error> {
        range("program", 0..self.code_end as usize, address, len)
    }

    /// Copies `len` bytes of EEPROM from `address` (0 to 0x3FF). A byte that is being written still has its old value.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where they do not all lie there.
    pub fn read_eeprom(&self, address: u16, len: usize) -> Result<Vec<u8>, Error> {
        let range = range("EEPROM", 0..self.chip().eeprom_len(), address.into(), len)?;
        Ok(self.wired.eeprom.bytes()[range].to_vec())
    }

    /// Writes bytes into the EEPROM, at once and without an entry in [`Uno::eeprom_writes`].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where they do not all fit there.
    pub fn write_eeprom(&mut self, address: u16, bytes: &[u8]) -> Result<(), Error> {
        let range = range(
            "EEPROM",
            0..self.chip().eeprom_len(),
            address.into(),
            bytes.len(),
        )?;
        self.wired.eeprom.bytes_mut()[range].copy_from_slice(bytes);
        Ok(())
    }

    /// Every byte that the program has written to the EEPROM since the board was made, in order of time. A write that is
    /// still going on is not among them.
    pub fn eeprom_writes(&self) -> &[EepromWrite] {
        self.wired.eeprom.writes()
    }

    /// How often the program has written each byte of the EEPROM since the board was made, by address; the chip stands
    /// 100,000 writes of a byte. A write that is still going on does not count yet.
    pub fn eeprom_wear(&self) -> Vec<u32> {
        self.wired.eeprom.wear()
    }

    /// Whether a byte of the EEPROM is being written.
    pub fn eeprom_is_busy(&self) -> bool {
        self.wired.eeprom.is_busy()
    }

    /// Switches the timer interrupts off: the program's millisecond clock stands, and shows what a test writes to it.
    pub fn stop_clock(&mut self) {
        self.avr.set_register(reg::TIMSK1, 0);
    }

    /// The stack pointer: the address of the next byte to be pushed.
    pub fn sp(&self) -> u16 {
        stack::sp(&self.avr)
    }

    /// The lowest stack pointer since power-up or [`Uno::reset_min_sp`]. The stack has then filled the bytes above it, up
    /// to 0x8FF.
    pub fn min_sp(&self) -> u16 {
        self.stack.min()
    }

    /// Starts measuring the stack again, from where it is now.
    pub fn reset_min_sp(&mut self) {
        self.stack.restart(&self.avr);
    }

    /// The most bytes of stack in use since power-up or [`Uno::reset_min_sp`].
    pub fn stack_peak(&self) -> u16 {
        (self.chip().ram_end() as u16).saturating_sub(self.min_sp())
    }

    /// Bytes between static data and the deepest point of the stack; negative where the stack ran into them.
    pub fn stack_free(&self) -> i32 {
        i32::from(self.min_sp()) + 1 - self.static_ram_end() as i32
    }

    /// First address above `.data`, `.bss` and `.noinit`.
    pub fn static_ram_end(&self) -> u32 {
        self.program.static_ram_end
    }
}

/// The range of `len` bytes from `address`, where it lies in `memory`.
fn range(
    name: &'static str,
    memory: Range<usize>,
    address: u32,
    len: usize,
) -> Result<Range<usize>, Error> {
    let start = address as usize;
    match start.checked_add(len) {
        Some(end) if start >= memory.start && end <= memory.end => Ok(start..end),
        _ => Err(Error::OutOfRange {
            memory: name,
            address,
            len,
        }),
    }
}
