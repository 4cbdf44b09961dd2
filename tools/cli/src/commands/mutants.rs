//! `unoclp mutants`: which mistakes an exercise lets pass.

use super::open::unreadable;
use super::plant::{first_wrong, machine};
use super::wording::Wording;
use crate::outcome::Outcome;
use anstream::println;
use anyhow::{anyhow, bail};
use std::path::Path;
use unoclp_cli::messages;
use unoclp_exercise::mutants::{Slip, mutants};
use unoclp_exercise::scenario::{Exercise, ProgramFile, grade};
use unoclp_host_sim::engine::HostEngine;
use unoclp_program::{harmless, shown};

/// Makes wrong programs of the model solution, and says which of them the exercise lets pass.
pub fn find_mutants(path: &Path, wording: &Wording) -> Outcome {
    let board = wording.board;
    let exercise = Exercise::load(path, board);
    let exercise = exercise.map_err(|error| anyhow!(error.text(messages::spoken())))?;
    let plant = match &exercise.plant {
        Some(path) => match machine(path, board)? {
            Some(plant) => Some(plant),
            None => return Ok(false),
        },
        None => None,
    };
    let Some(file) = &exercise.program else {
        bail!(messages::no_model(shown(path)));
    };
    let program = ProgramFile::read(file).map_err(|why| anyhow!(unreadable(&shown(file), &why)))?;
    let written = wording.of(program.name, program.bytes);
    let Ok(source) = written.check(None) else {
        bail!(messages::model_faulty(shown(file)));
    };
    let all = mutants(&source.code, board);
    let mut passed = 0;
    for mutant in &all {
        let program = ProgramFile {
            name: "mutant".to_owned(),
            bytes: mutant.code.clone(),
        };
        let graded = grade(&exercise, &program, &mut HostEngine::new(board));
        let is_caught = !graded.is_passed()
            || plant
                .as_ref()
                .is_some_and(|plant| first_wrong(plant, &mutant.code, board).is_some());
        if is_caught {
            continue;
        }
        passed += 1;
        let plain = |text: &str| harmless(&text.split_whitespace().collect::<Vec<_>>().join(" "));
        let (was, is) = (plain(&mutant.was), plain(&mutant.is));
        println!("{}: {was} → {is}", slip(mutant.slip));
    }
    println!("{}", messages::mutants_passed(passed, all.len()));
    Ok(passed == 0)
}

/// A mistake in words.
fn slip(slip: Slip) -> String {
    match slip {
        Slip::Inverted => messages::slip_inverted(),
        Slip::Dropped => messages::slip_dropped(),
        Slip::Joined => messages::slip_joined(),
        Slip::Halved => messages::slip_halved(),
        Slip::Doubled => messages::slip_doubled(),
        Slip::Swapped => messages::slip_swapped(),
        Slip::NotReset => messages::slip_not_reset(),
    }
}
