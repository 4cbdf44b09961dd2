//! The rows for a spreadsheet: comma-separated values (RFC 4180).

use super::course::Course;
use super::row::Row;
use super::school;
use crate::messages;
use unoclp_program::harmless;

/// The columns, in both languages: what reads them knows them by these names.
const COLUMNS: [&str; 10] = [
    "file",
    "exercise",
    "passed",
    "cases passed",
    "cases",
    "first failing case",
    "machine",
    "name",
    "number",
    "minutes",
];

/// A line for each program, below the names of the columns.
///
/// # Errors
/// Those of the writer, which has none in memory.
pub fn csv(rows: &[Row<'_>], course: &Course) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let has_machine = course.tasks.iter().any(|task| task.plant.is_some());
    let has_names = rows.iter().any(|row| row.student.is_some());
    let is_shown = |column: usize| match column {
        6 => has_machine,
        7.. => has_names,
        _ => true,
    };
    let shown = |cells: [String; 10]| {
        let cells = cells.into_iter().enumerate();
        cells.filter_map(move |(column, cell)| is_shown(column).then_some(cell))
    };
    writer.write_record(shown(COLUMNS.map(str::to_owned)))?;
    for row in rows {
        let student = row.student.as_ref();
        let exercise = row.task.map(|task| task.exercise.name.as_str());
        let minutes = student.and_then(|it| it.minutes);
        let cells = [
            cell(&row.file),
            cell(exercise.unwrap_or_default()),
            if row.is_passed() { "yes" } else { "no" }.to_owned(),
            row.tries
                .map_or(row.passed.to_string(), |it| it.to_string()),
            row.cases().to_string(),
            cell(row.fail.as_ref().map_or("", |fail| fail.case.as_str())),
            cell(row.machine.as_deref().unwrap_or_default()),
            cell(student.map_or("", |it| &it.name)),
            cell(student.map_or("", |it| &it.number)),
            minutes.map_or(String::new(), |minutes| minutes.to_string()),
        ];
        writer.write_record(shown(cells))?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// A line for each student and a column for each exercise, in points of 100, for the import of grades of Moodle. Of several
/// that were handed in the best one counts.
///
/// # Errors
/// Those of the writer, which has none in memory.
pub fn moodle(rows: &[Row<'_>], course: &Course) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let is_done = |task: &&_| rows.iter().any(|row| row.is_of(task));
    let tasks: Vec<_> = course.tasks.iter().filter(is_done).collect();
    let titles = tasks.iter().map(|task| &task.exercise.title);
    let titles = titles.map(|title| cell(title.text(messages::spoken())));
    let heads = [
        messages::moodle_identifier(),
        messages::moodle_name(),
        messages::moodle_number(),
    ];
    writer.write_record(heads.into_iter().chain(titles))?;
    for (who, own) in school::students(rows) {
        let points = tasks.iter().map(|task| {
            let own = own.iter().filter(|row| row.is_of(task));
            let best = own.map(|row| row.points()).max();
            best.map_or(String::new(), |points| points.to_string())
        });
        let about = [&who.identifier, &who.name, &who.number].map(|text| cell(text));
        writer.write_record(about.into_iter().chain(points))?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// A text as a cell. A spreadsheet takes one that begins with one of these signs for a formula and runs it, so an
/// apostrophe comes before it (OWASP, "CSV Injection").
fn cell(text: &str) -> String {
    let text = harmless(text);
    match text.starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠']) {
        true => format!("'{text}"),
        false => text,
    }
}
