//! A program from a file in Intel HEX: a boot loader, or the tested firmware with its symbols beside it.

use crate::Error;
use crate::chip::Chip;
use crate::program::{Program, Space, Symbol, locate};
use ihex::Record;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The linker's name for the first byte of RAM that the program leaves free.
const FREE_RAM: &str = "_end";

/// Its name for the last byte of RAM, which says what chip the program is for.
const RAM_END: &str = "__stack";

/// Reads a firmware and its symbols.
///
/// # Errors
/// Where a file cannot be read, is of another form, or does not fit the chip.
pub(crate) fn read(path: &Path) -> Result<Program, Error> {
    let beside = path.with_extension("symbols");
    let text = fs::read_to_string(&beside).map_err(Error::read(&beside))?;
    let symbols = symbols(&text).map_err(|line| {
        Error::unfit(
            &beside,
            format!("its line {line} is not one of `avr-nm -S`"),
        )
    })?;
    let address = |name| {
        let symbol = symbols.get(name).map(|symbol| symbol.address);
        symbol.ok_or_else(|| Error::unfit(&beside, format!("it does not name {name}")))
    };
    let ram_end = address(RAM_END)?;
    let chip = Chip::of_ram_end(ram_end)
        .ok_or_else(|| Error::unfit(&beside, format!("no chip here has RAM up to {ram_end:#x}")))?;
    let static_ram_end = address(FREE_RAM)?.max(chip.ram_start());
    let mut program = Program {
        chip,
        symbols,
        static_ram_end,
        ..Program::empty(chip.flash_len())
    };
    load(&mut program, path)?;
    Ok(program)
}

impl Program {
    /// A boot loader from its file in Intel HEX, on a chip that is set to start there, and before it another program:
    /// these words of flash from address 0 on.
    ///
    /// # Errors
    /// Where the file cannot be read, or is no boot loader for this chip.
    pub fn boot_loader(chip: Chip, path: &Path, before: &[u16]) -> Result<Program, Error> {
        let length = chip.flash_len();
        let mut program = Program {
            chip,
            static_ram_end: chip.ram_start(),
            ..Program::empty(length)
        };
        program.flash = vec![0xFF; length];
        for (place, word) in program.flash.chunks_exact_mut(2).zip(before) {
            place.copy_from_slice(&word.to_le_bytes());
        }
        program.start = load(&mut program, path)?;
        match program.start < length as u32 {
            true => Ok(program),
            false => Err(Error::unfit(path, "it is empty")),
        }
    }
}

/// Loads what a file has for flash, and gives its first address; the end of flash where it has nothing.
///
/// # Errors
/// Where the file cannot be read, is of another form, or does not fit the chip.
pub(crate) fn load(program: &mut Program, path: &Path) -> Result<u32, Error> {
    let text = fs::read_to_string(path).map_err(Error::read(path))?;
    let mut first = program.flash_len as u32;
    let mut base = 0;
    for record in ihex::Reader::new(&text) {
        match record.map_err(|error| Error::unfit(path, error.to_string()))? {
            Record::Data { offset, value } => {
                let address = base + u32::from(offset);
                let loaded = program.load(address, &value);
                loaded.map_err(|reason| Error::unfit(path, reason))?;
                first = first.min(address);
            }
            Record::ExtendedSegmentAddress(segment) => base = u32::from(segment) << 4,
            Record::ExtendedLinearAddress(high) => base = u32::from(high) << 16,
            _ => {}
        }
    }
    Ok(first)
}

/// The symbols in what `avr-nm -S` prints, or the number of the line that it does not print: an address, a size where
/// there is one, a letter for the kind, a name.
fn symbols(text: &str) -> Result<BTreeMap<String, Symbol>, usize> {
    let mut symbols = BTreeMap::new();
    for (number, line) in (1_usize..).zip(text.lines()) {
        let (name, symbol) = symbol(line).ok_or(number)?;
        symbols.insert(name, symbol);
    }
    Ok(symbols)
}

fn symbol(line: &str) -> Option<(String, Symbol)> {
    let number = |digits: &str| u32::from_str_radix(digits, 16).ok();
    let words: Vec<_> = line.split(' ').collect();
    let (address, size, name) = match words[..] {
        [address, size, _, name] => (number(address)?, number(size)?, name),
        [address, _, name] => (number(address)?, 0, name),
        _ => return None,
    };
    let (space, address): (Space, u32) = locate(address)?;
    let symbol = Symbol {
        space,
        address,
        size,
    };
    Some((name.to_owned(), symbol))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_are_read_as_nm_prints_them() {
        let text = "0000180c t .loop\n008006e1 00000002 B AGE\n";
        let read = symbols(text).unwrap();
        let symbol = |space, address, size| Symbol {
            space,
            address,
            size,
        };
        assert_eq!(read[".loop"], symbol(Space::Flash, 0x180C, 0));
        assert_eq!(read["AGE"], symbol(Space::Data, 0x6E1, 2));
        for (line, wrong) in ["", "0000180c", "180g t x", "00000000 x t y"]
            .iter()
            .zip(0..)
        {
            let text = format!("{text}{line}\n");
            assert_eq!(symbols(&text), Err(3), "{wrong}: {line}");
        }
    }
}
