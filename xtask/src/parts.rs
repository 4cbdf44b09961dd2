//! What each part of the firmware takes of the flash, by the symbols of its ELF.

use std::collections::BTreeMap;

use anyhow::{Context, Result};
use object::{Object, ObjectSection, ObjectSymbol};

use crate::budget::thousands;

/// The parts in the order of the table, and how the paths of what belongs to each begin. What is generic
/// belongs to the first path in its name: `<unoclp_card::Walk>::enter::<unoclp_firmware::card::Card>` to
/// the card.
const PARTS: &[(&str, &[&str])] = &[
    (
        "scan and linked engine",
        &[
            "unoclp_firmware::engine",
            "unoclp_firmware::scan",
            "unoclp_firmware::modes::run",
            "unoclp_core::linking",
            "engine_",
        ],
    ),
    ("loader and checks", &["unoclp_core"]),
    (
        "card and bus",
        &[
            "unoclp_card",
            "unoclp_firmware::card",
            "unoclp_firmware::board::spi",
            "embedded_sdmmc",
        ],
    ),
    ("state file", &["unoclp_firmware::state"]),
    (
        "program memory",
        &["unoclp_firmware::store", "unoclp_firmware::board::eeprom"],
    ),
    ("Modbus", &["unoclp_modbus", "unoclp_firmware::server"]),
    (
        "reports",
        &[
            "unoclp_firmware::report",
            "unoclp_firmware::decimal",
            "unoclp_firmware::board::serial",
            "unoclp_firmware::board::flash",
        ],
    ),
    (
        "diagnosis, faults, STOP",
        &[
            "unoclp_firmware::diagnosis",
            "unoclp_firmware::indicator",
            "unoclp_firmware::modes",
            "unoclp_firmware::halt",
            "unoclp_firmware::board::watchdog",
            "unoclp_firmware::board::supply",
        ],
    ),
    ("start-up and the rest", &["unoclp_firmware", "__", "main"]),
    (
        "runtime and interrupts",
        &[
            "__vector",
            "__mulqi3",
            "__mulhi3",
            "memcpy",
            "memset",
            "_critical_section",
            "critical_section",
        ],
    ),
    (
        "shared entries, exits, parts",
        &["__save", "__frame", "__unframe", "__part"],
    ),
];

/// The row of the texts, which belong to no part.
const TEXTS: &str = "texts";
/// Where a symbol of no known name stands in a part, it belongs to the part before it.
const FIRST: &str = "start-up and the rest";

/// A row for each part: its name, and its bytes.
pub fn parts(elf: &[u8]) -> Result<Vec<(&'static str, u64)>> {
    let file = object::File::parse(elf).context("this is not an ELF file")?;
    let text = file.section_by_name(".text").context("no code")?;
    let mut symbols: BTreeMap<u64, String> = BTreeMap::new();
    for symbol in file.symbols() {
        let name = format!("{:#}", rustc_demangle::demangle(symbol.name()?));
        if symbol.section_index() == Some(text.index()) && part(&name).is_some() {
            symbols.entry(symbol.address()).or_insert(name);
        }
    }
    let end = text.address() + text.size();
    let ends = symbols.keys().skip(1).copied().chain([end]);
    let mut sums: BTreeMap<&str, u64> = BTreeMap::new();
    for ((start, name), end) in symbols.iter().zip(ends) {
        *sums.entry(part(name).unwrap_or(FIRST)).or_default() += end - start;
    }
    let names = PARTS.iter().map(|(name, _)| *name).chain([TEXTS]);
    Ok(names
        .filter_map(|name| Some((name, *sums.get(name)?)))
        .collect())
}

/// The part that a symbol belongs to; `None` for a name that says nothing.
fn part(symbol: &str) -> Option<&'static str> {
    if symbol.ends_with("::BYTES") {
        return Some(TEXTS);
    }
    let found = PARTS.iter().flat_map(|(name, paths)| {
        let places = paths.iter().filter_map(|path| {
            let at = symbol.find(path)?;
            // Names without a path begin so; a path may stand anywhere.
            let whole = path.starts_with("unoclp") || path.starts_with("embedded") || at == 0;
            whole.then_some((at, usize::MAX - path.len(), *name))
        });
        places.collect::<Vec<_>>()
    });
    found.min().map(|(_, _, name)| name)
}

/// The table, a line for each part.
///
/// # Errors
/// If the ELF cannot be read.
pub fn table(elf: &[u8]) -> Result<String> {
    let parts = parts(elf)?;
    let all: u64 = parts.iter().map(|(_, bytes)| bytes).sum();
    let mut lines = vec![format!("{:<30}{:>7} B", "flash by part", thousands(all))];
    for (name, bytes) in parts {
        let per_cent = (100 * bytes + all / 2) / all.max(1);
        lines.push(format!(
            "  {name:<28}{:>7} B {per_cent:>3} %",
            thousands(bytes)
        ));
    }
    Ok(lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::part;

    #[test]
    fn a_symbol_belongs_to_the_first_path_in_its_name() {
        let cases = [
            (
                "unoclp_firmware::modes::run",
                Some("scan and linked engine"),
            ),
            ("unoclp_firmware::report::run::BYTES", Some("texts")),
            ("unoclp_firmware::report::run", Some("reports")),
            ("unoclp_firmware::start", Some("start-up and the rest")),
            (
                "<unoclp_card::walk::Walk>::enter::<unoclp_firmware::card::Card>",
                Some("card and bus"),
            ),
            (
                "<unoclp_core::loader::Loader>::restore::<unoclp_firmware::store::Bytes>",
                Some("loader and checks"),
            ),
            (
                "<unoclp_core::linking::Linking>::put",
                Some("scan and linked engine"),
            ),
            ("__frame_r2", Some("shared entries, exits, parts")),
            ("__init", Some("start-up and the rest")),
            ("__vector_13", Some("runtime and interrupts")),
            ("engine_coil", Some("scan and linked engine")),
            ("age", None),
        ];
        for (symbol, expected) in cases {
            assert_eq!(part(symbol), expected, "{symbol}");
        }
    }
}
