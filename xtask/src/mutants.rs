//! `cargo xtask mutants`: changes the source a little, one place at a time, and looks whether a test notices it, as
//! `docs/mutants.md`.
//!
//! Owns which mutants are tried, and that page. What a mutant is, cargo-mutants knows.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

use anyhow::{Context, Result, ensure};
use serde::Deserialize;

use crate::shell::{cargo, output, root, say};

/// The page that it writes.
const PAGE: &str = "docs/mutants.md";
/// The version that is used; another one makes other mutants.
const VERSION: &str = "27.1.0";
/// What it leaves behind, from the root.
const FOLDER: &str = "target/mutants";

/// A room whose tests are tested: where it is, its package, and the packages whose tests count.
struct Room {
    name: &'static str,
    package: &'static str,
    tests: &'static [&'static str],
}

const ROOMS: [Room; 5] = [
    Room {
        name: "device/core",
        package: "unoclp-core",
        tests: &["unoclp-core", "unoclp-host-sim"],
    },
    Room {
        name: "ladder/draw",
        package: "unoclp-draw",
        tests: &["unoclp-draw"],
    },
    Room {
        name: "language/tree",
        package: "unoclp-tree",
        tests: &["unoclp-tree", "unoclp-lang"],
    },
    Room {
        name: "language/codegen",
        package: "unoclp-codegen",
        tests: &["unoclp-codegen", "unoclp-lang"],
    },
    Room {
        name: "tools/client",
        package: "unoclp-client",
        tests: &["unoclp-client"],
    },
];

