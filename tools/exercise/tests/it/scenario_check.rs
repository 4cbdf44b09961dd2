//! The check of a scenario, with engines that do as they are told.

use std::fs;
use std::path::PathBuf;
use unoclp_core::{Image, Inputs, Millis};
use unoclp_exercise::scenario::{Report, Scenario, check};
use unoclp_host_sim::engine::{Cell, Engine, HostEngine, Outcome, Refusal};

/// An engine whose outputs depend on the scan's number alone, and which notes what it is given.
struct Scripted<F> {
    loads: Result<(), Refusal>,
    output: F,
    scans: Vec<(Image, Millis)>,
}

impl<F: Fn(usize) -> Result<Image, &'static str>> Engine for Scripted<F> {
    type Error = &'static str;

    fn load(&mut self, _: &[u8]) -> Result<Result<(), Refusal>, &'static str> {
        Ok(self.loads)
    }

    fn scan(&mut self, inputs: &Inputs, now: Millis) -> Result<Outcome, &'static str> {
        self.scans.push((inputs.points, now));
        (self.output)(self.scans.len() - 1).map(Ok)
    }

    fn restart(&mut self) -> Result<(), &'static str> {
        Err("it has no switch")
    }

    fn look(&mut self, _: Cell) -> Result<i32, &'static str> {
        Err("it has no memory")
    }

    fn poke(&mut self, _: Cell, _: i32) -> Result<(), &'static str> {
        Err("it has no memory")
    }

    fn pwm(&mut self, _: u8) -> Result<u8, &'static str> {
        Err("it has no PWM")
    }
}

fn scripted<F: Fn(usize) -> Result<Image, &'static str>>(output: F) -> Scripted<F> {
    Scripted {
        loads: Ok(()),
        output,
        scans: Vec::new(),
    }
}

fn scenario(name: &str, source: &str) -> Scenario {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(
        &path,
        format!("about = \"Shown.\"\ntext = \"0\\n\"\n{source}"),
    )
    .unwrap();
    Scenario::load(&path, unoclp_core::Board::UNO).unwrap_or_else(|error| panic!("{error}"))
}

/// The report from its verdict on.
fn verdict(report: &Report) -> String {
    assert_eq!(
        report.passed(),
        report.verdict.to_string().starts_with("PASS")
    );
    report.verdict.to_string()
}

const REFUSED: Refusal = Refusal {
    number: 24,
    line: Some(7),
};

#[test]
fn the_engine_sees_inputs_and_time_stamps_across_the_wrap() {
    let source = "start_ms = 4294967293\nscan_ms = 2\n\
        [[step]]\nat = 0\nset = { I1 = 1 }\n\
        [[step]]\nat = 4\nset = { I1 = 0, I4 = 1 }\n\
        [[step]]\nat = 6\nset = { I2 = 1 }\n";
    let mut engine = scripted(|_| Ok(Image(0)));
    let report = check(&scenario("stamps.toml", source), &mut engine);
    let seen = [
        (0b1, 4294967293),
        (0b1, 4294967295),
        (0b1000, 1),
        (0b1010, 3),
    ];
    assert_eq!(engine.scans, seen.map(|(inputs, now)| (Image(inputs), now)));
    assert_eq!(
        verdict(&report),
        "PASS: the program ran; nothing was expected"
    );
}

