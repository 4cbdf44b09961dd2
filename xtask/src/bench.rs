//! `cargo xtask bench`: measures the firmwares on simulated boards, the rest on this PC, and writes
//! `docs/benchmarks.md`, and beside it the pages of the compiler, the editor and the machines; with `--site`,
//! `docs/site-benchmarks.md`.

mod machines;
mod site;

use std::path::Path;
use std::process::Command;

use anyhow::Result;
use unoclp_boot::Model;

use crate::demo::simulator;
use crate::firmware::{self, Firmware};
use crate::setup;
use crate::shell::{self, cargo, say};

/// The page with all figures.
const PAGE: &str = "docs/benchmarks.md";

/// The page with those of the compiler.
const COMPILER_PAGE: &str = "docs/compile-benchmarks.md";

/// The page with those of the editor.
const EDITOR_PAGE: &str = "docs/editor-benchmarks.md";

/// The words after `cargo xtask bench`.
#[derive(clap::Args)]
pub struct Args {
    /// Measure only the machines
    #[arg(long)]
    machines: bool,
    /// Measure only a site: a thousand boards, and a long history. Other runs do not measure it
    #[arg(long)]
    site: bool,
}

/// Sets up, builds the firmware, and has the simulator measure it beside its yardsticks.
///
/// # Errors
/// If a step fails. A target that is not met is no failure: the page says so.
pub fn run(args: &Args) -> Result<()> {
    if args.machines {
        return machines::run();
    }
    if args.site {
        return site::run();
    }
    let toolchain = setup::for_simulator()?;
    let uno = firmware::build(&toolchain, Model::Uno)?;
    let mega = firmware::build(&toolchain, Model::Mega)?;
    say("bench: compiling the simulator");
    shell::run(simulator("build").arg("--bin=bench"))?;
    say("bench: measuring; this takes a minute or two");
    shell::run(&mut bench(&uno, &mega, &shell::root().join(PAGE)))?;
    say("bench: measuring the compiler");
    shell::run(&mut page_bench("unoclp-lang", "lines", COMPILER_PAGE))?;
    say("bench: measuring the editor");
    shell::run(&mut page_bench("unoclp-assist", "editor", EDITOR_PAGE))?;
    say("bench: measuring the machines");
    machines::run()
}

/// A program that measures and writes a page, built as users build theirs.
fn page_bench(package: &str, bench: &str, page: &str) -> Command {
    let mut command = cargo();
    command.args(["bench", "--quiet", "--package", package, "--bench", bench]);
    command.args(["--", "--page"]).arg(shell::root().join(page));
    command
}

/// The program that measures.
fn bench(uno: &Firmware, mega: &Firmware, page: &Path) -> Command {
    let mut command = simulator("run");
    command.args(["--quiet", "--bin=bench", "--", "--elf"]);
    command.arg(&uno.elf).arg("--mega").arg(&mega.elf);
    command.arg("--page").arg(page);
    command
}
