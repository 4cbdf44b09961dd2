//! `cargo xtask bench`: measures the firmware on a simulated UNO, the compiler and the machines on this PC, and writes
//! `docs/benchmarks.md`, `docs/compile-benchmarks.md` and `docs/machine-benchmarks.md`; with `--site`, `docs/site-benchmarks.md`.

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

/// The words after `cargo xtask bench`.
#[derive(clap::Args)]
pub struct Args {
    /// Measure the machines alone
    #[arg(long)]
    machines: bool,
    /// Measure a site alone: a thousand boards, and a long history; not done otherwise
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
    let firmware = firmware::build(&toolchain, Model::Uno)?;
    say("bench: compiling the simulator");
    shell::run(simulator("build").arg("--bin=bench"))?;
    say("bench: measuring; this takes a minute or two");
    shell::run(&mut bench(&firmware, &shell::root().join(PAGE)))?;
    say("bench: measuring the compiler");
    shell::run(&mut compiler_bench(&shell::root().join(COMPILER_PAGE)))?;
    say("bench: measuring the machines");
    machines::run()
}

/// The program that measures the compiler, built as users build theirs.
fn compiler_bench(page: &Path) -> Command {
    let mut command = cargo();
    command.args(["bench", "--quiet", "--package=unoclp-lang", "--bench=lines"]);
    command.args(["--", "--page"]).arg(page);
    command
}

/// The program that measures.
fn bench(firmware: &Firmware, page: &Path) -> Command {
    let mut command = simulator("run");
    command.args(["--quiet", "--bin=bench", "--", "--elf"]);
    command.arg(&firmware.elf).arg("--page").arg(page);
    command
}
