//! `cargo xtask test`: everything that must pass.

use std::io::{BufRead, BufReader};
use std::ops::AddAssign;
use std::process::{Command, Stdio};
use std::time::Instant;

use anyhow::{Context, Result, ensure};

use crate::shell::{self, cargo, say};
use crate::{demo, firmware, setup, wasm};

/// Sets up, and takes one step after the other until one fails. The last line says how many tests
/// have passed.
///
/// # Errors
/// If a step fails; the text names it.
pub fn run() -> Result<()> {
    let toolchain = setup::for_tests()?;
    const HOST: [&str; 3] = ["--workspace", "--exclude", "unoclp-firmware"];
    const DENY: [&str; 3] = ["--", "-D", "warnings"];

    step("format", || {
        shell::run(cargo().args(["fmt", "--all", "--check"]))
    })?;
    step("clippy on what runs on a PC", || {
        let mut clippy = cargo();
        clippy.arg("clippy").args(HOST).arg("--all-targets");
        shell::run(clippy.args(["--features", "xtask/avr-tools"]).args(DENY))
    })?;
    step("clippy on the firmware", || {
        shell::run(firmware::cargo(&toolchain, "clippy").args(DENY))
    })?;
    step("documentation", || {
        let mut doc = cargo();
        doc.args(["doc", "--no-deps"]).args(HOST);
        shell::run(doc.env("RUSTDOCFLAGS", "-D warnings"))
    })?;
    step("libraries for WebAssembly", || wasm::check(&toolchain))?;
    let mut sum = step("tests on the PC", || {
        let mut test = cargo();
        test.arg("test")
            .args(HOST)
            .args(["--exclude", "unoclp-uno-sim"]);
        tests(&mut test)
    })?;
    step("firmware", || firmware::build(&toolchain))?;
    sum += step("tests of what the compiler has made", || {
        let options = [
            "--package=xtask",
            "--features=avr-tools",
            "--test=equivalence",
            "--test=miscompile",
        ];
        // Shown, because the tests print how much was compared.
        tests(
            cargo()
                .arg("test")
                .args(options)
                .args(["--", "--nocapture"]),
        )
    })?;
    sum += step("tests of the firmware on the simulated UNO", || {
        // Shown, because the tests print what they measure: scenarios, times, stack.
        tests(demo::simulator("test").args(["--", "--nocapture"]))
    })?;
    println!("{} passed, {} failed", sum.passed, sum.failed);
    Ok(())
}

/// Takes a step and says which, and how long it took.
fn step<T>(name: &str, work: impl FnOnce() -> Result<T>) -> Result<T> {
    say(name);
    let start = Instant::now();
    let done = work().with_context(|| format!("the step \"{name}\" failed"))?;
    say(&format!("{name}: {:.1} s", start.elapsed().as_secs_f32()));
    Ok(done)
}

/// How many tests have passed and failed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Count {
    passed: u32,
    failed: u32,
}

impl AddAssign for Count {
    fn add_assign(&mut self, other: Count) {
        self.passed += other.passed;
        self.failed += other.failed;
    }
}

/// Runs tests, shows what they print, and counts them.
fn tests(command: &mut Command) -> Result<Count> {
    let mut child = command
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| shell::not_started(command, error))?;
    let mut sum = Count::default();
    if let Some(stdout) = child.stdout.take() {
        for line in BufReader::new(stdout).lines() {
            let line = line.context("cannot read what the tests print")?;
            println!("{line}");
            if let Some(count) = counted(&line) {
                sum += count;
            }
        }
    }
    let status = child.wait()?;
    ensure!(
        status.success(),
        "{} passed, {} failed",
        sum.passed,
        sum.failed
    );
    ensure!(sum.passed > 0, "no test was run");
    Ok(sum)
}

/// The numbers of a line such as `test result: ok. 7 passed; 0 failed; 0 ignored; …`.
fn counted(line: &str) -> Option<Count> {
    let words: Vec<_> = line
        .strip_prefix("test result: ")?
        .split([' ', ';'])
        .collect();
    let before = |name| {
        let at = words.iter().position(|&word| word == name)?;
        words.get(at.checked_sub(1)?)?.parse().ok()
    };
    Some(Count {
        passed: before("passed")?,
        failed: before("failed")?,
    })
}

#[cfg(test)]
mod tests {
    use super::{Count, counted};

    #[test]
    fn only_the_result_lines_of_the_harness_are_counted() {
        let count = |passed, failed| Some(Count { passed, failed });
        let cases = [
            (
                "test result: ok. 12 passed; 0 failed; 0 ignored; 0 measured; 3 filtered out; finished in 0.01s",
                count(12, 0),
            ),
            (
                "test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out",
                count(3, 2),
            ),
            ("test counts::a_test ... ok", None),
            ("the test result: ok. 12 passed; 0 failed", None),
            ("test result: ok.", None),
            ("test result: passed; failed", None),
            ("", None),
        ];
        for (line, expected) in cases {
            assert_eq!(counted(line), expected, "{line}");
        }
    }
}
