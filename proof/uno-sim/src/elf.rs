//! The program: what an ELF file says about flash, EEPROM, symbols and RAM.
//!
//! In AVR ELF files the address spaces are kept apart by an offset: flash from 0, data space from 0x80_0000, EEPROM from
//! 0x81_0000, fuses and the rest beyond.

use crate::Error;
use object::elf::{EM_AVR, PT_LOAD, SHF_ALLOC};
use object::read::elf::{ElfFile32, FileHeader as _, ProgramHeader as _, SectionHeader as _};
use object::{Endianness, Object as _, ObjectSymbol as _, SymbolKind};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Flash of the ATmega328P, bytes.
pub const FLASH_LEN: usize = 0x8000;
/// What a chip of the same kind could have and still reach all of it by Z, bytes: for
/// [`Program::read_enlarged`].
pub const ENLARGED_FLASH_LEN: usize = 0x1_0000;
/// First address of the SRAM in data space; below are the registers.
pub const RAM_START: u32 = 0x100;
/// Last address of the SRAM (RAMEND), where the stack starts.
pub const RAM_END: u32 = 0x8FF;
/// EEPROM of the ATmega328P, bytes.
pub const EEPROM_LEN: usize = 0x400;

const DATA: u32 = 0x80_0000;
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

/// A program for the ATmega328P, as read from an ELF file.
#[derive(Clone, Debug)]
pub struct Program {
    /// Flash from address 0, code and the start values of `.data`.
    pub(crate) flash: Vec<u8>,
    /// EEPROM from address 0, where the file fills it.
    pub(crate) eeprom: Vec<u8>,
    symbols: BTreeMap<String, Symbol>,
    /// First data address above `.data`, `.bss` and `.noinit`.
    pub(crate) static_ram_end: u32,
    /// The flash that the chip has, bytes.
    pub(crate) flash_len: usize,
    /// Where the chip starts: at 0, or by its fuse BOOTRST at its boot loader.
    pub(crate) start: u32,
}

/// The ELF file of the firmware: the environment variable `UNOCLP_ELF` where it is set, else
/// `target/firmware/unoclp.elf` in the workspace, where `cargo xtask firmware` leaves it.
///
/// # Errors
/// [`Error::NoFirmware`] where there is no such file.
pub fn firmware_elf() -> Result<PathBuf, Error> {
    let path = match std::env::var_os("UNOCLP_ELF") {
        Some(path) => PathBuf::from(path),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/firmware/unoclp.elf"),
    };
    if path.is_file() {
        Ok(path)
    } else {
        Err(Error::NoFirmware(path))
    }
}

/// The firmware as the compiler made it, for [`Program::read_enlarged`]: it stands beside [`firmware_elf`].
///
/// # Errors
/// [`Error::NoFirmware`] where there is no such file.
pub fn unshortened_elf() -> Result<PathBuf, Error> {
    beside("unoclp-unshortened.elf")
}

/// The firmware of Nanos: it stands beside [`firmware_elf`].
///
/// # Errors
/// [`Error::NoFirmware`] where there is no such file.
pub fn nano_elf() -> Result<PathBuf, Error> {
    beside("unoclp-nano.elf")
}

fn beside(name: &str) -> Result<PathBuf, Error> {
    let path = firmware_elf()?.with_file_name(name);
    if path.is_file() {
        Ok(path)
    } else {
        Err(Error::NoFirmware(path))
    }
}

impl Program {
    /// No program, for a chip with so much flash.
    fn empty(flash_len: usize) -> Program {
        Program {
            flash: Vec::new(),
            eeprom: Vec::new(),
            symbols: BTreeMap::new(),
            static_ram_end: RAM_START,
            flash_len,
            start: 0,
        }
    }

    /// A boot loader from its file in Intel HEX, on a chip that is set to start there, and before it another program:
    /// these words of flash from address 0 on.
    ///
    /// # Errors
    /// Where the file cannot be read, or is no boot loader for this chip.
    pub fn boot_loader(path: &Path, before: &[u16]) -> Result<Program, Error> {
        let text = std::fs::read_to_string(path).map_err(|source| Error::Read {
            path: path.into(),
            source,
        })?;
        let unfit = |reason: String| Error::NotForThisChip {
            path: path.into(),
            reason,
        };
        let mut program = Program::empty(FLASH_LEN);
        program.flash = vec![0xFF; FLASH_LEN];
        for (place, word) in program.flash.chunks_exact_mut(2).zip(before) {
            place.copy_from_slice(&word.to_le_bytes());
        }
        program.start = FLASH_LEN as u32;
        for record in ihex::Reader::new(&text) {
            if let ihex::Record::Data { offset, value } =
                record.map_err(|error| unfit(error.to_string()))?
            {
                program.load(offset.into(), &value).map_err(unfit)?;
                program.start = program.start.min(offset.into());
            }
        }
        match program.start < FLASH_LEN as u32 {
            true => Ok(program),
            false => Err(unfit("it is empty".to_owned())),
        }
    }

    /// The same program with this in the EEPROM, in place of what the file has there.
    ///
    /// # Errors
    /// If that is not all of the EEPROM.
    pub fn with_eeprom(self, eeprom: Vec<u8>) -> Result<Program, usize> {
        match eeprom.len() {
            EEPROM_LEN => Ok(Program { eeprom, ..self }),
            other => Err(other),
        }
    }

    /// Reads an ELF file.
    ///
    /// # Errors
    /// Where the file cannot be read, is no ELF file, is for another chip, or does not fit into this one.
    pub fn read(path: &Path) -> Result<Program, Error> {
        Program::read_for(path, FLASH_LEN)
    }

