//! The pages `docs/site-benchmarks.md` and its translation: what a gateway takes for many boards, how much of a line it uses, and how
//! long a trend takes.
//!
//! Owns how it is measured. `figures`: what comes of it; `page`: what the pages say of that.

mod figures;
mod page;

use crate::lab;
use crate::node::NPM;
use crate::shell::{self, cargo, say};
use anyhow::{Context, Result};
use figures::Measured;
use page::{Lang, page};
use serde::Deserialize;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// How the program is built that is handed out.
const OF_PROGRAM: [&str; 2] = ["--no-default-features", "--features=page"];
/// Boards that gateways read, and boards that gateway and Node-RED read one after the other.
const BOARDS: &str = "1000";
const FEW: &str = "100";
/// How long each is measured, s.
const SECONDS: &str = "30";
/// Boards of a line, and its rates.
const OF_LINE: &str = "32";
const RATES: [&str; 3] = ["19200", "38400", "115200"];
/// Samples of the history.
const SAMPLES: &str = "100000000";
/// What unoclp is held against. Its client of Modbus is that of npm, since the copy that its makers use is not there.
const NODE_RED: &str = r#"{
  "private": true,
  "dependencies": { "node-red": "4.1.8", "node-red-contrib-modbus": "5.45.2" },
  "overrides": { "@openp4nr/modbus-serial": "npm:modbus-serial@8.0.25" }
}
"#;

/// Measures, and writes the pages.
///
/// # Errors
/// If a step fails. A target that is not met is no failure: the pages say so.
pub fn run() -> Result<()> {
    lab::build()?;
    say("bench: building the program in release mode");
    let mut program = cargo();
    program.args(["build", "--release", "--package=unoclp-cli"]);
    shell::run(program.args(OF_PROGRAM))?;
    let program = shell::root().join("target/release/unoclp");
    let installed = node_red()?;
    for (package, example, features) in [
        ("unoclp-cli", "scale", &OF_PROGRAM[..]),
        ("unoclp-history", "trend", &[]),
    ] {
        let mut build = cargo();
        build.args(["build", "--release", "--package", package]);
        build.args(features);
        shell::run(build.args(["--example", example]))?;
    }
    let before = load();
    say("bench: a thousand boards");
    let measure = |program: &Path, more: &[&str]| {
        let mut command = example("scale");
        command.arg(program).args(more);
        command
    };
    let scale = said(&mut measure(&program, &[BOARDS, SECONDS]))?;
    say("bench: a hundred boards, and the same with Node-RED");
    let few = said(&mut measure(&program, &[FEW, SECONDS]))?;
    let node_red = said(&mut measure(&installed, &[FEW, SECONDS]))?;
    say("bench: a line of 32 boards");
    let line = |rate| {
        // Before what else the machine does, where the system lets it: the line is asked, not the machine.
        let mut command = Command::new("nice");
        let scale = measure(&program, &[OF_LINE, SECONDS, rate]);
        command.args(["-n", "-19"]).arg(scale.get_program());
        said(command.args(scale.get_args()))
    };
    let lines = RATES.into_iter().map(line).collect::<Result<_>>()?;
    say("bench: a history of 100 million samples; this takes 3 GB and some minutes");
    let trend = said(example("trend").arg(SAMPLES))?;
    let measured = Measured {
        scale,
        few,
        node_red,
        lines,
        trend,
        load: [before, load()],
        processors: std::thread::available_parallelism().map_or(1, usize::from),
    };
    for (file, lang) in [
        ("site-benchmarks.md", Lang::En),
        ("site-benchmarks.pt-BR.md", Lang::Pt),
    ] {
        let path = shell::root().join("docs").join(file);
        let text = page(&measured, lang);
        fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
    }
    Ok(())
}

/// Installs Node-RED, which nothing else needs; gives where.
fn node_red() -> Result<PathBuf> {
    let folder = shell::root().join("target/node-red");
    if !folder.join("node_modules/node-red-contrib-modbus").is_dir() {
        say("bench: installing Node-RED, with npm");
        fs::create_dir_all(&folder)?;
        fs::write(folder.join("package.json"), NODE_RED)?;
        let mut npm = Command::new(NPM);
        npm.current_dir(&folder).args(["install", "--no-audit"]);
        npm.args(["--no-fund", "--ignore-scripts", "--omit=optional"]);
        shell::run(&mut npm)?;
    }
    Ok(folder)
}

/// An example that has been built.
fn example(name: &str) -> Command {
    let built = shell::root().join("target/release/examples").join(name);
    Command::new(built)
}

/// What a command prints, as JSON.
fn said<T: for<'d> Deserialize<'d>>(command: &mut Command) -> Result<T> {
    let told = shell::output(command).with_context(|| format!("{command:?} failed"))?;
    serde_json::from_str(&told).with_context(|| format!("{command:?} said {told}"))
}

/// How many programs have waited for a processor or had one, on average over the last minute.
fn load() -> f64 {
    let text = fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let first = text.split_whitespace().next();
    first.and_then(|first| first.parse().ok()).unwrap_or(0.0)
}
