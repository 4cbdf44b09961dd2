//! The rows for a terminal.

use super::course::Course;
use super::row::Row;
use crate::{ascii, messages};
use unoclp_program::harmless;

/// A reason is cut after so many characters.
const MOST_WHY: usize = 400;

/// A line for each program, and how many passed each exercise.
pub fn table(rows: &[Row<'_>], course: &Course) -> String {
    let tasks = &course.tasks;
    let columns = Columns {
        exercise: course.only().is_none(),
        machine: tasks.iter().any(|task| task.plant.is_some()),
        // Where a fault is to be found, there is no case.
        cases: tasks.iter().any(|task| task.exercise.find.is_none()),
    };
    let mut lines = vec![columns.line([
        match rows.iter().any(|row| row.student.is_some()) {
            true => messages::grade_name(),
            false => messages::grade_file(),
        },
        messages::grade_exercise(),
        match columns.cases {
            true => messages::grade_cases(),
            false => messages::grade_tries(),
        },
        messages::grade_machine(),
        messages::grade_failing(),
    ])];
    lines.extend(rows.iter().map(|row| columns.line(cells(row))));
    let widths: Vec<usize> = (0..lines[0].len())
        .map(|column| {
            let widths = lines.iter().map(|line| line[column].chars().count());
            widths.max().unwrap_or_default()
        })
        .collect();
    let mut text = String::new();
    for line in &lines {
        for (cell, width) in line.iter().zip(&widths) {
            text += &format!("{cell:width$}  ");
        }
        text.truncate(text.trim_end().len());
        text += "\n";
    }
    let passed = tasks.iter().filter_map(|task| {
        let own = rows.iter().filter(|row| row.is_of(task));
        let count = own.clone().count();
        let title = harmless(task.exercise.title.text(messages::spoken()));
        let passed = own.filter(|row| row.is_passed()).count();
        (count > 0).then(|| messages::programs_passed(title, passed, count))
    });
    text += &passed.collect::<Vec<_>>().join("\n");
    ascii::picture(&text)
}

/// Which columns there are, besides who it is.
struct Columns {
    exercise: bool,
    machine: bool,
    cases: bool,
}

impl Columns {
    /// The cells of a line that are shown.
    fn line(&self, cells: [String; 5]) -> Vec<String> {
        let shown = [true, self.exercise, true, self.machine, self.cases];
        let cells = cells.into_iter().zip(shown);
        cells.filter_map(|(cell, is)| is.then_some(cell)).collect()
    }
}

fn cells(row: &Row<'_>) -> [String; 5] {
    let why = match &row.fail {
        None if row.tries.is_some() => String::new(),
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
    let machine = match (&row.machine, row.task) {
        (Some(why), _) => harmless(why),
        (None, Some(task)) if task.plant.is_some() => messages::passed(),
        (None, _) => String::new(),
    };
    let title = row
        .task
        .map(|task| task.exercise.title.text(messages::spoken()));
    [
        harmless(row.who()),
        harmless(title.unwrap_or_default()),
        match (row.tries, row.task) {
            (Some(tries), _) => tries.to_string(),
            (None, Some(_)) => format!("{}/{}", row.passed, row.cases()),
            (None, None) => String::new(),
        },
        machine,
        why,
    ]
}