    /// Reads an ELF file for a chip that has all that an ATmega328P has, and [`ENLARGED_FLASH_LEN`] of flash:
    /// the firmware before it is shortened does not fit the real one.
    ///
    /// # Errors
    /// As [`Program::read`].
    pub fn read_enlarged(path: &Path) -> Result<Program, Error> {
        Program::read_for(path, ENLARGED_FLASH_LEN)
    }

    fn read_for(path: &Path, flash_len: usize) -> Result<Program, Error> {
        let file = std::fs::read(path).map_err(|source| Error::Read {
            path: path.into(),
            source,
        })?;
        let broken = |source| Error::Elf {
            path: path.into(),
            source,
        };
        let unfit = |reason: String| Error::NotForThisChip {
            path: path.into(),
            reason,
        };

        let elf = ElfFile32::<Endianness>::parse(file.as_slice()).map_err(broken)?;
        let endian = elf.endian();
        if elf.elf_header().e_machine(endian) != EM_AVR {
            return Err(unfit("it is for another kind of processor".into()));
        }
        let mut program = Program::empty(flash_len);
        for segment in elf.elf_program_headers() {
            let bytes = segment.data(endian, file.as_slice()).map_err(|()| {
                unfit("a segment lies outside the file; it seems to be cut off".into())
            })?;
            if segment.p_type(endian) == PT_LOAD && !bytes.is_empty() {
                program
                    .load(segment.p_paddr(endian), bytes)
                    .map_err(unfit)?;
            }
        }
        program.static_ram_end = static_ram_end(&elf, endian).max(RAM_START);
        program.symbols = elf
            .symbols()
            .filter_map(|symbol| {
                let wanted = !matches!(symbol.kind(), SymbolKind::Section | SymbolKind::File);
                let (space, address) = locate(u32::try_from(symbol.address()).ok()?)?;
                let size = u32::try_from(symbol.size()).ok()?;
                let name = symbol
                    .name()
                    .ok()
                    .filter(|name| wanted && !name.is_empty())?;
                Some((
                    name.to_owned(),
                    Symbol {
                        space,
                        address,
                        size,
                    },
                ))
            })
            .collect();
        Ok(program)
    }

    /// A program of these words of flash, without symbols.
    #[cfg(test)]
    pub(crate) fn from_words(words: &[u16]) -> Program {
        Program {
            flash: words.iter().flat_map(|word| word.to_le_bytes()).collect(),
            ..Program::empty(FLASH_LEN)
        }
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
    fn load(&mut self, address: u32, bytes: &[u8]) -> Result<(), String> {
        let (memory, len, name) = match locate(address) {
            Some((Space::Flash, _)) => (&mut self.flash, self.flash_len, "flash"),
            Some((Space::Eeprom, _)) => (&mut self.eeprom, EEPROM_LEN, "EEPROM"),
            Some((Space::Data, _)) => {
                return Err("a segment would have to be loaded into RAM".into());
            }
            // Fuses, lock bits, signature: nothing to load.
            None => return Ok(()),
        };
        let start = (address & 0xFFFF) as usize;
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

/// Splits an address of the ELF file into memory and address; `None` for fuses and the like.
fn locate(address: u32) -> Option<(Space, u32)> {
    match address {
        0..DATA => Some((Space::Flash, address)),
        DATA..EEPROM => Some((Space::Data, address - DATA)),
        EEPROM..FUSES => Some((Space::Eeprom, address - EEPROM)),
        FUSES.. => None,
    }
}

/// The first data address above all sections that take up RAM.
fn static_ram_end(elf: &ElfFile32<'_, Endianness>, endian: Endianness) -> u32 {
    elf.elf_section_table()
        .iter()
        .filter(|section| section.sh_flags(endian) & SHF_ALLOC != 0)
        .filter_map(|section| {
            let end = section
                .sh_addr(endian)
                .checked_add(section.sh_size(endian))?;
            let (space, _) = locate(section.sh_addr(endian))?;
            (space == Space::Data).then_some(end.saturating_sub(DATA))
        })
        .max()
        .unwrap_or(RAM_START)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_an_elf_file_for_avr_is_taken() {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        let read = |path: &Path| Program::read(path).map(drop);
        assert!(matches!(
            read(&here.join("missing.elf")),
            Err(Error::Read { .. })
        ));
        assert!(matches!(
            read(&here.join("Cargo.toml")),
            Err(Error::Elf { .. })
        ));
        let own = std::env::current_exe().expect("the test runs from a file");
        assert!(matches!(
            read(&own),
            Err(Error::Elf { .. } | Error::NotForThisChip { .. })
        ));
    }

    #[test]
    fn segments_go_where_their_load_address_says() {
        let mut program = Program::empty(FLASH_LEN);
        program.load(4, &[1, 2]).expect("flash");
        program.load(EEPROM + 2, &[3]).expect("EEPROM");
        program.load(FUSES, &[4]).expect("fuses are left alone");
        assert_eq!(program.flash, [0xFF, 0xFF, 0xFF, 0xFF, 1, 2]);
        assert_eq!(program.eeprom, [0xFF, 0xFF, 3]);
        for address in [
            FLASH_LEN as u32 - 1,
            0x1_0000,
            DATA,
            EEPROM + EEPROM_LEN as u32 - 1,
        ] {
            assert!(program.load(address, &[0, 0]).is_err(), "{address:#x}");
        }
    }
}
