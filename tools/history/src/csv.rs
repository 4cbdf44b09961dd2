//! Rows for a spreadsheet.

use crate::query::Row;
use std::fmt::Write;
use unoclp_journal::moment;

/// `time,least,most,last`, the time in UTC; an empty value is that of a board that was away.
pub fn csv(rows: &[Row]) -> String {
    let mut text = "time,least,most,last\n".to_owned();
    for row in rows {
        let value = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
        let [least, most, last] = [row.least, row.most, row.last].map(value);
        // To a string nothing fails.
        let _ = writeln!(text, "{},{least},{most},{last}", moment(row.at));
    }
    text
}
