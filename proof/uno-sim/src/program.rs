//! The program of a chip: what is in its flash and EEPROM, its symbols, and what it takes of RAM.
//!
//! The tools for AVR keep the address spaces apart by an offset: flash from 0, data space from 0x80_0000, EEPROM from
//! 0x81_0000, fuses and the rest beyond.

use crate::chip::{Chip, RAM_START};
use std::collections::BTreeMap;

/// What a chip of the same kind could have and still reach all of it by Z, bytes: for
/// [`Program::read_enlarged`].
pub const ENLARGED_FLASH_LEN: usize = 0x1_0000;

pub(crate) const DATA: u32 = 0x80_0000;
const EEPROM: u32 = 0x81_0000;
const FUSES: u32 = 0x82_0000;

/// Where a symbol lives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Space {
    /// Program memory, addressed in bytes.
    Flash,
    /// Registers and RAM.
    Data,
    /// EEPROM.
    Eeprom,
}

/// A symbol of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// Which memory it is in.
    pub space: Space,
    /// Its byte address within that memory, without the offset that the ELF file adds.
    pub address: u32,
    /// Its size in bytes; 0 where the file does not say.
    pub size: u32,
}

/// A program for a [`Chip`].
#[derive(Clone, Debug)]
pub struct Program {
    /// What it is for.
    pub(crate) chip: Chip,
    /// Flash from address 0, code and the start values of `.data`.
    pub(crate) flash: Vec<u8>,
    /// EEPROM from address 0, where the file fills it.
    pub(crate) eeprom: Vec<u8>,
    pub(crate) symbols: BTreeMap<String, Symbol>,
    /// First data address above `.data`, `.bss` and `.noinit`.
    pub(crate) static_ram_end: u32,
    /// The flash that the chip has, bytes.
    pub(crate) flash_len: usize,
    /// Where the chip starts: at 0, or by its fuse BOOTRST at its boot loader.
    pub(crate) start: u32,
}

impl Program {
    /// No program, for a chip with so much flash.
    pub(crate) fn empty(flash_len: usize) -> Program {
        Program {
            chip: Chip::Atmega328p,
            flash: Vec::new(),
            eeprom: Vec::new(),
            symbols: BTreeMap::new(),
            static_ram_end: RAM_START,
            flash_len,
            start: 0,
        }
    }

    /// The same program with this in the EEPROM, in place of what the file has there.
    ///
    /// # Errors
    /// If that is not all of the EEPROM.
    pub fn with_eeprom(self, eeprom: Vec<u8>) -> Result<Program, usize> {
        match eeprom.len() {
            len if len == self.chip.eeprom_len() => Ok(Program { eeprom, ..self }),
            other => Err(other),
        }
    }

    /// A program of these words of flash, without symbols.
    #[cfg(test)]
    pub(crate) fn from_words(words: &[u16]) -> Program {
        Program {
            flash: words.iter().flat_map(|word| word.to_le_bytes()).collect(),
            ..Program::empty(crate::chip::FLASH_LEN)
        }
    }

    /// The chip that it is for.
    pub fn chip(&self) -> Chip {
        self.chip
    }

    /// The symbol of this name, as the file spells it.
    pub fn symbol(&self, name: &str) -> Option<Symbol> {
        self.symbols.get(name).copied()
    }

    /// All symbols by name.
    pub fn symbols(&self) -> impl Iterator<Item = (&str, Symbol)> {
        self.symbols
            .iter()
            .map(|(name, symbol)| (name.as_str(), *symbol))
    }

    /// Names a place in flash: its address, and the symbol at or before it.
    pub(crate) fn place(&self, pc: u32) -> String {
        let nearest = self
            .symbols
            .iter()
            .filter(|(_, symbol)| symbol.space == Space::Flash && symbol.address <= pc)
            .max_by_key(|(_, symbol)| (symbol.address, symbol.size));
        match nearest {
            Some((name, symbol)) => format!("{pc:#06x} ({name} + {:#x})", pc - symbol.address),
            None => format!("{pc:#06x}"),
        }
    }

    /// Puts the bytes of a segment where its load address says.
    pub(crate) fn load(&mut self, address: u32, bytes: &[u8]) -> Result<(), String> {
        let (memory, len, name) = match locate(address) {
            Some((Space::Flash, _)) => (&mut self.flash, self.flash_len, "flash"),
            Some((Space::Eeprom, _)) => (&mut self.eeprom, self.chip.eeprom_len(), "EEPROM"),
            Some((Space::Data, _)) => {
                return Err("a segment would have to be loaded into RAM".into());
            }
            // Fuses, lock bits, signature: nothing to load.
            None => return Ok(()),
        };
        let start =
            (address & (DATA - 1)) as usize & if address < DATA { usize::MAX } else { 0xFFFF };
        let end = start + bytes.len();
        if end > len || address < DATA && address as usize >= len {
            return Err(format!(
                "it needs {end} bytes of {name}, and there are {len}"
            ));
        }
        if memory.len() < end {
            memory.resize(end, 0xFF);
        }
        memory[start..end].copy_from_slice(bytes);
        Ok(())
    }
}

/// Splits an address of a file into memory and address; `None` for fuses and the like.
pub(crate) fn locate(address: u32) -> Option<(Space, u32)> {
    match address {
        0..DATA => Some((Space::Flash, address)),
        DATA..EEPROM => Some((Space::Data, address - DATA)),
        EEPROM..FUSES => Some((Space::Eeprom, address - EEPROM)),
        FUSES.. => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_go_where_their_load_address_says() {
        let mut program = Program::empty(crate::chip::FLASH_LEN);
        program.load(4, &[1, 2]).expect("flash");
        program.load(EEPROM + 2, &[3]).expect("EEPROM");
        program.load(FUSES, &[4]).expect("fuses are left alone");
        assert_eq!(program.flash, [0xFF, 0xFF, 0xFF, 0xFF, 1, 2]);
        assert_eq!(program.eeprom, [0xFF, 0xFF, 3]);
        for address in [
            crate::chip::FLASH_LEN as u32 - 1,
            0x1_0000,
            DATA,
            EEPROM + crate::chip::EEPROM_LEN as u32 - 1,
        ] {
            assert!(program.load(address, &[0, 0]).is_err(), "{address:#x}");
        }
    }
}