/// Which mutants are tried.
#[derive(clap::Args)]
pub struct Args {
    /// The rooms, as `device/core`; all of them where none is named
    rooms: Vec<String>,
    /// How many mutants of each room are tried
    #[arg(long, default_value_t = 40)]
    each: usize,
    /// Another number picks others
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// Tries the mutants, and writes the page: a room that is not named keeps what stands there.
///
/// # Errors
/// If a step fails. A mutant that nobody notices is no failure: the page says so.
pub fn run(args: &Args) -> Result<()> {
    let known = |name: &String| ROOMS.iter().any(|room| room.name == name);
    for name in &args.rooms {
        let rooms: Vec<&str> = ROOMS.iter().map(|room| room.name).collect();
        ensure!(known(name), "no room {name}; there is {}", rooms.join(", "));
    }
    let version = output(cargo().args(["mutants", "--version"]));
    let is_there = version.is_some_and(|version| version.ends_with(VERSION));
    ensure!(
        is_there,
        "cargo-mutants {VERSION} is missing: cargo install cargo-mutants@{VERSION} --locked"
    );
    let path = root().join(PAGE);
    let mut sections = sections(&fs::read_to_string(&path).unwrap_or_default());
    for room in ROOMS {
        if args.rooms.is_empty() || args.rooms.iter().any(|name| name == room.name) {
            let section = measure(&room, args)?;
            sections.insert(room.name.to_owned(), section);
            fs::write(&path, page(&sections)).with_context(|| format!("cannot write {PAGE}"))?;
        }
    }
    Ok(())
}

/// A mutant, as cargo-mutants lists it.
#[derive(Deserialize)]
struct Mutant {
    name: String,
}

/// What has become of those that were tried.
#[derive(Deserialize)]
struct Outcomes {
    outcomes: Vec<Outcome>,
}

#[derive(Deserialize)]
struct Outcome {
    scenario: Scenario,
    summary: String,
}

#[derive(Deserialize)]
enum Scenario {
    Baseline,
    Mutant(Mutant),
}

fn measure(room: &Room, args: &Args) -> Result<String> {
    let mut list = cargo();
    list.args(["mutants", "--list", "--json", "--package", room.package]);
    let listed = output(&mut list).context("cargo-mutants lists nothing")?;
    let mut all: Vec<Mutant> = serde_json::from_str(&listed).context("a list of mutants")?;
    let total = all.len();
    // Those are tried whichever are asked for.
    all.retain(|mutant| !mutant.name.contains(": delete field "));
    all.sort_by_key(|mutant| place(args.seed, &mutant.name));
    all.truncate(args.each);
    say(&format!(
        "mutants: {} of {total} in {}",
        all.len(),
        room.name
    ));
    let folder = root().join(FOLDER).join(room.package);
    fs::create_dir_all(&folder)?;
    let mut tried = cargo();
    tried
        .args([
            "mutants",
            "--jobs=1",
            "--no-shuffle",
            "--package",
            room.package,
        ])
        .arg("--output")
        .arg(&folder);
    for tests in room.tests {
        tried.args(["--test-package", tests]);
    }
    for mutant in &all {
        tried
            .arg("--re")
            .arg(format!("^{}$", escaped(&mutant.name)));
    }
    // It ends with 2 or 3 where a mutant was missed; what became of each is in its file.
    let _ = tried.status().context("cargo-mutants does not run")?;
    let outcomes = folder.join("mutants.out/outcomes.json");
    let text = fs::read_to_string(&outcomes).context("cargo-mutants has no outcome")?;
    let outcomes: Outcomes = serde_json::from_str(&text).context("outcomes of mutants")?;
    Ok(section(room, args, total, &outcomes.outcomes))
}

/// Where a mutant stands among all: by this number, and by nothing else that it has. So a mutant that comes in changes no other's
/// place.
fn place(seed: u64, name: &str) -> u64 {
    let start = 0xcbf2_9ce4_8422_2325 ^ seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    // The line of a mutant moves with what stands above it.
    let name = name.split_once(": ").map_or(name, |(_, what)| what);
    let hash = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    let sum = name.bytes().fold(start, hash);
    // Names that end alike stand apart.
    let mixed = (sum ^ sum >> 33).wrapping_mul(0xff51_afd7_ed55_8ccd);
    mixed ^ mixed >> 33
}

/// A name as a regular expression that only it fits.
fn escaped(name: &str) -> String {
    let mut text = String::new();
    for ch in name.chars() {
        if r"\.+*?()|[]{}^$".contains(ch) {
            text.push('\\');
        }
        text.push(ch);
    }
    text
}

fn section(room: &Room, args: &Args, total: usize, outcomes: &[Outcome]) -> String {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut missed = Vec::new();
    for outcome in outcomes {
        let Scenario::Mutant(mutant) = &outcome.scenario else {
            continue;
        };
        *counts.entry(&outcome.summary).or_default() += 1;
        if outcome.summary == "MissedMutant" {
            missed.push(&*mutant.name);
        }
    }
    let count = |summary| counts.get(summary).copied().unwrap_or(0);
    let [caught, slow, unviable] = ["CaughtMutant", "Timeout", "Unviable"].map(count);
    let mut text = format!(
        "Of {total} mutants, {} were tried (seed {}), by the tests of {}.\n\n\
         | noticed | ran for too long | do not compile | missed |\n| ---: | ---: | ---: | ---: |\n\
         | {caught} | {slow} | {unviable} | {} |\n",
        counts.values().sum::<usize>(),
        args.seed,
        room.tests
            .iter()
            .map(|name| format!("`{name}`"))
            .collect::<Vec<_>>()
            .join(", "),
        missed.len(),
    );
    if !missed.is_empty() {
        text.push('\n');
    }
    missed.sort_unstable();
    for name in missed {
        // To a string nothing fails.
        let _ = writeln!(text, "- `{name}`");
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
        "# Tests, tested\n\nThis page is written by a program: do not edit it, repeat it.\n\n```\ncargo xtask mutants\n```\n\n\
         cargo-mutants {VERSION} changes the source a little, one place at a time: a function gives a fixed value, `<` becomes `<=`,\n\
         an arm of a match goes. Each changed program is a *mutant*, and the tests should notice it. One that they miss is listed: either a\n\
         test is missing, or the change changes nothing that anybody sees. A mutant that runs for too long was noticed too.\n\n\
         A seed decides which ones are tried, but those that leave out a field of a value: cargo-mutants tries all of these.\n"
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

    #[test]
    fn a_page_keeps_the_rooms_that_are_not_measured() {
        let args = Args {
            rooms: Vec::new(),
            each: 2,
            seed: 1,
        };
        let of = |name: &str, summary: &str| Outcome {
            scenario: Scenario::Mutant(Mutant { name: name.into() }),
            summary: summary.into(),
        };
        let baseline = Outcome {
            scenario: Scenario::Baseline,
            summary: "Success".into(),
        };
        let outcomes = [baseline, of("b", "MissedMutant"), of("a", "CaughtMutant")];
        let text = section(&ROOMS[0], &args, 90, &outcomes);
        assert!(text.contains("| 1 | 0 | 0 | 1 |\n\n- `b`\n"), "{text}");
        let all = BTreeMap::from([("x/y".to_owned(), text), ("z".to_owned(), "Of 1\n".into())]);
        assert_eq!(sections(&page(&all)), all);
    }

    #[test]
    fn a_sample_stays_the_same_as_lines_move_and_is_another_by_another_seed() {
        let [one, moved] = ["a.rs:1:2: replace x", "a.rs:7:2: replace x"];
        assert_eq!(place(1, one), place(1, moved));
        assert_ne!(place(1, one), place(2, one));
        assert_eq!(escaped("f(x) -> a::b"), r"f\(x\) -> a::b");
    }
}
