//! The page of what was tried: a part for each room.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

use anyhow::{Context, Result, ensure};
use serde::Deserialize;

use super::kept::{Fate, Kept, Mutant, without_line};
use super::rooms::{Room, VERSION};
use crate::shell::root;

/// The page.
const PAGE: &str = "docs/mutants.md";
/// The mutants that no test can notice, each with its reason.
const REASONS: &str = "xtask/src/mutants/reasons.toml";

/// Mutants that no test misses, since they do what the program does.
#[derive(Deserialize)]
struct Reasons {
    reason: Vec<Reason>,
}

#[derive(Deserialize)]
struct Reason {
    /// Their file, from the root.
    file: String,
    /// Their names, without the file and its line.
    mutants: Vec<String>,
    why: String,
}

impl Reasons {
    fn of(&self, name: &str) -> Option<&str> {
        let (file, _) = name.split_once(':')?;
        let fits = |reason: &&Reason| {
            let what = without_line(name);
            reason.file == file && reason.mutants.iter().any(|mutant| mutant == what)
        };
        Some(&self.reason.iter().find(fits)?.why)
    }
}

/// Writes the part of a room.
///
/// # Errors
/// If a file cannot be read or written, or nothing was tried.
pub fn write(room: &Room, seed: u64, all: usize, sample: &[&Mutant], kept: &Kept) -> Result<()> {
    let text = fs::read_to_string(root().join(REASONS)).context(REASONS)?;
    let reasons: Reasons = toml::from_str(&text).context(REASONS)?;
    let tried = Tried::of(sample, kept);
    ensure!(tried.count() > 0, "no mutant of {} was tried", room.name);
    let path = root().join(PAGE);
    let mut sections = sections(&fs::read_to_string(&path).unwrap_or_default());
    let section = section(room, seed, all, &tried, &reasons);
    sections.insert(room.name.to_owned(), section);
    fs::write(&path, page(&sections)).with_context(|| format!("cannot write {PAGE}"))
}

/// The sample by what has become of it.
#[derive(Default)]
struct Tried<'a> {
    noticed: usize,
    slow: usize,
    unviable: usize,
    missed: Vec<&'a str>,
}

impl<'a> Tried<'a> {
    fn of(sample: &[&'a Mutant], kept: &Kept) -> Self {
        let mut tried = Self::default();
        for mutant in sample {
            match kept.fate(mutant) {
                Some(Fate::Noticed) => tried.noticed += 1,
                Some(Fate::TooLong) => tried.slow += 1,
                Some(Fate::DoesNotCompile) => tried.unviable += 1,
                Some(Fate::Missed) => tried.missed.push(&mutant.name),
                Some(Fate::Unknown) | None => {}
            }
        }
        tried.missed.sort_unstable();
        tried
    }

    fn count(&self) -> usize {
        self.noticed + self.slow + self.unviable + self.missed.len()
    }

    /// Of those that compile, in tenths of a percent.
    fn share(&self) -> usize {
        let noticed = self.noticed + self.slow;
        1000 * noticed / (noticed + self.missed.len()).max(1)
    }
}

fn section(room: &Room, seed: u64, all: usize, tried: &Tried, reasons: &Reasons) -> String {
    let mut packages: Vec<String> = Vec::new();
    for name in room.rounds.iter().flat_map(|tests| tests.packages) {
        let name = format!("`{name}`");
        if !packages.contains(&name) {
            packages.push(name);
        }
    }
    let mut text = format!(
        "Of {all} mutants, {} were tried (seed {seed}), with the tests of {}. The tests noticed **{}.{} %** of those that compile.\n\n\
         | noticed | ran for too long | do not compile | missed |\n| ---: | ---: | ---: | ---: |\n\
         | {} | {} | {} | {} |\n",
        tried.count(),
        packages.join(" and "),
        tried.share() / 10,
        tried.share() % 10,
        tried.noticed,
        tried.slow,
        tried.unviable,
        tried.missed.len(),
    );
    let reason = |name: &&&str| reasons.of(name).is_some();
    let (explained, open): (Vec<&&str>, Vec<&&str>) = tried.missed.iter().partition(reason);
    // To a string nothing fails.
    if !open.is_empty() {
        text.push_str("\nMissed:\n\n");
    }
    for name in open {
        let _ = writeln!(text, "- `{name}`");
    }
    if !explained.is_empty() {
        text.push_str("\nMissed, and why no test can notice them:\n\n");
    }
    for name in explained {
        let why = reasons.of(name).unwrap_or_default();
        let _ = writeln!(text, "- `{name}`: {why}");
    }
    text
}

/// The sections of a page, by their rooms.
fn sections(page: &str) -> BTreeMap<String, String> {
    let sections = page.split("\n## ").skip(1);
    let parts = sections.filter_map(|section| section.split_once("\n\n"));
    parts
        .map(|(room, text)| (room.to_owned(), text.trim_end().to_owned() + "\n"))
        .collect()
}

fn page(sections: &BTreeMap<String, String>) -> String {
    let mut page = format!(
        "# Tests, tested\n\nA program writes this page: do not edit it; run the tests again.\n\n```\ncargo xtask mutants\n```\n\n\
         cargo-mutants {VERSION} changes the source a little, one place at a time: a function returns a fixed value, `<` becomes `<=`,\n\
         or an arm of a match disappears. Each changed program is a *mutant*, and the tests should notice it. Those that they miss are listed: either a\n\
         test is missing, or the change has no visible effect. A mutant that runs for too long counts as noticed.\n\n\
         A seed decides which ones are tried, and in which order: a longer run begins with the mutants of a shorter one. A run that is\n\
         stopped continues from there. Mutants that leave out a field of a value are excluded: cargo-mutants cannot try some of these.\n"
    );
    for (room, text) in sections {
        // To a string nothing fails.
        let _ = write!(page, "\n## {room}\n\n{text}");
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mutants::kept::tests::kept;
    use crate::mutants::rooms::ROOMS;

    #[test]
    fn a_page_keeps_the_rooms_that_are_not_measured() {
        let names = ["a.rs:1:2: x", "a.rs:3:2: y", "a.rs:4:2: z", "never tried"];
        let mutants = names.map(|name| Mutant { name: name.into() });
        let sample: Vec<&Mutant> = mutants.iter().collect();
        let kept = kept(&[
            (names[0], "MissedMutant"),
            (names[1], "CaughtMutant"),
            (names[2], "MissedMutant"),
        ]);
        let reason = Reason {
            file: "a.rs".into(),
            mutants: vec!["z".into()],
            why: "the same".into(),
        };
        let reasons = Reasons {
            reason: vec![reason],
        };
        let tried = Tried::of(&sample, &kept);
        let text = section(&ROOMS[0], 1, 90, &tried, &reasons);
        assert!(text.contains("Of 90 mutants, 3 were tried"), "{text}");
        assert!(text.contains("**33.3 %**"), "{text}");
        assert!(text.contains("| 1 | 0 | 0 | 2 |"), "{text}");
        assert!(
            text.contains("Missed:\n\n- `a.rs:1:2: x`\n\nMissed, and"),
            "{text}"
        );
        assert!(text.ends_with("- `a.rs:4:2: z`: the same\n"), "{text}");
        let all = BTreeMap::from([("x/y".to_owned(), text), ("z".to_owned(), "Of 1\n".into())]);
        assert_eq!(sections(&page(&all)), all);
    }
}
