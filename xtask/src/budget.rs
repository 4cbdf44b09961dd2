//! What the firmware takes of the ATmega328P's memories, and what it may take.

use anyhow::{Context, Result};
use object::{Object, ObjectSection, SectionFlags, elf};
use unoclp_boot::Model;

/// Data addresses begin here in an AVR ELF, and those of the EEPROM at twice that distance.
const DATA: u64 = 0x80_0000;
const EEPROM: u64 = 0x81_0000;

/// The limits on a board. Each is a number of bytes.
///
/// Flash: what the boot loader leaves. RAM: ATmega328P datasheet DS40002061, section 8.3; what is not static is the
/// stack's. Initialised data takes both, and is a sign of texts or tables that belong into flash.
pub const fn budgets(board: Model) -> [Budget; 3] {
    [
        Budget {
            name: "flash",
            limit: board.room() as u64,
            used: |size| size.code + size.data,
        },
        Budget {
            name: "static RAM",
            limit: match board {
                Model::Mega => 8_192,
                _ => 2_048,
            },
            used: |size| size.data + size.bss,
        },
        Budget {
            name: ".data",
            // On a Mega the page has to begin where RAM does: it has no such data at all.
            limit: match board {
                Model::Mega => 0,
                _ => 32,
            },
            used: |size| size.data,
        },
    ]
}

/// A limit and what counts towards it.
pub struct Budget {
    /// What is limited.
    pub name: &'static str,
    /// Bytes that it may have.
    pub limit: u64,
    /// Bytes that it has.
    pub used: fn(&Size) -> u64,
}

/// The size of a build, in bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Size {
    /// Code, and constants that stay in flash: `.text`.
    pub code: u64,
    /// Variables with a first value: in RAM, and in flash to be copied from: `.data`.
    pub data: u64,
    /// Variables without one: `.bss` and `.noinit`.
    pub bss: u64,
}

impl Size {
    /// Adds up the sections of an AVR ELF, by where they are rather than by name, so that none is
    /// forgotten.
    ///
    /// # Errors
    /// If it is no ELF.
    pub fn of(elf: &[u8]) -> Result<Self> {
        let file = object::File::parse(elf).context("this is not an ELF file")?;
        let mut size = Size::default();
        for section in file.sections() {
            let SectionFlags::Elf { sh_flags } = section.flags() else {
                continue;
            };
            let contents = section.file_range().is_some();
            match section.address() {
                _ if sh_flags & u64::from(elf::SHF_ALLOC) == 0 => {}
                ..DATA => size.code += section.size(),
                DATA..EEPROM if contents => size.data += section.size(),
                DATA..EEPROM => size.bss += section.size(),
                _ => {}
            }
        }
        Ok(size)
    }

    /// The budgets of a board that are exceeded, by name.
    pub fn exceeded(&self, board: Model) -> Vec<&'static str> {
        budgets(board)
            .iter()
            .filter(|budget| (budget.used)(self) > budget.limit)
            .map(|budget| budget.name)
            .collect()
    }

    /// A line for each budget of a board: used, limit, per cent.
    pub fn table(&self, board: Model) -> String {
        let line = |budget: &Budget| {
            let used = (budget.used)(self);
            let verdict = match used > budget.limit {
                true => "  TOO MUCH",
                false => "",
            };
            format!(
                "{:<11}{:>7} of {:>6} B {:>4} %{verdict}",
                budget.name,
                thousands(used),
                thousands(budget.limit),
                100 * used / budget.limit.max(1),
            )
        };
        budgets(board).each_ref().map(line).join("\n")
    }
}

/// `32256` as `32,256`.
pub fn thousands(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (n, digit) in digits.chars().enumerate() {
        if n > 0 && (digits.len() - n).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_counts_towards_flash_and_ram() {
        let size = Size {
            code: 32_230,
            data: 26,
            bss: 2_022,
        };
        assert_eq!(size.exceeded(Model::Uno), Vec::<&str>::new());

        let one_more = |size: Size| size.exceeded(Model::Uno);
        assert_eq!(
            one_more(Size {
                code: 32_231,
                ..size
            }),
            ["flash"]
        );
        assert_eq!(one_more(Size { bss: 2_023, ..size }), ["static RAM"]);
        assert_eq!(one_more(Size { data: 27, ..size }), ["flash", "static RAM"]);
        assert_eq!(
            one_more(Size {
                data: 33,
                ..Size::default()
            }),
            [".data"]
        );
    }

    #[test]
    fn a_nano_has_less_flash() {
        let size = Size {
            code: 30_721,
            ..Size::default()
        };
        assert_eq!(size.exceeded(Model::Uno), [""; 0]);
        assert_eq!(size.exceeded(Model::Nano), ["flash"]);
        assert_eq!(size.exceeded(Model::NanoOld), ["flash"]);
    }

    #[test]
    fn the_report_names_used_limit_and_what_is_too_much() {
        let size = Size {
            code: 16_123,
            data: 5,
            bss: 2_048,
        };
        let expected = "flash       16,128 of 32,256 B   50 %\n\
                        static RAM   2,053 of  2,048 B  100 %  TOO MUCH\n\
                        .data            5 of     32 B   15 %";
        assert_eq!(size.table(Model::Uno), expected);
    }

    #[test]
    fn thousands_are_set_apart() {
        let cases = [
            (0, "0"),
            (999, "999"),
            (1_000, "1,000"),
            (1_234_567, "1,234,567"),
        ];
        for (number, text) in cases {
            assert_eq!(thousands(number), text);
        }
    }
}
