//! How long it takes to grade a class: 200 programs in an exercise of 20 cases, compiled and run as `unoclp grade` does.
//!
//! `cargo run --release -p unoclp-exercise --example class` prints the time, of which the target is 10 s.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::Instant;
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
    let exercise = Exercise::of_text(
        "class.toml",
        &format!("{head}{cases}"),
        unoclp_core::Board::UNO,
    )?;
    let programs = [read("17-traffic.il")?, read("wrong/17-traffic.il")?];

    let begin = Instant::now();
    let mut passed = 0;
    for text in programs.iter().cycle().take(PROGRAMS) {
        let written = Written::new(
            "17-traffic.il".to_owned(),
            text.clone().into_bytes(),
            unoclp_core::Board::UNO,
        );
        let source = written.check(None).map_err(|_| "it has errors")?;
        let program = ProgramFile {
            name: source.name,
            bytes: source.code,
        };
        let grade = grade(
            &exercise,
            &program,
            &mut HostEngine::new(unoclp_core::Board::UNO),
        );
        passed += usize::from(grade.is_passed());
    }
    let time = begin.elapsed();
    println!("{PROGRAMS} programs × {CASES} cases: {time:.2?}; {passed} passed");
    Ok(())
}
