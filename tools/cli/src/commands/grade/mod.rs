//! `unoclp grade`: how the programs of a class do in an exercise.
//!
//! - `files`: which programs those are
//! - `row`: what came of one
//! - `shared`: many at a time
//! - `table`, `sheet`, `page`: the rows for a terminal, for a spreadsheet, and with diagrams for a browser
//!
//! Whatever is wrong with a program is a row. Only what is wrong with the arguments ends the command.

mod files;
mod page;
mod row;
mod shared;
mod sheet;
mod table;

use super::open::unreadable;
use super::output::{Kind, Over, may_write, write};
use super::plant::machine;
use super::wording::Wording;
use crate::messages;
use crate::outcome::Outcome;
use anstream::{eprintln, print, println};
use anyhow::anyhow;
use clap::Args;
use row::Row;
use std::path::{Path, PathBuf};
use unoclp_exercise::scenario::{Exercise, ProgramFile};
use unoclp_program::{WrittenIn, shown};

/// What is graded, and how that is told.
#[derive(Args)]
pub struct Class {
    /// The exercise: a scenario file with cases (.toml)
    exercise: PathBuf,
    /// The programs, in any of the languages; of a folder all below it
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Print a table for a spreadsheet: comma-separated values
    #[arg(long)]
    csv: bool,
    /// Write a page with the first failing case of each program as a timing diagram
    #[arg(long, value_name = "OUT.html")]
    html: Option<PathBuf>,
    #[command(flatten)]
    over: Over,
    #[command(flatten)]
    wording: Wording,
}

/// Grades the programs of a class.
pub fn grade(class: &Class) -> Outcome {
    let exercise = Exercise::load(&class.exercise, class.wording.board);
    let exercise = exercise.map_err(|error| anyhow!(error.text(messages::spoken())))?;
    let plant = match &exercise.plant {
        Some(path) => match machine(path, class.wording.board)? {
            Some(plant) => Some(plant),
            None => return Ok(false),
        },
        None => None,
    };
    let found = files::find(&class.files)?;
    let inputs = found.programs.iter().map(PathBuf::as_path);
    let inputs: Vec<&Path> = inputs.chain([class.exercise.as_path()]).collect();
    if let Some(html) = &class.html {
        // Told at once, and not after a class has been graded.
        may_write(html, Kind::Page, &inputs, class.over)?;
    }
    let row = |path: &PathBuf| match ProgramFile::read(path) {
        Ok(ProgramFile { name, bytes }) => {
            Row::of(class.wording.of(name, bytes), &exercise, plant.as_ref())
        }
        Err(why) => Row::unreadable(path, unreadable(&shown(path), &why)),
    };
    let unreadable = found.unreadable.into_iter();
    let unreadable = unreadable.map(|(path, why)| Row::unreadable(&path, why));
    let mut rows = shared::map(&found.programs, row);
    rows.extend(unreadable);
    match class.csv {
        true => print!("{}", sheet::csv(&rows, &exercise)?),
        false => println!("{}", table::table(&rows, &exercise)),
    }
    if !found.left_out.is_empty() {
        let names = found.left_out.iter().map(|path| shown(path));
        let names = names.collect::<Vec<_>>().join(", ");
        let ends = WrittenIn::ends(messages::spoken());
        eprintln!("{}", messages::left_out(ends, names));
    }
    if let Some(html) = &class.html {
        let page = page::html(&rows, &exercise).into_bytes();
        write(html, page, Kind::Page, &inputs, class.over)?;
        eprintln!("{}", messages::written(shown(html)));
    }
    Ok(rows.iter().all(Row::is_passed))
}