#[test]
fn the_report_is_the_timeline_and_the_verdict() {
    let source = "until = 12\n\
        [[step]]\nat = 2\nset = { I2 = 1 }\nexpect = { Q1 = 1, Q4 = 0 }\n\
        [[step]]\nat = 8\nexpect = { Q1 = 0 }\n";
    // Q1 comes a scan late and stays; Q3 is nobody's business; Q4 blinks once.
    let outputs = |scan| match scan {
        0..=2 => Ok(Image(0)),
        5 => Ok(Image(0b1101)),
        _ => Ok(Image(0b0101)),
    };
    let scenario = scenario("report.toml", source);
    let report = check(&scenario, &mut scripted(outputs));
    let expected = format!(
        "\
{}: Shown.
program: {0} (text)

        ms  I1  I2  I3  I4    Q1  Q2  Q3  Q4    1 = closed, on; · = open, off
         0   ·   ·   ·   ·     ·   ·   ·   ·
         2   ·   1   ·   ·     ·   ·   ·   ·
         3   ·   1   ·   ·     1   ·   1   ·
         5   ·   1   ·   ·     1   ·   1   1
         6   ·   1   ·   ·     1   ·   1   ·

FAIL
  Q1 at 2 ms: expected 1, got 0
  Q4 at 5 ms: expected 0, got 1
  Q1 at 8 ms: expected 0, got 1 (until 12 ms)",
        scenario.name()
    );
    assert_eq!(report.to_string(), expected);
}

#[test]
fn of_many_failures_the_first_are_shown() {
    let source = "until = 39\n[[step]]\nat = 0\nexpect = { Q1 = 0 }\n";
    let report = check(
        &scenario("many.toml", source),
        &mut scripted(|scan| Ok(Image((scan % 2) as u128))),
    );
    let told = verdict(&report);
    assert_eq!(told.lines().count(), 10, "{told}");
    assert!(told.ends_with("\n  … and 12 more"), "{told}");
}

#[test]
fn an_engine_that_fails_is_told_with_the_moment() {
    let source = "until = 9\n[[step]]\nat = 0\nexpect = { Q1 = 0 }\n";
    let hangs = |scan| {
        if scan < 4 {
            Ok(Image(0))
        } else {
            Err("the chip hangs")
        }
    };
    let report = check(&scenario("hangs.toml", source), &mut scripted(hangs));
    assert_eq!(verdict(&report), "FAIL\n  at 4 ms: the chip hangs");
}

#[test]
fn refusals_are_compared() {
    let fault = "fault = { number = 24, line = 7 }\n";
    let runs = "[[step]]\nat = 0\nexpect = { Q1 = 0 }\n";
    let other_line = Refusal {
        line: Some(8),
        ..REFUSED
    };
    #[rustfmt::skip]
    let cases = [
        (fault, Err(REFUSED), "PASS: refused as expected: fault 24, line 7: no such code"),
        (fault, Err(other_line), "FAIL\n  expected fault 24, line 7: no such code\n  got      fault 24, line 8: no such code"),
        (fault, Ok(()), "FAIL\n  expected fault 24, line 7: no such code\n  but the program was accepted"),
        (runs, Err(REFUSED), "FAIL\n  expected the program to run\n  got      fault 24, line 7: no such code"),
        (runs, Ok(()), "PASS"),
    ];
    for (source, loads, expected) in cases {
        let mut engine = scripted(|_| Ok(Image(0)));
        engine.loads = loads;
        let report = check(&scenario("refusals.toml", source), &mut engine);
        assert_eq!(verdict(&report), expected);
        assert_eq!(
            engine.scans.len(),
            usize::from(loads.is_ok() && source == runs)
        );
    }
}

#[test]
fn an_engine_starts_anew_with_each_load() {
    let mut engine = HostEngine::new(unoclp_core::Board::UNO);
    // A timer that is done, and an output that is set.
    let program = b"0\n827301\n847978\n5\n7901\n83877902\n";
    for _ in 0..2 {
        assert_eq!(engine.load(program), Ok(Ok(())));
        assert_eq!(engine.scan(&Image(1).into(), 0), Ok(Ok(Image(0))));
        assert_eq!(engine.scan(&Image(1).into(), 5), Ok(Ok(Image(0b11))));
    }
    // A refused program leaves nothing that could run.
    let refusal = Refusal {
        number: 22,
        line: Some(1),
    };
    assert_eq!(engine.load(b"827301"), Ok(Err(refusal)));
    assert_eq!(engine.scan(&Image(1).into(), 6), Ok(Ok(Image(0))));
}
