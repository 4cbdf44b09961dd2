//! The rows for a terminal.

use super::row::Row;
use unoclp_cli::{ascii, messages};
use unoclp_host_sim::scenario::Exercise;

/// A line for each program, and how many passed.
pub fn table(rows: &[Row], exercise: &Exercise) -> String {
    let count = exercise.cases().len();
    let mut lines = vec![[
        messages::grade_file(),
        messages::grade_cases(),
        messages::grade_failing(),
    ]];
    lines.extend(rows.iter().map(|row| {
        let why = match &row.fail {
            None => messages::passed(),
            Some(fail) => format!("{}: {}", fail.case, fail.why),
        };
        [row.file.clone(), format!("{}/{count}", row.passed), why]
    }));
    let width = |column: usize| {
        let widths = lines.iter().map(|line| line[column].chars().count());
        widths.max().unwrap_or_default()
    };
    let (files, cases) = (width(0), width(1));
    let mut text = String::new();
    for [file, passed, why] in &lines {
        text += &format!("{file:files$}  {passed:cases$}  {why}\n");
    }
    let passed = rows.iter().filter(|row| row.is_passed()).count();
    text += &messages::programs_passed(exercise.title.text(messages::spoken()), passed, rows.len());
    ascii::picture(&text).into_owned()
}
