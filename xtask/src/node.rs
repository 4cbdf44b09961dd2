//! What Node runs of `page/`: the simulated board as an engine of the suite, its tests, and those of the page that need no
//! browser.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::card::{self, Kind};
use crate::count::{self, Count};
use crate::programs::FIRMWARE;
use crate::shell::{self, say};

/// Programs that the tests of the board put into its slot.
const PROGRAMS: &str = "page/uno/test/programs";
/// Where they lie as images of cards, one for each.
const CARDS: &str = "target/uno/cards";
/// The bundles of the tests.
const TESTS: [&str; 2] = ["target/uno/test", "target/lab/test"];
/// Tests of files of the repository, which are run as they are.
const FILES: &str = "page/web/test/files";

/// The command npm, which is a script on Windows.
pub const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

/// Installs the packages that `page/package-lock.json` names, unless they are there.
///
/// # Errors
/// If npm cannot.
pub fn install() -> Result<()> {
    let page = page();
    let lock = fs::read(page.join("package-lock.json")).context("no page/package-lock.json")?;
    let mark = page.join("node_modules/.installed");
    if fs::read(&mark).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    say("setup: installing the packages of the lab, with npm");
    // Nobody else's script runs for it.
    let arguments = ["ci", "--ignore-scripts", "--no-audit", "--no-fund"];
    shell::run(Command::new(NPM).current_dir(page).args(arguments))?;
    fs::write(&mark, lock).with_context(|| format!("cannot write {}", mark.display()))
}

/// Has the types checked, and bundles the board for Node, its tests, and those of the page that need no browser.
///
/// # Errors
/// If a type is wrong.
pub fn build() -> Result<()> {
    install()?;
    let mut check = Command::new(NPM);
    check.current_dir(page()).arg("--silent");
    shell::run(check.args(["run", "check"]))?;
    for (room, parts) in [("uno", &["engine", "test"][..]), ("web", &["test"])] {
        let mut bundle = Command::new("node");
        bundle.current_dir(page().join(room)).arg("build.mjs");
        shell::run(bundle.args(parts))?;
    }
    Ok(())
}

/// Runs these tests, with this firmware, or the one that was built.
///
/// # Errors
/// If one fails.
pub fn test(firmware: Option<&Path>) -> Result<Count> {
    for program in files(&shell::root().join(PROGRAMS), ".txt")? {
        let name = program.with_extension("img");
        let image = shell::root()
            .join(CARDS)
            .join(name.file_name().unwrap_or_default());
        card::write(&program, &image, Kind::Fat16, false, true)?;
    }
    let mut tests = Vec::new();
    for folder in TESTS.iter().chain([&FILES]) {
        tests.extend(files(&shell::root().join(folder), ".test.mjs")?);
    }
    let mut node = Command::new("node");
    node.args(["--test", "--test-concurrency=2", "--test-reporter=spec"]);
    node.args(tests);
    node.envs(firmware.map(|file| (FIRMWARE, file)));
    count::tests(&mut node, count::by_node)
}

/// Where the lock file of the packages and the packages are.
pub fn page() -> PathBuf {
    shell::root().join("page")
}

/// Where the page stands.
pub fn folder() -> PathBuf {
    page().join("web")
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
