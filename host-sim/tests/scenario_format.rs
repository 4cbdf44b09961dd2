//! The scenario format: what a file says is what runs, and what is wrong is told with its line.

use std::fs;
use std::path::PathBuf;
use unoclp_host_sim::engine::HostEngine;
use unoclp_host_sim::scenario::{Refusal, Scenario, Verdict, check};

/// Writes a scenario file for one test.
fn file(name: &str, source: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, source).unwrap();
    path
}

fn load(name: &str, source: &str) -> Scenario {
    Scenario::load(&file(name, source)).unwrap_or_else(|error| panic!("{error}"))
}

/// I1 to Q1.
const HEAD: &str = "about = \"Q1 follows I1.\"\ntext = \"0\\n827301\\n877901\\n\"\n";

#[test]
fn what_is_wrong_is_told_with_file_line_and_remedy() {
    #[rustfmt::skip]
    let cases = [
        // (after the head, the line, the message)
        ("[[step]]\nat = 0\nexpect = { Q5 = 1 }", 5, "Q5 is not an output of the board; it has Q1 to Q4"),
        ("[[step]]\nat = 0\nexpect = { I1 = 1 }", 5, "I1 is not an output of the board; it has Q1 to Q4"),
        ("[[step]]\nat = 0\nset = { I0 = 1 }", 5, "I0 is not an input of the board; it has I1 to I4"),
        ("[[step]]\nat = 0\nset = { I01 = 1 }", 5, "I01 is not an input of the board; it has I1 to I4"),
        ("[[step]]\nat = 0\n[step.set]\nI1 = 1\nI5 = 0", 7, "I5 is not an input of the board; it has I1 to I4"),
        ("[[step]]\nat = 0\nset = { I1 = 2 }", 5, "I1 must be 0 or 1"),
        ("[[step]]\nat = 0\nset = { I1 = \"any\" }", 5, "I1 must be 0 or 1"),
        ("[[step]]\nat = 0\nexpect = { Q1 = true }", 5, "Q1 must be 0, 1 or \"any\""),
        ("[[step]]\nat = 0\nexpect = { Q1 = \"all\" }", 5, "Q1 must be 0, 1 or \"any\""),
        ("[[step]]\nat = 5\n[[step]]\nat = 4", 6, "the step at 4 ms does not come after the one at 5 ms; put steps in rising order"),
        ("[[step]]\nat = 5\n[[step]]\nat = 5", 6, "the step at 5 ms does not come after the one at 5 ms; put steps in rising order"),
        ("scan_ms = 7\n[[step]]\nat = 15", 5, "no scan runs at 15 ms; scans run every 7 ms (`scan_ms`)"),
        ("scan_ms = 0\n[[step]]\nat = 0", 3, "`scan_ms` must be 1 or more"),
        ("until = 4\n[[step]]\nat = 5", 3, "`until` comes before the last step, at 5 ms"),
        ("[[step]]\nat = 5\nuntil = 9", 5, "unknown field `until`, expected one of `at`, `set`, `expect`; keys of the whole file stand above the first [[step]]"),
        ("speed = 3", 3, "unknown field `speed`, expected one of `about`, `program`, `text`, `start_ms`, `scan_ms`, `until`, `fault`, `step`"),
        ("program = \"x.txt\"\n[[step]]\nat = 0", 2, "`program` and `text` both give a program; keep one of them"),
        ("fault = { number = 24 }\nuntil = 5", 3, "a program with a `fault` never runs; remove `fault`, or the steps and `until`"),
        ("fault = { number = 24 }\n[[step]]\nat = 0", 3, "a program with a `fault` never runs; remove `fault`, or the steps and `until`"),
        ("fault = { number = 99 }", 3, "there is no fault 99; docs/numeric-code.md lists them"),
        ("fault = { number = 24, line = 0 }", 3, "lines count from 1; leave `line` out where the fault has none"),
        ("fault = { number = 24, code = 1 }", 3, "unknown field `code`, expected `number` or `line`"),
        ("[[step]]\nat = -1", 4, "invalid value: integer `-1`, expected u32"),
        ("[[step]]\nset = { I1 = 1 }", 3, "missing field `at`"),
        ("about = \"again\"", 3, "duplicate key"),
    ];
    for (index, (source, line, message)) in cases.into_iter().enumerate() {
        let path = file(&format!("wrong-{index}.toml"), &format!("{HEAD}{source}\n"));
        let told = match Scenario::load(&path) {
            Ok(_) => panic!("accepted: {source}"),
            Err(error) => error.to_string(),
        };
        assert_eq!(
            told,
            format!("{}:{line}: {message}", path.display()),
            "{source}"
        );
    }
}

