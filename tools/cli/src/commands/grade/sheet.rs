//! The rows for a spreadsheet: comma-separated values (RFC 4180).

use super::row::Row;
use unoclp_host_sim::scenario::Exercise;

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
            row.file.as_str(),
            exercise.name.as_str(),
            if row.is_passed() { "yes" } else { "no" },
            &row.passed.to_string(),
            &exercise.cases().len().to_string(),
            row.fail.as_ref().map_or("", |fail| fail.case.as_str()),
        ])?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}
