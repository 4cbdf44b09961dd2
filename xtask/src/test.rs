//! `cargo xtask test`: everything that must pass; `cargo xtask soak`: more of the random tests.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, bail};
use unoclp_boot::Model;

use crate::count::{self, Count};
use crate::programs::{self, Round, Tally};
use crate::shell::{self, cargo, say};
use crate::steps::{Steps, both, gate};
use crate::{firmware, lab, long, node, setup, tested};

/// What runs on a PC.
const HOST: [&str; 3] = ["--workspace", "--exclude", "unoclp-firmware"];
const DENY: [&str; 3] = ["--", "-D", "warnings"];
/// Percent of the rounds of random tests that a quick run makes. Of all cases it takes one of eleven: no
/// number of kinds is a multiple of that, so each kind has its turn.
const QUICK: u32 = 9;
/// What takes longer in a whole run is no part of a quick one, unless it makes fewer rounds there.
const LONG: Duration = Duration::from_secs(1);
/// What needs a firmware that was built here.
const BUILT: [&str; 4] = [
    "xtask tested the_pinned_tools_have_built_what_the_suite_runs_on",
    "xtask tested the_files_are_what_this_tree_builds",
    "xtask equivalence",
    "suite::every_scenario_in_lockstep_before_the_firmware_is_shortened",
];

/// The words after `cargo xtask test`.
#[derive(clap::Args)]
pub struct TestArgs {
    /// Leave out clippy, the documentation and its examples, ten of eleven random rounds and cases, and tests that took
    /// a second or more in the last full run
    #[arg(long)]
    quick: bool,
    /// Run the tests on the tested firmware, firmware/unoclp-uno.hex with its symbols, and build no firmware
    #[arg(long)]
    kept: bool,
}

/// The words after `cargo xtask soak`.
#[derive(clap::Args)]
pub struct SoakArgs {
    /// The number of rounds, as a multiple of the rounds of `cargo xtask test`
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    times: u32,
}

/// Sets up, and takes one step after the other until one fails. The last line says how many tests
/// have passed.
///
/// # Errors
/// If a step fails; the text names it.
pub fn run(args: &TestArgs) -> Result<()> {
    let xtask = itself()?;
    let toolchain = setup::for_tests(args.kept)?;
    let steps = Steps::default();
    let mut round = Round::default();
    if args.kept {
        say(&format!(
            "on the tested firmware: without {}",
            BUILT.join(", ")
        ));
        round.firmware = Some(tested::hex(Model::Uno));
    }
    let build_firmware = || match args.kept {
        true => Ok(()),
        false => build_firmware(&steps, &xtask),
    };
    let is_wanted = |name: &str| !args.kept || !BUILT.iter().any(|built| name.contains(built));
    if args.quick {
        say(
            "quick: without clippy, documentation and its examples; with one in eleven random rounds and cases",
        );
        say(&format!(
            "quick: without tests that took {} s or more in the last full run, and without {}",
            LONG.as_secs(),
            long::WHOLE.join(", ")
        ));
        let times = programs::Times::load();
        let is_quick = |name: &str| {
            let is_whole = long::WHOLE.iter().any(|long| name.ends_with(long));
            !is_whole && (long::is_of_cases(name) || !times.took(name, LONG))
        };
        round.percent = QUICK;
        let is_asked = |name: &str| is_quick(name) && is_wanted(name);
        let ((programs, tally), ()) = both(
            || {
                let programs = steps.take("compiling the tests", programs::compile)?;
                let tally = test(&steps, &programs, &round, false, is_asked)?;
                Ok((programs, tally))
            },
            || build_firmware().and_then(|()| build_lab(&steps)),
        )?;
        let tally = tally.and(test(&steps, &programs, &round, true, is_asked)?);
        return report(&steps, &tally, test_lab(&steps, &round)?);
    }
    steps.take("format", format)?;
    // What waits for the lock of `target/` beside what has a folder of its own: each side is about one processor's work.
    // Whichever has done its own takes what is left of the page's tests with the other.
    let pages = lab::Tests::find()?;
    let (compiled, are_compiled) = gate();
    let (firmware_built, is_firmware_built) = gate();
    let (page_built, is_page_built) = gate();
    let ((tally, mut others), of_the_page) = both(
        || {
            let programs = check_and_compile(&steps)?;
            compiled.open();
            let mut others = steps.take("examples in the documentation", test_examples)?;
            let tally = test(&steps, &programs, &round, false, is_wanted)?;
            is_firmware_built.pass()?;
            let tally = tally.and(test(&steps, &programs, &round, true, is_wanted)?);
            others += test_lab(&steps, &round)?;
            is_page_built.pass()?;
            // This puts another `unoclp` in the place of the one that has been tested.
            others += test_page_inside(&steps)?;
            others += pages.run(&steps)?;
            Ok((tally, others))
        },
        || {
            if !args.kept {
                for board in firmware::BOARDS {
                    let mut clippy = firmware::cargo(&toolchain, "clippy", board);
                    let step = format!("clippy on the firmware, {}", board.name());
                    steps.run_aside(&step, clippy.args(DENY))?;
                }
            }
            build_firmware()?;
            build_lab(&steps)?;
            firmware_built.open();
            let page = ["lab", "--build"];
            steps.run_aside("the page", Command::new(&xtask).args(page))?;
            page_built.open();
            // Some pages speak to the simulated UNO.
            are_compiled.pass()?;
            pages.run(&steps)
        },
    )?;
    others += of_the_page;
    report(&steps, &tally, others)
}

