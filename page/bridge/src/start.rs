//! The program that a page begins with, compiled before there is a page: the module that comes first has no compiler.
//!
//! Owns the form of what is kept of it. Must not know how it was compiled: a test does that again, and compares.

use unoclp_checked::{Place, SourceMap};
use unoclp_lang::{Colour, Span};
use unoclp_program::{Refused, Source, Written, WrittenIn};
use unoclp_workspace::Compilers;

/// As a person would write it; `page/web/src/page/document.ts` has it from the same file.
const TEXT: &str = include_str!("../start/seal-in.il");
/// Its colours, comments and steps, line by line; after an empty line its numeric code.
const MADE: &str = include_str!("../start/seal-in.made");

/// As numbers of what is kept name them.
const COLOURS: [Colour; 5] = [
    Colour::Comment,
    Colour::Text,
    Colour::Point,
    Colour::Number,
    Colour::Word,
];

/// What is known of the program.
#[derive(Debug, Default, PartialEq)]
pub struct Known {
    /// Its coloured parts.
    pub colours: Vec<(Span, Colour)>,
    /// Where its steps stand.
    pub map: SourceMap,
    /// Its program file.
    pub code: String,
}

/// What is known of this text in Instruction List; nothing of any other.
pub fn known(text: &str) -> Option<Known> {
    (text == TEXT).then(|| read(MADE)).flatten()
}

/// What the first module opens texts with: numeric code, and this program.
pub struct First;

impl Compilers for First {
    fn check(&self, written: Written) -> Option<Result<Source, Refused>> {
        match of(&written) {
            // What is kept of it is a program: its test has read it.
            Some(known) => Some(Ok(written.known(&known.code, known.map).ok()?)),
            None => written.check_numeric(),
        }
    }

    fn colours(&self, written: &Written) -> Vec<(Span, Colour)> {
        of(written).map_or_else(|| written.colours_numeric(), |known| known.colours)
    }
}

/// What is known of this text.
fn of(written: &Written) -> Option<Known> {
    let is_list = written.language == Ok(WrittenIn::Il);
    is_list.then(|| known(&written.text())).flatten()
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
            "colours" => {
                let numbers: Vec<u32> = rest.split(' ').flat_map(str::parse).collect();
                let (parts, _) = numbers.as_chunks();
                known.colours = parts
                    .iter()
                    .map(|&[start, end, colour]| {
                        Some((Span { start, end }, *COLOURS.get(colour as usize)?))
                    })
                    .collect::<Option<_>>()?;
            }
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
    use super::{COLOURS, First, Known, MADE, TEXT, known};
    use std::fmt::Write;
    use std::fs;
    use std::path::Path;
    use unoclp_core::Board;
    use unoclp_lang::{Colour, Span};
    use unoclp_program::{Source, Written};
    use unoclp_workspace::Compilers;

    /// What the compiler makes of it for a board.
    fn compiled(board: Board) -> (Source, Vec<(Span, Colour)>) {
        let written = Written::new("seal-in.il".to_owned(), TEXT.into(), board);
        let colours = written.colours();
        let source = written.check(None).unwrap();
        assert!(source.language.warnings().unwrap().iter().next().is_none());
        assert!(source.variables.is_empty() && source.traces.is_empty());
        (source, colours)
    }

    /// The form in which it is kept.
    fn write(known: &Known) -> String {
        let numbers = known.colours.iter().map(|(Span { start, end }, colour)| {
            let colour = COLOURS.iter().position(|own| own == colour).unwrap();
            format!("{start} {end} {colour}")
        });
        let numbers: Vec<String> = numbers.collect();
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
        let open = |text: &str| Written::new("a.il".to_owned(), text.into(), Board::ALL[0]);
        assert!(
            First
                .check(open(TEXT))
                .is_some_and(|checked| checked.is_ok())
        );
        assert!(First.check(open("LD I1\nST Q1\n")).is_none());
        assert_eq!(First.colours(&open(TEXT)), known(TEXT).unwrap().colours);
    }
}
