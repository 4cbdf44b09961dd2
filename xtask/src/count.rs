//! Counts tests, by what their harness prints.

use std::io::{BufRead, BufReader};
use std::ops::AddAssign;
use std::process::{Command, Stdio};

use anyhow::{Context, Result, ensure};

use crate::shell;

/// How many tests have passed and failed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Passed.
    pub passed: usize,
    /// Failed.
    pub failed: usize,
}

impl Count {
    /// What a harness has printed, by one who knows its lines.
    pub fn of(text: &str, counted: fn(&str) -> Option<Count>) -> Count {
        let mut sum = Count::default();
        for count in text.lines().filter_map(counted) {
            sum += count;
        }
        sum
    }
}

impl AddAssign for Count {
    fn add_assign(&mut self, other: Count) {
        self.passed += other.passed;
        self.failed += other.failed;
    }
}

/// Runs tests, shows what they print, and counts them: `counted` knows the lines of the harness.
///
/// # Errors
/// If one fails, or there are none.
pub fn tests(command: &mut Command, counted: fn(&str) -> Option<Count>) -> Result<Count> {
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
pub fn by_cargo(line: &str) -> Option<Count> {
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

/// The number of a line such as `ℹ pass 7`, at the end of what Node prints.
pub fn by_node(line: &str) -> Option<Count> {
    let (name, number) = line.strip_prefix("ℹ ")?.split_once(' ')?;
    let number = number.parse().ok()?;
    match name {
        "pass" => Some(Count {
            passed: number,
            failed: 0,
        }),
        "fail" | "cancelled" => Some(Count {
            passed: 0,
            failed: number,
        }),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{Count, by_cargo, by_node};

    fn count(passed: usize, failed: usize) -> Option<Count> {
        Some(Count { passed, failed })
    }

    #[test]
    fn only_the_result_lines_of_the_harness_are_counted() {
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
            assert_eq!(by_cargo(line), expected, "{line}");
        }
    }

    #[test]
    fn only_the_last_lines_of_node_are_counted() {
        let cases = [
            ("ℹ tests 56", None),
            ("ℹ pass 55", count(55, 0)),
            ("ℹ fail 1", count(0, 1)),
            ("ℹ cancelled 2", count(0, 2)),
            ("ℹ duration_ms 24952.8", None),
            ("✔ pass 3", None),
            ("ℹ pass", None),
        ];
        for (line, expected) in cases {
            assert_eq!(by_node(line), expected, "{line}");
        }
    }
}
