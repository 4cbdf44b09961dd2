//! `cargo xtask lab`: the page, built into `target/lab/page` and served; and its tests in a real Chromium.

use std::cmp::Reverse;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

use anyhow::{Result, ensure};

use crate::count::{self, Count};
use crate::node::{self, files};
use crate::shell::{self, say};
use crate::steps::Steps;
use crate::{setup, wasm};

/// Where the tests of the page are.
const TESTS: &str = "page/web/test/page";

/// The words after `cargo xtask lab`.
#[derive(clap::Args)]
pub struct Args {
    /// The port of the page, on this computer only; 0 takes a free one
    #[arg(long, default_value_t = 8420)]
    port: u16,
    /// Build the page without serving it
    #[arg(long)]
    build: bool,
}

/// Sets up, builds the page, and serves it until it is stopped.
///
/// # Errors
/// If a step fails.
pub fn run(args: &Args) -> Result<()> {
    build()?;
    if args.build {
        return Ok(());
    }
    say("serving the page until Ctrl-C");
    node(&["serve.mjs", &args.port.to_string()])
}

/// Sets up, and builds the page in `target/lab/page`.
///
/// # Errors
/// If a step fails.
pub fn build() -> Result<()> {
    let toolchain = setup::for_lab()?;
    say("the tools for WebAssembly");
    wasm::build(&toolchain, &shell::root().join("target/lab"))?;
    say("the page");
    node(&["build.mjs", "page"])
}

/// The files of tests that take longest, the longest first.
const LONGEST: [&str; 7] = [
    "broken", "hands", "draw", "machine", "lessons", "flash", "truth",
];

/// The files of tests of the page that was built: whoever has a processor left takes the next. A file at a time is enough
/// for each: the board of a page takes a processor, and a boot loader waits for a second of its own.
pub struct Tests(Mutex<Vec<PathBuf>>);

impl Tests {
    /// All of them.
    ///
    /// # Errors
    /// If there are none, or one of those that take longest is not there.
    pub fn find() -> Result<Tests> {
        let mut found = files(&shell::root().join(TESTS), END)?;
        for long in LONGEST {
            let is_there = found.iter().any(|file| name(file) == long);
            ensure!(
                is_there,
                "xtask/src/lab.rs names {long}, which is not a test"
            );
        }
        let place = |file: &PathBuf| LONGEST.iter().position(|long| name(file) == *long);
        // Taken from the end.
        found.sort_by_key(|file| Reverse(place(file).unwrap_or(LONGEST.len())));
        Ok(Tests(Mutex::new(found)))
    }

    /// Runs one file after the other until none is left.
    ///
    /// # Errors
    /// If one cannot be run. A test that fails is counted.
    pub fn run(&self, steps: &Steps) -> Result<Count> {
        let next = || self.0.lock().ok()?.pop();
        let mut count = Count::default();
        while let Some(file) = next() {
            let step = format!("the page in Chromium: {}", name(&file));
            count += steps.count_aside(&step, runner().arg(&file), count::by_node)?;
        }
        Ok(count)
    }
}

const END: &str = ".test.mjs";

fn name(file: &Path) -> &str {
    let name = file.file_name().and_then(|name| name.to_str());
    name.and_then(|name| name.strip_suffix(END))
        .unwrap_or_default()
}

/// Leaves the page open for ten minutes, with a live program.
///
/// # Errors
/// If it grows.
pub fn soak() -> Result<Count> {
    let mut node = runner();
    node.env("UNOCLP_PAGE_SECONDS", "600");
    count::tests(
        node.arg(shell::root().join(TESTS).join("growth.test.mjs")),
        count::by_node,
    )
}

/// Node, for files of tests.
fn runner() -> Command {
    let mut node = Command::new("node");
    node.args(["--test", "--test-reporter=spec"]);
    // What a failed test has left open ends with it, and no file takes more than 20 minutes.
    node.args(["--test-force-exit", "--test-timeout=1200000"]);
    node
}

fn node(arguments: &[&str]) -> Result<()> {
    let mut node = Command::new("node");
    shell::run(node.current_dir(node::folder()).args(arguments))
}

#[cfg(test)]
mod tests {
    use super::{LONGEST, Tests, name};

    #[test]
    fn the_longest_come_first_and_none_is_left_out() {
        let tests = Tests::find().unwrap();
        let mut taken: Vec<_> = tests.0.into_inner().unwrap();
        taken.reverse();
        let names: Vec<&str> = taken.iter().map(|file| name(file)).collect();
        assert_eq!(names[..LONGEST.len()], LONGEST);
        assert!(names.len() > 20 && names.contains(&"view"), "{names:?}");
    }
}
