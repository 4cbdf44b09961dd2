//! How long it takes to grade a class: 200 programs in an exercise of 20 cases and a machine, compiled and run as
//! `unoclp grade` does, one after the other.
//!
//! `cargo run --release -p unoclp-exercise --example class` prints the times, of which the target is 20 s in all; with
//! `--json` it says so in a form that `cargo xtask bench` writes into a page.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};
use unoclp_core::Board;
use unoclp_exercise::machine::first_wrong;
use unoclp_exercise::scenario::{Exercise, ProgramFile, grade};
use unoclp_host_sim::engine::HostEngine;
use unoclp_program::Written;

const PROGRAMS: usize = 200;
const CASES: usize = 20;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/exercises");
    let read = |name: &str| fs::read_to_string(folder.join(name));
    // The longest exercise, with its cases over and over.
    let text = read("17-traffic.toml")?;
    let (head, cases) = text.split_once("[[case]]").ok_or("it has no case")?;
    let cases: Vec<&str> = cases.split("[[case]]").collect();
    let cases = cases.iter().cycle().take(CASES);
    let cases: String = cases.map(|case| format!("[[case]]{case}\n")).collect();
    let exercise = Exercise::of_text("class.toml", &format!("{head}{cases}"), Board::UNO)?;
    let plant = unoclp_plant::read(&read("machines/17-traffic.toml")?, Board::UNO)
        .map_err(|_| "its machine has mistakes")?;
    let programs = [read("17-traffic.il")?, read("wrong/17-traffic.il")?];

    let (mut passed, mut in_cases, mut in_machine) = (0, Duration::ZERO, Duration::ZERO);
    for text in programs.iter().cycle().take(PROGRAMS) {
        let begin = Instant::now();
        let bytes = text.clone().into_bytes();
        let written = Written::new("17-traffic.il".to_owned(), bytes, Board::UNO);
        let source = written.check(None).map_err(|_| "it has errors")?;
        let program = ProgramFile {
            name: source.name,
            bytes: source.code,
        };
        let engine = &mut HostEngine::new(Board::UNO);
        let grade = grade(&exercise, &program, engine);
        in_cases += begin.elapsed();
        let begin = Instant::now();
        let first = first_wrong(&plant, plant.seed, &program.bytes, engine);
        in_machine += begin.elapsed();
        passed += usize::from(grade.is_passed() && first == Ok(None));
    }
    if std::env::args().any(|word| word == "--json") {
        let [cases, machine] = [in_cases, in_machine].map(|time| time.as_secs_f64());
        println!("{{\"cases\":{cases},\"machine\":{machine}}}");
        return Ok(());
    }
    println!(
        "{PROGRAMS} programs × {CASES} cases: {in_cases:.2?}; with a machine of {} s: {in_machine:.2?} more; {passed} passed",
        plant.until / 1000
    );
    Ok(())
}
