//! `cargo xtask rulings`: which tests name which ruling of the numeric code, as `docs/rulings.md`.
//!
//! Owns that page. Must not know what a ruling says.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use crate::shell::{root, say};

/// The page that it writes.
pub const PAGE: &str = "docs/rulings.md";
/// Where the rulings stand.
const RULINGS: &str = "docs/numeric-code.md";
/// Scenarios, each run on every engine: the core, simavr, avr8js.
const SCENARIOS: [&str; 2] = ["proof/suite", "programs"];
/// Tests in Rust. Those of languages and tools cite rulings that they build on, and test none.
const TESTS: [&str; 5] = [
    "device/card/tests",
    "device/checked/tests",
    "device/core/tests",
    "host-sim/tests",
    "proof/uno-sim/tests",
];
/// Scenarios of one folder that are named; of more their number is told.
const NAMED: usize = 3;

/// The tests of a ruling.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tests {
    /// Folders of scenarios, and the names of these.
    pub scenarios: BTreeMap<String, Vec<String>>,
    /// Files of tests in Rust.
    pub files: Vec<String>,
}

impl Tests {
    /// Whether nothing tests it.
    pub fn is_empty(&self) -> bool {
        self.scenarios.is_empty() && self.files.is_empty()
    }
}

/// Each ruling by its number, with its first words and its tests.
///
/// # Errors
/// If a file cannot be read.
pub fn rulings() -> Result<BTreeMap<u32, (String, Tests)>> {
    let text = fs::read_to_string(root().join(RULINGS)).context(RULINGS)?;
    let lines: Vec<&str> = text.lines().collect();
    let mut rulings = BTreeMap::new();
    for (at, line) in lines.iter().enumerate() {
        let Some((number, _)) = line.strip_prefix("- NC-").and_then(numbered) else {
            continue;
        };
        let words = lines[at..].iter().map(|line| line.trim());
        let words = words.take_while(|line| !line.is_empty());
        let told = words.take(4).collect::<Vec<_>>().join(" ");
        let told = told
            .split_once(|c: char| c.is_ascii_digit())
            .map_or("", |(_, rest)| rest);
        rulings.insert(number, (first_words(told), Tests::default()));
    }
    for folder in SCENARIOS {
        each_file(folder, "toml", &mut |path, text| {
            let (folder, name) = path.rsplit_once('/').unwrap_or(("", path));
            for number in cited(text) {
                if let Some((_, tests)) = rulings.get_mut(&number) {
                    let names = tests.scenarios.entry(folder.to_owned()).or_default();
                    names.push(name.trim_end_matches(".toml").to_owned());
                }
            }
        })?;
    }
    for folder in TESTS {
        each_file(folder, "rs", &mut |path, text| {
            for number in cited(text) {
                if let Some((_, tests)) = rulings.get_mut(&number) {
                    tests.files.push(path.to_owned());
                }
            }
        })?;
    }
    Ok(rulings)
}

/// The page.
///
/// # Errors
/// If a file cannot be read.
pub fn page() -> Result<String> {
    let mut page = "# Rulings and their tests\n\n\
        This page lists each ruling of the [numeric code](numeric-code.md) and the tests that name it. A scenario runs on the\n\
        core, and the firmware runs it in simavr and on avr8js. `cargo xtask rulings` writes this page. A test checks that the\n\
        page is up to date, and fails if a ruling has no test.\n\n\
        | ruling | says | scenarios | tests in Rust |\n| --- | --- | --- | --- |\n"
        .to_owned();
    for (number, (told, tests)) in rulings()? {
        let scenarios = tests
            .scenarios
            .iter()
            .map(|(folder, names)| match names.len() {
                0..=NAMED => format!("`{folder}/`: {}", names.join(", ")),
                count => format!("`{folder}/`: {count}"),
            });
        let scenarios = scenarios.collect::<Vec<_>>().join("; ");
        let files = tests.files.iter().map(|file| format!("`{file}`"));
        let files = files.collect::<Vec<_>>().join(", ");
        let _ = writeln!(page, "| NC-{number} | {told} | {scenarios} | {files} |");
    }
    Ok(page)
}

/// Writes it.
///
/// # Errors
/// If a file cannot be read or written.
pub fn run() -> Result<()> {
    fs::write(root().join(PAGE), page()?).context(PAGE)?;
    say(&format!("rulings: {PAGE}"));
    Ok(())
}

/// The number at the front of a text, and what follows it.
fn numbered(text: &str) -> Option<(u32, &str)> {
    let end = text
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(text.len());
    Some((text[..end].parse().ok()?, &text[end..]))
}

/// The rulings that a text names, each once: `NC-7`, and all of `NC-22 to NC-28`.
fn cited(text: &str) -> Vec<u32> {
    let mut numbers = Vec::new();
    for (at, mark) in text.match_indices("NC-") {
        let Some((first, rest)) = numbered(&text[at + mark.len()..]) else {
            continue;
        };
        let last = rest.strip_prefix(" to NC-").and_then(numbered);
        numbers.extend(first..=last.map_or(first, |(last, _)| last));
    }
    numbers.sort_unstable();
    numbers.dedup();
    numbers
}

/// The beginning of a ruling: its first sentence, or as much of it as a row holds.
fn first_words(told: &str) -> String {
    let told = told.trim_start_matches(|c: char| c.is_ascii_digit());
    let told = told
        .trim()
        .trim_start_matches("(ours)")
        .trim()
        .trim_start_matches("- ");
    let end = told.find(". ").or(told.find(": ")).unwrap_or(told.len());
    let mut words = String::new();
    for word in told[..end].split_whitespace() {
        if words.len() + word.len() > 90 {
            words.push_str(" …");
            break;
        }
        if !words.is_empty() {
            words.push(' ');
        }
        words.push_str(word);
    }
    // A mark of code that is cut open would take the rest of the row.
    if words.matches('`').count() % 2 == 1 {
        words.push('`');
    }
    words
        .trim_end_matches('.')
        .replace("**", "")
        .replace('|', "\\|")
}

/// Each file with this end below a folder, in order, by its path from the root.
fn each_file(folder: &str, end: &str, see: &mut dyn FnMut(&str, &str)) -> Result<()> {
    let path = root().join(folder);
    if !path.exists() {
        return Ok(());
    }
    let entries = fs::read_dir(&path).with_context(|| folder.to_owned())?;
    let mut names = Vec::new();
    for entry in entries {
        names.push(entry?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    for name in names {
        let inside = format!("{folder}/{name}");
        if path.join(&name).is_dir() {
            each_file(&inside, end, see)?;
        } else if Path::new(&name).extension().is_some_and(|is| is == end) {
            let text = fs::read_to_string(path.join(&name)).with_context(|| inside.clone())?;
            see(&inside, &text);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rulings_are_found_one_by_one_and_in_rows() {
        assert_eq!(cited("NC-1, NC-12 and (NC-1) but no NC-x"), [1, 12]);
        assert_eq!(cited("all of NC-22 to NC-24"), [22, 23, 24]);
    }

    #[test]
    fn a_row_has_the_first_words() {
        assert_eq!(
            first_words(" (ours) `LB XX` stands. More"),
            "`LB XX` stands"
        );
        let long = "`MOV` ".repeat(40);
        assert!(first_words(&long).ends_with('…'), "{long}");
    }
}
