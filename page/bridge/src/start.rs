//! The program that a page begins with, compiled before there is a page: the module that comes first has no compiler.
//!
//! Owns the form of what is kept of it. Must not know how it was compiled: a test does that again, and compares.

use unoclp_checked::{Place, SourceMap};

/// As a person would write it; `page/web/src/page/document.ts` has it from the same file.
const TEXT: &str = include_str!("../start/seal-in.il");
/// Its colours, comments and steps, line by line; after an empty line its numeric code.
const MADE: &str = include_str!("../start/seal-in.made");

/// What is known of the program.
#[derive(Debug, Default, PartialEq)]
pub struct Known {
    /// As [`Checked`](crate::program::Checked) has them.
    pub colours: Vec<u32>,
    /// Where its steps stand.
    pub map: SourceMap,
    /// Its program file.
    pub code: String,
}

/// What is known of this text in Instruction List; nothing of any other.
pub fn known(text: &str) -> Option<Known> {
    (text == TEXT).then(|| read(MADE)).flatten()
}

/// Reads what the test of this file has written.
fn read(made: &str) -> Option<Known> {
    let (head, code) = made.split_once("\n\n")?;
    let mut known = Known {
        code: code.to_owned(),
        ..Known::default()
    };
    let mut comments = Vec::new();
    for line in head.lines() {
        let (what, rest) = line.split_once(' ')?;
        match what {
            "title" => known.map.title.push(rest.to_owned()),
            "comment" => comments.push(rest.to_owned()),
            "colours" => known.colours = rest.split(' ').flat_map(str::parse).collect(),
            _ => {
                let (numbers, name) = rest.rsplit_once(' ')?;
                let numbers: Vec<u32> = numbers.split(' ').flat_map(str::parse).collect();
                let [line, column, last, first, end] = numbers[..] else {
                    return None;
                };
                known.map.steps.push(Place {
                    unit: None,
                    line: line as usize,
                    column: column as usize,
                    last: last as usize,
                    comments: std::mem::take(&mut comments),
                    name: Some(name.to_owned()).filter(|name| name != "-"),
                    codes: first..=end,
                });
            }
        }
    }
    Some(known)
}

#[cfg(all(test, feature = "full"))]
mod tests {
    use super::{Known, MADE, TEXT, known};
    use crate::tell::colours;
    use std::fmt::Write;
    use std::fs;
    use std::path::Path;
    use unoclp_core::Board;
    use unoclp_program::{Source, Written};

    /// What the compiler makes of it for a board.
    fn compiled(board: Board) -> (Source, Vec<u32>) {
        let written = Written::new("seal-in.il".to_owned(), TEXT.into(), board);
        let parts = written.colours();
        let source = written.check(None).unwrap();
        assert!(source.language.warnings().unwrap().iter().next().is_none());
        assert!(source.variables.is_empty() && source.traces.is_empty());
        (source, colours(TEXT, &parts))
    }

    /// The form in which it is kept.
    fn write(known: &Known) -> String {
        let numbers: Vec<String> = known.colours.iter().map(u32::to_string).collect();
        let mut made = format!("colours {}\n", numbers.join(" "));
        for line in &known.map.title {
            writeln!(made, "title {line}").unwrap();
        }
        for step in &known.map.steps {
            for line in &step.comments {
                writeln!(made, "comment {line}").unwrap();
            }
            let (line, column, last) = (step.line, step.column, step.last);
            let (first, end) = (step.codes.start(), step.codes.end());
            let name = step.name.as_deref().unwrap_or("-");
            writeln!(made, "step {line} {column} {last} {first} {end} {name}").unwrap();
        }
        made + "\n" + &known.code
    }

    /// What is kept is what the compiler makes of it, for every board. This test writes it with UPDATE=1.
    #[test]
    fn the_first_program_is_what_the_compiler_makes_of_it() {
        for board in Board::ALL {
            let (source, colours) = compiled(board);
            let made = Known {
                colours,
                map: source.map.clone(),
                code: String::from_utf8(source.code.clone()).unwrap(),
            };
            if std::env::var_os("UPDATE").is_some() {
                let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("start/seal-in.made");
                fs::write(file, write(&made)).unwrap();
                continue;
            }
            assert_eq!(write(&made), MADE);
            let known = known(TEXT).unwrap();
            assert_eq!(known, made);
            let written = Written::new("seal-in.il".to_owned(), TEXT.into(), board);
            let again = written.known(&known.code, known.map).unwrap();
            assert_eq!(format!("{again:?}"), format!("{source:?}"));
        }
        assert!(known(&format!("{TEXT} ")).is_none());
    }
}
