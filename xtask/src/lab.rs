//! `cargo xtask lab`: the page, built into `target/lab/page` and served; and its tests in a real Chromium.

use std::process::Command;

use anyhow::Result;

use crate::count::{self, Count};
use crate::node::{self, files};
use crate::shell::{self, say};
use crate::{setup, wasm};

/// Where the tests of the page are.
const TESTS: &str = "page/web/test/page";

/// The words after `cargo xtask lab`.
#[derive(clap::Args)]
pub struct Args {
    /// Where to serve it, on this computer alone; 0 takes a free port
    #[arg(long, default_value_t = 8420)]
    port: u16,
    /// Build it and no more
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

/// The command that tests the page that was built.
///
/// # Errors
/// If there are no tests.
pub fn tests() -> Result<Command> {
    let mut tests = runner();
    tests.args(files(&shell::root().join(TESTS), ".test.mjs")?);
    Ok(tests)
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
    // A file at a time: the board of a page takes a processor, others run tests beside it, and a boot loader waits for a
    // second of its own.
    node.args(["--test", "--test-concurrency=1", "--test-reporter=spec"]);
    // What a failed test has left open ends with it, and no file takes more than 20 minutes.
    node.args(["--test-force-exit", "--test-timeout=1200000"]);
    node
}

fn node(arguments: &[&str]) -> Result<()> {
    let mut node = Command::new("node");
    shell::run(node.current_dir(node::folder()).args(arguments))
}
