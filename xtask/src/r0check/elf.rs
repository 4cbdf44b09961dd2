//! The code of a linked AVR ELF and the functions in it.

use std::collections::BTreeMap;

use anyhow::{Context, Result, ensure};
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags, SymbolKind, elf};

/// The executable contents of flash, with names for its addresses.
#[derive(Default)]
pub struct Code {
    /// Start address in bytes, and the bytes there.
    blocks: Vec<(u32, Vec<u8>)>,
    labels: BTreeMap<u32, String>,
    functions: Vec<u32>,
    /// Constants among the code: start address and end.
    constants: Vec<(u32, u32)>,
}

impl Code {
    /// Reads an ELF.
    ///
    /// # Errors
    /// If it is no AVR ELF, or has no function symbols (it was stripped): without them the check
    /// could not tell code from the tables in between.
    pub fn from_elf(bytes: &[u8]) -> Result<Self> {
        let file = object::File::parse(bytes).context("this is no ELF file")?;
        ensure!(
            file.architecture() == object::Architecture::Avr,
            "this ELF is for {:?}, not for AVR",
            file.architecture()
        );

        let executable = |section: &object::Section<'_, '_>| match section.flags() {
            SectionFlags::Elf { sh_flags } => sh_flags & u64::from(elf::SHF_EXECINSTR) != 0,
            _ => false,
        };
        let mut code = Code::default();
        for section in file.sections().filter(executable) {
            code.add_block(u32::try_from(section.address())?, section.data()?);
            let inside =
                |symbol: &object::Symbol<'_, '_>| symbol.section_index() == Some(section.index());
            for symbol in file.symbols().filter(inside) {
                let name = format!("{:#}", rustc_demangle::demangle(symbol.name()?));
                let function = symbol.kind() == SymbolKind::Text;
                let address = u32::try_from(symbol.address())?;
                code.add_label(address, &name, function);
                if symbol.kind() == SymbolKind::Data {
                    code.add_constant(address, u32::try_from(symbol.size())?);
                }
            }
        }
        ensure!(
            !code.functions.is_empty(),
            "this ELF has no function symbols: link it without stripping them"
        );
        Ok(code)
    }

    pub(super) fn add_block(&mut self, start: u32, bytes: &[u8]) {
        self.blocks.push((start, bytes.to_vec()));
    }

    pub(super) fn add_label(&mut self, address: u32, name: &str, function: bool) {
        if function {
            self.functions.push(address);
        }
        if name.is_empty() {
            return;
        }
        if function || !self.labels.contains_key(&address) {
            self.labels.insert(address, name.to_owned());
        }
    }

    pub(super) fn add_constant(&mut self, start: u32, bytes: u32) {
        self.constants.push((start, start + bytes));
    }

    /// Byte addresses of the functions: from here code is reached that nothing calls directly.
    pub fn functions(&self) -> &[u32] {
        &self.functions
    }

    /// The code from a byte address on.
    pub fn at(&self, address: u32) -> Option<&[u8]> {
        self.blocks.iter().find_map(|(start, bytes)| {
            let offset = usize::try_from(address.checked_sub(*start)?).ok()?;
            bytes.get(offset..).filter(|rest| !rest.is_empty())
        })
    }

    /// Byte addresses of the labels that are no constants: hand-written code may be reached there.
    pub fn entries(&self) -> impl Iterator<Item = u32> {
        let labels = self.labels.keys().copied();
        labels.filter(|&address| !self.is_constant(address) && self.at(address).is_some())
    }

    /// Whether a constant stands at an address.
    pub fn is_constant(&self, address: u32) -> bool {
        self.constants
            .iter()
            .any(|&(start, end)| (start..end).contains(&address))
    }

    /// The bytes of all that is no constant.
    pub fn bytes(&self) -> usize {
        let code = |(start, bytes): &(u32, Vec<u8>)| {
            let addresses = (*start..).take(bytes.len());
            addresses.filter(|&at| !self.is_constant(at)).count()
        };
        self.blocks.iter().map(code).sum()
    }

    /// The label that stands at an address or last before it.
    pub fn label(&self, address: u32) -> &str {
        self.labels
            .range(..=address)
            .next_back()
            .map_or("code without a name", |(_, name)| name)
    }
}
