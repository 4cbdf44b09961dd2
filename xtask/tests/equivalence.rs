//! The firmware before and after its assembly was shortened: each function that was changed runs in both
//! versions with random registers, flags and memory, and does the same. It needs what `cargo xtask firmware`
//! leaves: `cargo xtask test` runs it.

use std::collections::BTreeMap;
use std::fs;

use avr_shorten::assembly::{Line, Unit};
use avr_shorten::equivalence::Pair;
use avr_shorten::machine::Program;
use unoclp_boot::Model;
use xtask::{firmware, link};

/// How often each function runs.
const RUNS: u64 = 1_000;
/// How often it does where a mistake is put in.
const FEW: u64 = 100;
/// The least share of the instructions that must have run, in per cent.
const LEAST: usize = 80;
/// The least share of the mistakes that must be found, in per cent.
const FOUND: usize = 90;

fn units(board: Model) -> (Unit, Unit) {
    let elf = firmware::shortened(board);
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
    let shortened = firmware::BOARDS.into_iter();
    shortened
        .filter(|&board| firmware::is_shortened(board))
        .for_each(does_the_same);
}

fn does_the_same(board: Model) {
    let (before, after) = units(board);
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
        run += some;
        all += of;
    }
    println!(
        "{} functions: {alike} runs alike, {void} without meaning; {run} of {all} instructions run",
        changed.len()
    );
    assert!(failed.is_empty(), "{}", failed.join("\n"));
    assert!(100 * run >= LEAST * all, "too little of the code was run");
}

/// The runs must find a mistake: in each function one instruction is left out after the pass.
#[test]
fn an_instruction_that_is_lost_is_found() {
    let (before, after) = units(Model::Uno);
    let (mut found, mut lost) = (0, 0);
    for (n, name) in changed(&before, &after).iter().enumerate() {
        let mut wrong = after.clone();
        let function = wrong
            .functions_mut()
            .find(|function| function.name == *name);
        let body = &mut function.expect("no function is lost").body;
        let codes = (0..body.len()).filter(|&line| matches!(body.get(line), Some(Line::Code(_))));
        // Among the first ones, which most runs come to.
        let codes: Vec<usize> = codes.take(8).collect();
        let Some(&line) = codes.get(n % codes.len().max(1)) else {
            continue;
        };
        body.remove(line);
        lost += 1;
        let mut pair = Pair::new(program(&before), program(&wrong));
        found += usize::from(pair.explore(name, FEW).is_err());
    }
    println!("{found} of {lost} lost instructions found");
    assert!(100 * found >= FOUND * lost, "the runs see too little");
}
