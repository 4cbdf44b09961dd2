//! `cargo xtask bench`: measures the firmware on a simulated UNO and writes `docs/benchmarks.md`.

use std::path::Path;
use std::process::Command;

use anyhow::Result;
use unoclp_boot::Model;

use crate::demo::simulator;
use crate::firmware::{self, Firmware};
use crate::setup;
use crate::shell::{self, say};

/// The page with all figures.
const PAGE: &str = "docs/benchmarks.md";

/// Sets up, builds the firmware, and has the simulator measure it beside its yardsticks.
///
/// # Errors
/// If a step fails. A target that is not met is no failure: the page says so.
pub fn run() -> Result<()> {
    let toolchain = setup::for_simulator()?;
    let firmware = firmware::build(&toolchain, Model::Uno)?;
    say("bench: compiling the simulator");
    shell::run(simulator("build").arg("--bin=bench"))?;
    say("bench: measuring; this takes a minute or two");
    shell::run(&mut bench(&firmware, &shell::root().join(PAGE)))
}

/// The program that measures.
fn bench(firmware: &Firmware, page: &Path) -> Command {
    let mut command = simulator("run");
    command.args(["--quiet", "--bin=bench", "--", "--elf"]);
    command.arg(&firmware.elf).arg("--page").arg(page);
    command
}
