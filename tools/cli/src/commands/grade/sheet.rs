//! The rows for a spreadsheet: comma-separated values (RFC 4180).

use super::row::Row;
use unoclp_exercise::scenario::Exercise;
use unoclp_program::harmless;

/// The columns, in both languages: what reads them knows them by these names.
const COLUMNS: [&str; 7] = [
    "file",
    "exercise",
    "passed",
    "cases passed",
    "cases",
    "first failing case",
    "machine",
];

/// A line for each program, below the names of the columns.
///
/// # Errors
/// Those of the writer, which has none in memory.
pub fn csv(rows: &[Row], exercise: &Exercise) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // The last one is that of the machine, where there is one.
    let count = COLUMNS.len() - usize::from(exercise.plant.is_none());
    writer.write_record(COLUMNS.iter().take(count))?;
    for row in rows {
        let (passed, of) = (row.passed.to_string(), exercise.cases().len().to_string());
        let cells = [
            cell(&row.file),
            cell(&exercise.name),
            if row.is_passed() { "yes" } else { "no" }.to_owned(),
            row.tries.map_or(passed, |tries| tries.to_string()),
            of,
            cell(row.fail.as_ref().map_or("", |fail| fail.case.as_str())),
            cell(row.machine.as_deref().unwrap_or_default()),
        ];
        writer.write_record(cells.into_iter().take(count))?;
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
