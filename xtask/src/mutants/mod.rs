//! `cargo xtask mutants`: changes the source a little, one place at a time, and looks whether a test notices it, as
//! `docs/mutants.md`.
//!
//! Owns which mutants are tried, in which order, and that page. What a mutant is, cargo-mutants knows.

mod kept;
mod lines;
mod page;
mod rooms;
mod tree;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};

use crate::shell::{self, cargo, output, root, say};
use kept::{Kept, Mutant};
use rooms::{ROOMS, Room, Tests, VERSION};

/// What it leaves behind, from the root.
const FOLDER: &str = "target/mutants";

/// The lines of those that are tried, as a change.
const LINES: &str = "lines.diff";

/// How many are tried at once.
const BATCH: usize = 50;

/// Which mutants are tried.
#[derive(clap::Args)]
pub struct Args {
    /// The rooms, such as `device/core`; by default, all
    rooms: Vec<String>,
    /// How many mutants to try in each room
    #[arg(long, default_value_t = 300)]
    each: usize,
    /// The seed of the selection; another number selects other mutants
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Also retry mutants that a test has already noticed
    #[arg(long)]
    again: bool,
    /// Try nothing: write the page from the results of earlier runs
    #[arg(long)]
    page: bool,
}

/// Tries the mutants, and writes the page: a room that is not named keeps what stands there.
///
/// # Errors
/// If a step fails. A mutant that nobody notices is no failure: the page says so.
pub fn run(args: &Args) -> Result<()> {
    let known = |name: &String| ROOMS.iter().any(|room| room.name == name);
    for name in &args.rooms {
        let rooms: Vec<&str> = ROOMS.iter().map(|room| room.name).collect();
        ensure!(
            known(name),
            "there is no room {name}; the rooms are {}",
            rooms.join(", ")
        );
    }
    let version = output(cargo().args(["mutants", "--version"]));
    let is_there = version.is_some_and(|version| version.ends_with(VERSION));
    ensure!(
        is_there,
        "cargo-mutants {VERSION} is missing: cargo install cargo-mutants@{VERSION} --locked"
    );
    for room in &ROOMS {
        if args.rooms.is_empty() || args.rooms.iter().any(|name| name == room.name) {
            measure(room, args)?;
        }
    }
    Ok(())
}

/// Tries the mutants of a room, and writes its part of the page, also where an earlier run was stopped.
fn measure(room: &Room, args: &Args) -> Result<()> {
    let all = listed(room)?;
    let sample = sample(&all, args);
    let folder = root().join(FOLDER).join(room.package);
    fs::create_dir_all(&folder)?;
    let mut kept = Kept::of(folder.join("kept.json"), args.again)?;
    let result = folder.join("mutants.out/outcomes.json");
    kept.take(&result)?;
    let rounds = if args.page { &[] } else { room.rounds };
    let source = root().join(FOLDER).join("tree");
    for tests in rounds {
        let is_open = |mutant: &&&Mutant| kept.is_open(mutant);
        let open: Vec<&Mutant> = sample.iter().filter(is_open).copied().collect();
        if open.is_empty() {
            continue;
        }
        say(&format!(
            "mutants: {} of {} in {}, by the tests of {}",
            open.len(),
            all.len(),
            room.name,
            tests.packages.join(", ")
        ));
        tree::refresh(root(), &source)?;
        // A compiler that was stopped as it wrote what it keeps of a mutant would take it for the source.
        let kept_by_compiler = root().join(FOLDER).join("build/mutants/incremental");
        if kept_by_compiler.exists() {
            fs::remove_dir_all(kept_by_compiler)?;
        }
        shell::run(unchanged(tests).current_dir(&source)).context("the tests without a mutant")?;
        // A run that is stopped has then tried the first of the order, not those of the first files.
        for batch in open.chunks(BATCH) {
            fs::write(folder.join(LINES), lines::diff(batch, &source)?)?;
            // It ends with 2 or 3 where a mutant was missed; what became of each is in its file.
            let _ = trial(room, tests, batch, &folder)
                .current_dir(&source)
                .status()
                .context("cargo-mutants does not run")?;
            kept.take(&result)?;
        }
    }
    page::write(room, args.seed, all.len(), &sample, &kept)
}

