//! What to do about a fault, where more can be said than the fault's own text.

use crate::BOARD;
use unoclp_core::Cause;
use unoclp_core::isa::{Row, TABLE};

/// Help for a fault at this text of the file, if there is any.
pub(super) fn help(cause: Cause, text: &str, lacking: [usize; 2]) -> Option<String> {
    match cause {
        Cause::UnknownCode => unknown_code(text.parse().ok()?),
        Cause::NoSuchInput => Some(format!("the UNO has inputs 01 to {:02}", BOARD.inputs)),
        Cause::NoSuchOutput => Some(format!("the UNO has outputs 01 to {:02}", BOARD.outputs)),
        Cause::NoStart => Some("write a line with 0 above this one".to_owned()),
        Cause::StrayCharacter if text.starts_with(|c: char| c.is_ascii_digit()) => {
            Some("one code stands on a line; put this one on a line of its own".to_owned())
        }
        Cause::ProgramFull | Cause::RunMemoryFull => Some(format!(
            "the UNO holds {} bytes of program and has {} bytes to run it; {} and {} are lacking; timers, \
             markers and numbers take more there than stored, and what is kept takes room for two records",
            BOARD.stored_bytes, BOARD.linked_bytes, lacking[0], lacking[1]
        )),
        _ => None,
    }
}

/// The instruction that was probably meant.
fn unknown_code(code: i32) -> Option<String> {
    let forgotten_point = |row: &&Row| row.kind.has_number() && row.code / 100 == code;
    if let Some(row) = TABLE.iter().find(forgotten_point) {
        return Some(format!(
            "two digits for the point are missing: {} is {} 01",
            example(row),
            row.letters
        ));
    }
    let negated = |row: &&Row| pattern(row, code.wrapping_neg()) == row.code;
    if code < 0 && TABLE.iter().any(|row| negated(&row)) {
        return Some("this code has no negated form; leave out the -".to_owned());
    }
    let row = TABLE
        .iter()
        .find(|row| one_slip(&pattern(row, code).to_string(), &row.code.to_string()))?;
    let what = row.effect.split(':').next().unwrap_or_default();
    Some(format!("is it {}, {} ({what})?", example(row), row.letters))
}

/// A code as it would stand in the table if it were of the kind of this row: where the row takes
/// a point, with XX = 00.
fn pattern(row: &Row, code: i32) -> i32 {
    if row.kind.has_number() {
        code / 100 * 100
    } else {
        code
    }
}

/// A code of this row, with point 01 where it takes one.
fn example(row: &Row) -> i32 {
    if row.kind.has_number() {
        row.code + row.code.signum()
    } else {
        row.code
    }
}

/// Whether one slip of the hand leads from one text to the other: a digit wrong, missing or too
/// many, or two neighbours exchanged.
fn one_slip(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let start = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[start..], &b[start..]);
    let end = a.iter().rev().zip(b.iter().rev());
    let end = end.take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[..a.len() - end], &b[..b.len() - end]);
    match (a, b) {
        ([w, x], [y, z]) => (w, x) == (z, y),
        _ => a.len().max(b.len()) == 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn help_names_the_code_that_was_meant() {
        let cases = [
            (
                "8273",
                "two digits for the point are missing: 827301 is RI 01",
            ),
            ("-877901", "this code has no negated form"),
            ("-787600", "this code has no negated form"),
            ("827401", "is it 827301, RI (contact, normally open)?"),
            ("872301", "is it 827301, RI (contact, normally open)?"),
            ("82733", "is it 827301, RI (contact, normally open)?"),
            ("787601", "is it 787600, NL (new rung)?"),
            ("84797", "is it 847978, TON (on-delay timer)?"),
            ("42", "is it 40, ( (open an OR branch)?"),
        ];
        for (code, expected) in cases {
            let help = help(Cause::UnknownCode, code, [0; 2]);
            let starts = help
                .as_deref()
                .is_some_and(|help| help.starts_with(expected));
            assert!(starts, "{code}: {help:?}");
        }
        assert_eq!(help(Cause::UnknownCode, "123456", [0; 2]), None);
        assert_eq!(help(Cause::UnknownCode, "-2147483648", [0; 2]), None);
    }
}
