//! The rows for a terminal.

use super::row::Row;
use crate::{ascii, messages};
use unoclp_exercise::scenario::Exercise;
use unoclp_program::harmless;

/// A reason is cut after so many characters.
const MOST_WHY: usize = 400;

/// A line for each program, and how many passed.
pub fn table(rows: &[Row], exercise: &Exercise) -> String {
    let count = exercise.cases().len();
    let mut lines = vec![[
        messages::grade_file(),
        match exercise.find {
            Some(_) => messages::grade_tries(),
            None => messages::grade_cases(),
        },
        messages::grade_machine(),
        messages::grade_failing(),
    ]];
    lines.extend(rows.iter().map(|row| {
        let why = match &row.fail {
            None => messages::passed(),
            // What a student's text is quoted with is to stay on its line too.
            Some(fail) => {
                let why = format!("{}: {}", fail.case, fail.why);
                match why.char_indices().nth(MOST_WHY) {
                    Some((end, _)) => harmless(&why[..end]) + "…",
                    None => harmless(&why),
                }
            }
        };
        let machine = row
            .machine
            .as_deref()
            .map_or_else(messages::passed, harmless);
        [
            row.file.clone(),
            match row.tries {
                Some(tries) => tries.to_string(),
                None => format!("{}/{count}", row.passed),
            },
            machine,
            why,
        ]
    }));
    let width = |column: usize| {
        let widths = lines.iter().map(|line| line[column].chars().count());
        widths.max().unwrap_or_default()
    };
    let (files, cases, machines) = (width(0), width(1), width(2));
    let mut text = String::new();
    for [file, passed, machine, why] in &lines {
        text += &format!("{file:files$}  {passed:cases$}");
        if exercise.plant.is_some() {
            text += &format!("  {machine:machines$}");
        }
        // Where a fault is to be found, there is no case.
        if exercise.find.is_none() {
            text += &format!("  {why}");
        }
        text.truncate(text.trim_end().len());
        text += "\n";
    }
    let title = exercise.title.text(messages::spoken());
    let passed = rows.iter().filter(|row| row.is_passed()).count();
    text += &messages::programs_passed(harmless(title), passed, rows.len());
    ascii::picture(&text)
}
