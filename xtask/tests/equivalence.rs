//! The firmware before and after its assembly was shortened: each function that was changed runs in both
//! versions with random registers, flags and memory, and does the same. It needs what `cargo xtask firmware`
//! leaves: `cargo xtask test` runs it.

use std::collections::BTreeMap;
use std::fs;

use avr_shorten::assembly::{Line, Unit};
use avr_shorten::equivalence::Pair;
use avr_shorten::machine::Program;
use xtask::{firmware, link};

/// How often each function runs.
const RUNS: u64 = 1_000;

fn units() -> (Unit, Unit) {
    let elf = firmware::shortened();
    let read = |path| {
        let text = fs::read_to_string(&path);
        Unit::parse(&text.expect("`cargo xtask firmware` leaves its assembly"))
    };
    (read(link::compiled(&elf)), read(elf.with_extension("s")))
}

fn program(unit: &Unit) -> Program {
    Program::new(unit).unwrap_or_else(|error| panic!("{error}"))
}

/// The functions of `before` whose lines are others in `after`.
fn changed(before: &Unit, after: &Unit) -> Vec<String> {
    let shortened: BTreeMap<_, _> = after.functions().map(|f| (&f.name, &f.body)).collect();
    let lines = |body: &[Line]| -> Vec<Line> {
        let lines = body.iter().filter(|line| !matches!(line, Line::Other(_)));
        lines.cloned().collect()
    };
    let changed = before.functions().filter(|function| {
        let after = shortened.get(&function.name).expect("no function is lost");
        lines(&function.body) != lines(after)
    });
    changed.map(|function| function.name.clone()).collect()
}

#[test]
fn every_function_that_was_shortened_does_the_same() {
    let (before, after) = units();
    let changed = changed(&before, &after);
    let mut pair = Pair::new(program(&before), program(&after));
    let (mut alike, mut void, mut failed) = (0, 0, Vec::new());
    for function in &changed {
        match pair.explore(function, RUNS) {
            Ok(explored) => {
                alike += explored.alike;
                void += explored.void;
            }
            Err(difference) => failed.push(difference.to_string()),
        }
    }
    let (mut run, mut all) = (0, 0);
    for function in &changed {
        let (some, of) = pair.coverage(function);
        if some * 2 < of {
            println!("{function} {some} of {of}");
        }
        run += some;
        all += of;
    }
    println!(
        "{} functions: {alike} runs alike, {void} without meaning; {run} of {all} instructions run",
        changed.len()
    );
    assert!(failed.is_empty(), "{} {}", failed.len(), failed.join("\n"));
}
