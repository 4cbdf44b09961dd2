//! `cargo xtask fuzz`: runs a target of `proof/fuzz/`, with AddressSanitizer, guided by the code that inputs reach.
//!
//! Everything is compiled by the Rust that runs this: RUSTC_BOOTSTRAP lets a stable compiler take
//! `-Zsanitizer`. What is found stands under `target/fuzz/`; the corpus in the repository, which runs as plain
//! tests, changes only with `--keep`.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result};
use clap::ValueEnum;

use crate::shell::{self, cargo, say};

/// What there is to fuzz.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Target {
    /// Program files, and programs in their stored form
    Loader,
    /// Instruction List
    Il,
    /// Structured Text, SCL, InterSCL and LCE
    Typed,
    /// Requests to the Modbus server
    Modbus,
    /// Damaged cards
    Card,
    /// What a page asks
    Asks,
}

impl Target {
    fn name(self) -> &'static str {
        match self {
            Target::Loader => "loader",
            Target::Il => "il",
            Target::Typed => "typed",
            Target::Modbus => "modbus",
            Target::Card => "card",
            Target::Asks => "asks",
        }
    }
}

/// The words after `cargo xtask fuzz`.
#[derive(clap::Args)]
pub struct Args {
    /// What to fuzz
    target: Target,
    /// How many seconds to fuzz
    #[arg(long, default_value_t = 60)]
    seconds: u32,
    /// Put the smallest inputs that reach the same code into proof/fuzz/corpus/ at the end
    #[arg(long)]
    keep: bool,
}

/// The longest input that is tried, in bytes: the corpus stays small.
const LONGEST: &str = "-max_len=512";

/// As cargo-fuzz has them: a counter for each edge, a table of their places, comparisons that the fuzzer sees,
/// and AddressSanitizer.
const FLAGS: [&str; 7] = [
    "--cfg=fuzzing",
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
    "-Zsanitizer=address",
];

/// Builds the target and runs it.
///
/// # Errors
/// If it does not build, or an input breaks a promise; libFuzzer names its file then.
pub fn run(args: &Args) -> Result<()> {
    let target = args.target.name();
    say(&format!("fuzz: compiling the target {target}"));
    let program = build(target)?;
    let folder = |of: &str| -> Result<PathBuf> {
        let folder = shell::root().join("target/fuzz").join(of).join(target);
        fs::create_dir_all(&folder)
            .with_context(|| format!("cannot create {}", folder.display()))?;
        Ok(folder)
    };
    let (work, found) = (folder("work")?, folder("found")?);
    let corpus = shell::root().join("proof/fuzz/corpus").join(target);

    say(&format!("fuzz: {} s", args.seconds));
    let mut fuzz = Command::new(&program);
    fuzz.arg(format!("-max_total_time={}", args.seconds));
    fuzz.arg(format!("-artifact_prefix={}/", found.display()));
    fuzz.args([LONGEST, "-print_final_stats=1"]);
    shell::run(fuzz.arg(&work).arg(&corpus))?;
    if args.keep {
        keep(&program, &work, &corpus)?;
    }
    Ok(())
}

fn build(target: &str) -> Result<PathBuf> {
    let mut rustc = Command::new("rustc");
    rustc.current_dir(shell::root());
    let host = shell::output(rustc.args(["--print", "host-tuple"]))
        .context("rustc does not print its target")?;
    let folder = shell::root().join("target/fuzz");
    let mut build = cargo();
    build.args([
        "build",
        "--release",
        "--manifest-path=proof/fuzz/Cargo.toml",
    ]);
    // With --target the flags are not for build scripts and macros.
    build.args([&format!("--target={host}"), &format!("--bin={target}")]);
    build.arg("--target-dir").arg(&folder);
    build.env("CARGO_ENCODED_RUSTFLAGS", FLAGS.join("\x1F"));
    shell::run(build.env("RUSTC_BOOTSTRAP", "1"))?;
    Ok(folder.join(host).join("release").join(target))
}

/// Makes the corpus again from what it holds and what has been found.
fn keep(program: &PathBuf, work: &PathBuf, corpus: &PathBuf) -> Result<()> {
    say("fuzz: choosing the inputs to keep");
    let old = corpus.with_extension("old");
    fs::rename(corpus, &old).with_context(|| format!("cannot move {}", corpus.display()))?;
    fs::create_dir_all(corpus).with_context(|| format!("cannot create {}", corpus.display()))?;
    let mut merge = Command::new(program);
    merge.args(["-set_cover_merge=1", LONGEST]);
    shell::run(merge.arg(corpus).arg(&old).arg(work))?;
    fs::remove_dir_all(&old).with_context(|| format!("cannot remove {}", old.display()))
}