/// Tries the page inside the program `unoclp`.
fn test_page_inside(steps: &Steps) -> Result<Count> {
    let mut serve = cargo();
    // With the features that the other tests have been compiled with: hardly anything is compiled again.
    serve.arg("test").args(HOST).args(["--test", "serve"]);
    serve.args(["--features", "xtask/avr-tools,unoclp-cli/page"]);
    let inside = "tests of the page inside unoclp";
    steps.count_aside(inside, &mut serve, count::by_cargo)
}

/// Sets up, builds, and makes many times the rounds of the random tests.
///
/// # Errors
/// If a step or a test fails.
pub fn soak(args: &SoakArgs) -> Result<()> {
    let xtask = itself()?;
    setup::for_tests(false)?;
    let steps = Steps::default();
    let (programs, ()) = both(
        || steps.take("compiling the tests", programs::compile),
        || build_firmware(&steps, &xtask).and_then(|()| build_lab(&steps)),
    )?;
    let round = Round {
        percent: 100 * args.times,
        ..Round::default()
    };
    let tests = || programs.run(&round, long::is_random);
    let tally = steps.take("random tests", tests)?;
    steps.run_aside("the page", Command::new(&xtask).args(["lab", "--build"]))?;
    let open = steps.take("a page that is open for ten minutes", lab::soak)?;
    report(&steps, &tally, open)
}

fn format() -> Result<()> {
    shell::run(cargo().args(["fmt", "--all", "--check"]))?;
    let fuzz = ["fmt", "--manifest-path=proof/fuzz/Cargo.toml", "--check"];
    shell::run(cargo().args(fuzz))
}

/// What waits for the one lock of `target/`: clippy, the documentation, and the tests' programs.
fn check_and_compile(steps: &Steps) -> Result<programs::Programs> {
    steps.take("clippy on the code for a PC", || {
        let mut clippy = cargo();
        clippy.arg("clippy").args(HOST).arg("--all-targets");
        shell::run(clippy.args(["--features", "xtask/avr-tools"]).args(DENY))
    })?;
    steps.take("documentation", || {
        let mut doc = cargo();
        doc.args(["doc", "--no-deps"]).args(HOST);
        shell::run(doc.env("RUSTDOCFLAGS", "-D warnings"))
    })?;
    steps.take("compiling the tests", programs::compile)
}

/// Tests on the PC, or those that look at what was built here beside the tests: on the simulated UNO, and of xtask itself.
fn test(
    steps: &Steps,
    programs: &programs::Programs,
    round: &Round,
    on_uno: bool,
    is_wanted: impl Fn(&str) -> bool,
) -> Result<Tally> {
    let step = match on_uno {
        true => "tests on the simulated UNO",
        false => "tests on the PC",
    };
    let is_here = |name: &str| programs::needs_firmware(name) == on_uno && is_wanted(name);
    steps.take(step, || programs.run(round, is_here))
}

fn test_examples() -> Result<Count> {
    let mut examples = cargo();
    examples.args(["test", "--doc"]).args(HOST);
    count::tests(&mut examples, count::by_cargo)
}

/// Where xtask stands, asked before anything is compiled: after that another program may stand in its place, and the
/// system calls the one that runs deleted.
fn itself() -> Result<PathBuf> {
    std::env::current_exe().context("cannot find xtask itself")
}

/// A process of its own, whose output does not mix with that of what is done meanwhile.
fn build_firmware(steps: &Steps, xtask: &Path) -> Result<()> {
    steps.run_aside("firmware", Command::new(xtask).arg("firmware"))
}

/// What the suite runs the firmware on beside simavr, and its tests.
fn build_lab(steps: &Steps) -> Result<()> {
    steps.take("the simulated board of the lab", node::build)
}

fn test_lab(steps: &Steps, round: &Round) -> Result<Count> {
    steps.take("tests of the simulated board on Node", || {
        node::test(round.firmware.as_deref())
    })
}

/// Says how long steps and tests took, what has failed, and how many have passed.
fn report(steps: &Steps, tally: &Tally, mut sum: Count) -> Result<()> {
    say("the slowest tests");
    print!("{}", tally.slowest(10));
    say("the steps; some ran at the same time");
    print!("{}", steps.table());
    let failed = tally.failed();
    for name in &failed {
        println!("FAILED {name}");
    }
    sum += Count {
        passed: tally.passed(),
        failed: failed.len(),
    };
    println!("{} passed, {} failed", sum.passed, sum.failed);
    if sum.failed > 0 {
        bail!("{} tests failed", sum.failed);
    }
    Ok(())
}
