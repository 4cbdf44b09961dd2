//! `unoclp grade`: how the programs of a class do in an exercise, or in several.
//!
//! - `course`: the exercises
//! - `files`: which programs those are
//! - `handin`: what a student has handed in from the page
//! - `row`: the result of one
//! - `school`: whose it is
//! - `shared`: many at a time
//! - `table`, `sheet`, `page`: the rows for a terminal, for a spreadsheet, and with diagrams for a browser
//!
//! Whatever is wrong with a program is a row. Only what is wrong with the arguments ends the command.

mod course;
mod files;
mod handin;
mod page;
mod row;
mod school;
mod shared;
mod sheet;
mod table;

use super::open::unreadable;
use super::output::{Kind, Over, may_write, write};
use super::wording::Wording;
use crate::messages;
use crate::outcome::Outcome;
use anstream::{eprintln, print, println};
use clap::Args;
use course::Course;
use row::Row;
use std::path::{Path, PathBuf};
use unoclp_exercise::scenario::ProgramFile;
use unoclp_program::{WrittenIn, harmless_lines, shown};

/// What is graded, and how that is told.
#[derive(Args)]
pub struct Class {
    /// The exercise: a scenario file with cases (.toml), or a folder of them
    exercise: PathBuf,
    /// The programs, in any of the languages, and hand-ins, or folders that contain them
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Print a table for a spreadsheet: comma-separated values
    #[arg(long)]
    csv: bool,
    /// Print grades from 0 to 100 for import into Moodle: a line for each student
    #[arg(long, conflicts_with = "csv")]
    moodle: bool,
    /// Write a page with each program as a ladder, and its first failing case as a timing diagram
    #[arg(long, value_name = "OUT.html")]
    html: Option<PathBuf>,
    #[command(flatten)]
    over: Over,
    #[command(flatten)]
    wording: Wording,
}

/// Grades the programs of a class.
pub fn grade(class: &Class) -> Outcome {
    let wording = &class.wording;
    let Some(course) = Course::load(&class.exercise, wording.board())? else {
        return Ok(false);
    };
    let found = files::find(&class.files)?;
    let inputs = found.programs.iter().map(PathBuf::as_path);
    let inputs: Vec<&Path> = inputs.chain([class.exercise.as_path()]).collect();
    if let Some(html) = &class.html {
        // Told at once, and not after a class has been graded.
        may_write(html, Kind::Page, &inputs, class.over)?;
    }
    let row = |path: &PathBuf| match handin::is_hand_in(path) {
        true => Row::of_hand_in(path, wording, &course),
        false => match ProgramFile::read(path) {
            Ok(file) => Row::of_program(file, wording, &course),
            Err(why) => Row::unreadable(path, unreadable(&shown(path), &why)),
        },
    };
    let unreadable = found.unreadable.into_iter();
    let unreadable = unreadable.map(|(path, why)| Row::unreadable(&path, why));
    let mut rows = shared::map(&found.programs, row);
    rows.extend(unreadable);
    for row in &mut rows {
        // What cannot be graded counts where there is no doubt in which exercise.
        row.task = row.task.or(course.only());
    }
    match (class.csv, class.moodle) {
        (true, _) => print!("{}", sheet::csv(&rows, &course)?),
        (_, true) => print!("{}", sheet::moodle(&rows, &course)?),
        _ => println!("{}", table::table(&rows, &course)),
    }
    for mistake in &course.mistakes {
        eprintln!("{}", harmless_lines(mistake));
    }
    for row in rows.iter().filter(|row| row.is_boast()) {
        eprintln!("{}", messages::says_passed(&row.file));
    }
    if !found.left_out.is_empty() {
        let names = found.left_out.iter().map(|path| shown(path));
        let names = names.collect::<Vec<_>>().join(", ");
        let ends = WrittenIn::ends(messages::spoken());
        eprintln!("{}", messages::left_out(ends, names));
    }
    if let Some(html) = &class.html {
        let page = page::html(&rows, &course).into_bytes();
        write(html, page, Kind::Page, &inputs, class.over)?;
        eprintln!("{}", messages::written(shown(html)));
    }
    Ok(rows.iter().all(Row::is_passed))
}
