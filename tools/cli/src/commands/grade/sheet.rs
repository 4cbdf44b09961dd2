//! The rows for a spreadsheet: comma-separated values (RFC 4180).

use super::row::Row;
use unoclp_exercise::scenario::Exercise;
use unoclp_program::harmless;

/// The columns, in both languages: what reads them knows them by these names.
const COLUMNS: [&str; 6] = [
    "file",
    "exercise",
    "passed",
    "cases passed",
    "cases",
    "first failing case",
];

/// A line for each program, below the names of the columns.
///
/// # Errors
/// Those of the writer, which has none in memory.
pub fn csv(rows: &[Row], exercise: &Exercise) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS)?;
    for row in rows {
        writer.write_record([
            cell(&row.file).as_str(),
            &cell(&exercise.name),
            if row.is_passed() { "yes" } else { "no" },
            &row.passed.to_string(),
            &exercise.cases().len().to_string(),
            &cell(row.fail.as_ref().map_or("", |fail| fail.case.as_str())),
        ])?;
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
