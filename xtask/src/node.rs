//! What Node runs of the lab: the simulated board as an engine of the suite, and its own tests.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::card::{self, Kind};
use crate::count::{self, Count};
use crate::shell::{self, say};

/// Programs that the tests of the board put into its slot.
const PROGRAMS: &str = "page/web/test/board/programs";
/// Where they lie as images of cards, one for each.
const CARDS: &str = "target/lab/cards";
/// The bundles of the tests.
const TESTS: &str = "target/lab/test";
/// Tests of files of the repository, which are run as they are.
const FILES: &str = "page/web/test/files";

/// The command npm, which is a script on Windows.
pub const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

/// Installs the packages that `page/web/package-lock.json` names, unless they are there.
///
/// # Errors
/// If npm cannot.
pub fn install() -> Result<()> {
    let lock =
        fs::read(folder().join("package-lock.json")).context("no page/web/package-lock.json")?;
    let mark = folder().join("node_modules/.installed");
    if fs::read(&mark).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    say("setup: installing the packages of the lab, with npm");
    // Nobody else's script runs for it.
    let arguments = ["ci", "--ignore-scripts", "--no-audit", "--no-fund"];
    shell::run(Command::new(NPM).current_dir(folder()).args(arguments))?;
    fs::write(&mark, lock).with_context(|| format!("cannot write {}", mark.display()))
}

/// Has the types checked, and bundles the board for Node, and its tests.
///
/// # Errors
/// If a type is wrong.
pub fn build() -> Result<()> {
    install()?;
    shell::run(npm().args(["run", "check"]))?;
    let mut bundle = Command::new("node");
    bundle.current_dir(folder());
    shell::run(bundle.args(["build.mjs", "engine", "test"]))
}

/// Runs the tests of the board, with the firmware that is there.
///
/// # Errors
/// If one fails.
pub fn test() -> Result<Count> {
    for program in files(&shell::root().join(PROGRAMS), ".txt")? {
        let name = program.with_extension("img");
        let image = shell::root()
            .join(CARDS)
            .join(name.file_name().unwrap_or_default());
        card::write(&program, &image, Kind::Fat16, false, true)?;
    }
    let mut tests = files(&shell::root().join(TESTS), ".test.mjs")?;
    tests.extend(files(&shell::root().join(FILES), ".test.mjs")?);
    let mut node = Command::new("node");
    node.args(["--test", "--test-concurrency=2", "--test-reporter=spec"]);
    node.args(tests);
    count::tests(&mut node, count::by_node)
}

fn npm() -> Command {
    let mut npm = Command::new(NPM);
    npm.current_dir(folder()).arg("--silent");
    npm
}

/// Where the lab stands.
pub fn folder() -> PathBuf {
    shell::root().join("page/web")
}

/// The files below a folder whose names end so, in order.
///
/// # Errors
/// If a folder cannot be read.
pub fn files(folder: &Path, end: &str) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    let entries =
        fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    for entry in entries {
        let path = entry?.path();
        if path.is_dir() {
            found.extend(files(&path, end)?);
        } else if path.to_string_lossy().ends_with(end) {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}
