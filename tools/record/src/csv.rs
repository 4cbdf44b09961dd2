//! Rows for a spreadsheet.

use crate::row::{Deed, Happening};
use std::fmt::Write;
use unoclp_journal::moment;

/// `time,alarm,change,state,who`, the time in UTC.
pub fn csv_of_alarms(rows: &[Happening]) -> String {
    let mut text = "time,alarm,change,state,who\n".to_owned();
    for of in rows {
        let who = of.who.as_deref().unwrap_or_default();
        line(&mut text, of.at, &[&of.alarm, &of.change, &of.state, who]);
    }
    text
}

/// `time,who,from,of,what,detail`, the time in UTC.
pub fn csv_of_deeds(rows: &[Deed]) -> String {
    let mut text = "time,who,from,of,what,detail\n".to_owned();
    for of in rows {
        let from = of.from.as_deref().unwrap_or_default();
        line(
            &mut text,
            of.at,
            &[&of.who, from, &of.of, &of.what, &of.detail],
        );
    }
    text
}

fn line(text: &mut String, at: i64, values: &[&str]) {
    text.push_str(&moment(at));
    for value in values {
        // To a string nothing fails.
        let _ = write!(text, ",{}", quoted(value));
    }
    text.push('\n');
}

/// A value that a spreadsheet reads as text, whatever it begins with.
fn quoted(value: &str) -> String {
    let is_formula = value.starts_with(['=', '+', '-', '@', '\t', '\r']);
    let value = match is_formula {
        true => format!("'{value}"),
        false => value.to_owned(),
    };
    match value.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", value.replace('"', "\"\"")),
        false => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_a_text_whatever_is_in_it() {
        let deed = Deed {
            at: 0,
            who: "a \"b\", c".into(),
            from: None,
            of: "=1+1".into(),
            what: "write".into(),
            detail: "x = 5".into(),
        };
        let rows = csv_of_deeds(&[deed]);
        let row = "1970-01-01T00:00:00.000Z,\"a \"\"b\"\", c\",,'=1+1,write,x = 5";
        assert_eq!(rows.lines().nth(1), Some(row));
    }
}
