//! Inside the chip: symbols, RAM, EEPROM, clock and stack.

use super::Uno;
use crate::Error;
use crate::avr::reg;
use crate::elf::{Program, RAM_END, RAM_START, Symbol};
use crate::stack;

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
        let range = data_range(0, address, len)?;
        Ok(&self.avr.data()[range])
    }

    /// Writes bytes into RAM, 0x100 to 0x8FF.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where they do not all lie there.
    pub fn write_ram(&mut self, address: u32, bytes: &[u8]) -> Result<(), Error> {
        let range = data_range(RAM_START, address, bytes.len())?;
        self.avr.data_mut()[range].copy_from_slice(bytes);
        Ok(())
    }

    /// Copies `len` bytes of EEPROM from `address` (0 to 0x3FF).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where they do not all lie there.
    pub fn read_eeprom(&mut self, address: u16, len: usize) -> Result<Vec<u8>, Error> {
        let mut bytes = vec![0; len];
        let read = self.avr.read_eeprom(address, &mut bytes);
        read.then_some(bytes).ok_or(out_of_eeprom(address, len))
    }

    /// Writes bytes into the EEPROM, at once.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where they do not all fit there.
    pub fn write_eeprom(&mut self, address: u16, bytes: &[u8]) -> Result<(), Error> {
        let written = self.avr.write_eeprom(address, bytes);
        written
            .then_some(())
            .ok_or(out_of_eeprom(address, bytes.len()))
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

    /// Starts measuring the stack anew, from where it is now.
    pub fn reset_min_sp(&mut self) {
        self.stack.restart(&self.avr);
    }

    /// The most bytes of stack in use since power-up or [`Uno::reset_min_sp`].
    pub fn stack_peak(&self) -> u16 {
        (RAM_END as u16).saturating_sub(self.min_sp())
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

fn data_range(first: u32, address: u32, len: usize) -> Result<std::ops::Range<usize>, Error> {
    let start = address as usize;
    match start.checked_add(len) {
        Some(end) if address >= first && end <= RAM_END as usize + 1 => Ok(start..end),
        _ => Err(Error::OutOfRange {
            memory: "RAM",
            address,
            len,
        }),
    }
}

fn out_of_eeprom(address: u16, len: usize) -> Error {
    Error::OutOfRange {
        memory: "EEPROM",
        address: address.into(),
        len,
    }
}