#[test]
fn what_is_wrong_with_the_whole_file_is_told_without_a_line() {
    #[rustfmt::skip]
    let cases = [
        ("about = \"\"\n[[step]]\nat = 0", "no program; name its file with `program`, or write it as `text`"),
        (HEAD, "nothing happens; write a [[step]], or the `fault` that is expected"),
    ];
    for (index, (source, message)) in cases.into_iter().enumerate() {
        let path = file(&format!("whole-{index}.toml"), source);
        let told = Scenario::load(&path).map(|_| ()).unwrap_err().to_string();
        assert_eq!(told, format!("{}: {message}", path.display()));
    }
}

#[test]
fn files_that_are_missing_are_named() {
    let missing = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("no-such.toml");
    let told = Scenario::load(&missing)
        .map(|_| ())
        .unwrap_err()
        .to_string();
    let start = format!("{}: the file cannot be read: ", missing.display());
    assert!(told.starts_with(&start), "{told}");

    let path = file(
        "no-program.toml",
        "about = \"\"\nprogram = \"no-such.txt\"\n",
    );
    let told = Scenario::load(&path).map(|_| ()).unwrap_err().to_string();
    let program = path.with_file_name("no-such.txt");
    let start = format!(
        "{}:2: the program {} cannot be read: ",
        path.display(),
        program.display()
    );
    assert!(told.starts_with(&start), "{told}");
}

#[test]
fn the_program_is_named_relative_to_the_scenario() {
    file("follow.txt", "0\n827301\n877901\n");
    let source = "about = \"\"\nprogram = \"follow.txt\"\nuntil = 3\n";
    let scenario = load("relative.toml", source);
    assert_eq!(scenario.program().bytes, b"0\n827301\n877901\n");
    assert_eq!(scenario.about(), "");
    assert_eq!(scenario.expected_refusal(), None);
}

#[test]
fn an_expectation_is_in_force_until_its_point_is_named_again() {
    let steps = "until = 30\n\
        [[step]]\nat = 0\nexpect = { Q1 = 0, Q2 = 0 }\n\
        [[step]]\nat = 10\nset = { I1 = 1 }\nexpect = { Q1 = 1 }\n\
        [[step]]\nat = 20\nset = { I1 = 0 }\nexpect = { Q1 = \"any\" }\n";
    let scenario = load("in-force.toml", &format!("{HEAD}{steps}"));
    let report = check(&scenario, &mut HostEngine::default());
    // Q1 in the scans 0 to 19, Q2 in all of 0 to 30.
    assert_eq!(
        report.verdict,
        Verdict::Met {
            comparisons: 20 + 31
        }
    );
    let times: Vec<_> = report.changes.iter().map(|change| change.at).collect();
    assert_eq!(times, [0, 10, 20]);
}

#[test]
fn scans_run_every_scan_ms_up_to_until() {
    let source =
        format!("{HEAD}scan_ms = 7\nuntil = 30\n[[step]]\nat = 7\nexpect = {{ Q1 = 0 }}\n");
    let report = check(&load("period.toml", &source), &mut HostEngine::default());
    // At 7, 14, 21 and 28 ms.
    assert_eq!(report.verdict, Verdict::Met { comparisons: 4 });
}

#[test]
fn a_fault_is_expected_with_or_without_a_line() {
    for (line, expected) in [("", None), (", line = 3", Some(3))] {
        let source = format!("{HEAD}fault = {{ number = 24{line} }}\n");
        let scenario = load("fault.toml", &source);
        let refusal = Refusal {
            number: 24,
            line: expected,
        };
        assert_eq!(scenario.expected_refusal(), Some(refusal));
    }
}
