//! A program from an ELF file.

use crate::Error;
use crate::chip::Chip;
use crate::chip::RAM_START;
use crate::program::{DATA, Program, Space, Symbol, locate};
use object::elf::{EM_AVR, PT_LOAD, SHF_ALLOC};
use object::read::elf::{ElfFile32, FileHeader as _, ProgramHeader as _, SectionHeader as _};
use object::{Endianness, Object as _, ObjectSymbol as _, SymbolKind};
use std::path::Path;

/// Reads one for a chip with so much flash.
///
/// # Errors
/// Where the file cannot be read, is no ELF file, is for another chip, or does not fit into this one.
pub(crate) fn read(path: &Path, flash_len: usize) -> Result<Program, Error> {
    let file = std::fs::read(path).map_err(Error::read(path))?;
    let broken = |source| Error::Elf {
        path: path.into(),
        source,
    };
    let unfit = |reason: String| Error::unfit(path, reason);

    let elf = ElfFile32::<Endianness>::parse(file.as_slice()).map_err(broken)?;
    let endian = elf.endian();
    if elf.elf_header().e_machine(endian) != EM_AVR {
        return Err(unfit("it is for another kind of processor".into()));
    }
    let chip = Chip::of_flags(elf.elf_header().e_flags(endian));
    let mut program = Program {
        chip,
        ..Program::empty(flash_len.max(chip.flash_len()))
    };
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
    program.static_ram_end = static_ram_end(&elf, endian).max(chip.ram_start());
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