/// All mutants of a room, without those that it tries whichever are asked for.
fn listed(room: &Room) -> Result<Vec<Mutant>> {
    let mut list = mutants(room);
    list.args(["--list", "--json"]);
    list.arg(format!("--file={}/**", room.name));
    let listed = output(&mut list).context("cargo-mutants lists nothing")?;
    let mut all: Vec<Mutant> = serde_json::from_str(&listed).context("a list of mutants")?;
    all.retain(|mutant| !mutant.name.contains(": delete field "));
    Ok(all)
}

/// The first of all, in the order of the seed.
fn sample<'a>(all: &'a [Mutant], args: &Args) -> Vec<&'a Mutant> {
    let mut sample: Vec<&Mutant> = all.iter().collect();
    sample.sort_by_key(|mutant| place(args.seed, &mutant.name));
    sample.truncate(args.each);
    sample
}

fn mutants(room: &Room) -> Command {
    let mut mutants = cargo();
    mutants.args(["mutants", "--package", room.package]);
    mutants
}

/// The environment in which tests run.
fn setting(command: &mut Command, tests: &Tests) {
    // What is compiled for all mutants is compiled once for all rounds.
    command.env("CARGO_TARGET_DIR", root().join(FOLDER).join("build"));
    // That a test fails is enough: it need not show the least that it fails with.
    command.env("UNOCLP_TRIES", "0");
    command.env("UNOCLP_ROUNDS", tests.percent.to_string());
}

/// The tests of the source as it is: cargo-mutants itself would run those of the room's own package alone.
fn unchanged(tests: &Tests) -> Command {
    let mut test = cargo();
    setting(&mut test, tests);
    test.args(["test", "--quiet", "--profile=mutants"]);
    for package in tests.packages {
        test.args(["--package", package]);
    }
    test.args(tests.targets).arg("--").args(tests.words);
    test
}

fn trial(room: &Room, tests: &Tests, open: &[&Mutant], folder: &Path) -> Command {
    let mut trial = mutants(room);
    setting(&mut trial, tests);
    trial.args(["--in-place", "--no-shuffle", "--profile=mutants"]);
    trial.arg("--baseline=skip");
    trial.arg(format!("--timeout={}", tests.patience));
    trial.arg("--output").arg(folder);
    // Else those that leave out a field come with their file, whatever their name.
    trial.arg("--in-diff").arg(folder.join(LINES));
    let files = open
        .iter()
        .filter_map(|mutant| mutant.name.split(':').next());
    for file in files.collect::<BTreeSet<&str>>() {
        trial.arg(format!("--file={file}"));
    }
    for package in tests.packages {
        trial.args(["--test-package", package]);
    }
    for target in tests.targets {
        trial.arg(format!("--cargo-arg={target}"));
    }
    for mutant in open {
        trial
            .arg("--re")
            .arg(format!("^{}$", escaped(&mutant.name)));
    }
    if !tests.words.is_empty() {
        trial.args(["--", "--"]).args(tests.words);
    }
    trial
}

/// Where a mutant stands among all: by this number, and by nothing else that it has. So a mutant that comes in changes no other's
/// place.
fn place(seed: u64, name: &str) -> u64 {
    let start = 0xcbf2_9ce4_8422_2325 ^ seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    // The line of a mutant moves with what stands above it.
    let name = kept::without_line(name);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_stays_the_same_as_lines_move_and_is_another_by_another_seed() {
        let [one, moved] = ["a.rs:1:2: replace x", "a.rs:7:2: replace x"];
        assert_eq!(place(1, one), place(1, moved));
        assert_ne!(place(1, one), place(2, one));
        assert_eq!(escaped("f(x) -> a::b"), r"f\(x\) -> a::b");
    }
}
