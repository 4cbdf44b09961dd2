//! `cargo xtask demo`: a program at work on a simulated UNO.

use std::path::Path;
use std::process::Command;

use anyhow::Result;
use unoclp_boot::Model;

use crate::shell::{self, say};
use crate::{card, setup, tested};

/// The program shown, and the script that presses its buttons.
const PROGRAM: &str = "programs/motor.txt";
const SCENARIO: &str = "programs/demo.toml";

/// Sets up, makes a card, and shows it at work in the tested firmware.
///
/// # Errors
/// If a step fails.
pub fn run() -> Result<()> {
    setup::for_demo()?;

    say(&format!("demo: writing {PROGRAM} to a card image"));
    let root = shell::root();
    let image = root.join("target/demo/card.img");
    card::write(&root.join(PROGRAM), &image, card::Kind::Fat16, false, true)?;

    say("demo: compiling the simulator");
    shell::run(&mut quickly("build"))?;
    say("demo: a simulated UNO boots the firmware, with that card in its slot");
    shell::run(&mut demo(&image))
}

/// The simulator's demonstration.
fn demo(image: &Path) -> Command {
    let mut command = quickly("run");
    command.args(["--quiet", "--", "demo", "--elf"]);
    command.arg(tested::hex(Model::Uno));
    command.arg("--card").arg(image);
    command.arg("--scenario").arg(shell::root().join(SCENARIO));
    command
}

/// Crates that are large, and have next to nothing to do in the demonstration.
const LARGE: [&str; 6] = [
    "unoclp-codegen",
    "unoclp-draw",
    "unoclp-exercise",
    "unoclp-il",
    "unoclp-st",
    "unoclp-tree",
];

/// A cargo command on the simulator, which takes little time to compile.
fn quickly(subcommand: &str) -> Command {
    let mut cargo = cargo(subcommand);
    for package in LARGE {
        cargo.arg(format!(
            "--config=profile.dev.package.{package}.opt-level=0"
        ));
    }
    cargo.arg("--bin=unoclp-uno-sim");
    cargo
}

/// A cargo command on the simulator.
fn cargo(subcommand: &str) -> Command {
    let mut cargo = shell::cargo();
    cargo.args([subcommand, "--package=unoclp-uno-sim"]);
    cargo
}

/// The same, as fast as it goes.
pub fn simulator(subcommand: &str) -> Command {
    let mut cargo = cargo(subcommand);
    cargo.arg("--release");
    cargo
}
