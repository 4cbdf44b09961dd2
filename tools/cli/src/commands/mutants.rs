//! `unoclp mutants`: which mistakes an exercise lets pass.

use super::open::unreadable;
use super::plant::machine;
use super::wording::Wording;
use crate::messages;
use crate::outcome::Outcome;
use anstream::println;
use anyhow::{anyhow, bail};
use std::path::Path;
use unoclp_exercise::mutants::{Slip, passing};
use unoclp_exercise::scenario::{Exercise, ProgramFile};
use unoclp_program::{harmless, shown};

/// Makes wrong programs of the model solution, and says which of them the exercise lets pass.
pub fn find_mutants(path: &Path, wording: &Wording) -> Outcome {
    let exercise = Exercise::load(path, wording.board());
    let exercise = exercise.map_err(|error| anyhow!(error.text(messages::spoken())))?;
    let board = exercise.board;
    let wording = &wording.on(board);
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
    let analysis = wording.workspace().open(written);
    let Some(source) = analysis.source() else {
        bail!(messages::model_faulty(shown(file)));
    };
    let found = passing(&exercise, plant.as_ref(), &source.code, board);
    for mutant in &found.pass {
        let [was, is] = mutant.lines().map(|line| harmless(&line));
        println!("{}: {was} → {is}", slip(mutant.slip));
    }
    let passed = found.pass.len();
    println!("{}", messages::mutants_passed(passed, found.of));
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
