//! A program that is drawn, and its text: one becomes the other.
//!
//! Owns what of a text a document keeps – title, comments, names – and how a document is written as a text again.
//! Must not know which operations there are, nor screens.

mod il;
mod lost;
mod numeric;
mod parts;

use crate::{Language, Source, Written, WrittenIn, names, symbols};
use unoclp_core::Board;
use unoclp_core::isa::START;
use unoclp_draw::Ladder;
use unoclp_draw::edit::{Document, Emitted, Mistake, Row};
use unoclp_lang::{Declared, DeclaredPoint, declared};
use unoclp_point::Address;

pub use il::{blank_text, is_name, name_of};
pub use lost::Lost;

/// What a document is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WriteAs {
    /// Numeric code: comments, but no names.
    Numeric,
    /// Instruction List, with declared names and comments.
    Il,
}

/// The document of a program: its rungs, and what its text says of them.
pub fn document(source: &Source) -> Document {
    let steps = source.program().steps();
    let mut names = names(&source.map, &Ladder::new(source.program().steps()));
    for (point, name) in symbols(source, &names) {
        if let Some(point) = Address::parse(&point) {
            names.insert(point, name);
        }
    }
    // Members of a function block have no name of their own that a declaration could give them.
    names.retain(|_, name| is_name(name));
    let document = Document::of_steps(steps);
    let document = document.with_text(&source.map).with_names(names);
    match source.language {
        Language::Il { .. } => with_declared(document, declared(&source.text).points),
        _ => document,
    }
}

/// The document of a text in Instruction List that has no instruction yet: an empty rung, with the title and the names
/// that are declared. None where the text has one, or cannot be read.
pub fn blank(text: &str) -> Option<Document> {
    let Declared {
        title,
        points,
        is_blank,
    } = declared(text);
    is_blank.then(|| with_declared(Document::new().with_title(title), points))
}

/// A document with the names that its text declares, of points that nothing uses too.
fn with_declared(document: Document, points: Vec<DeclaredPoint>) -> Document {
    let rows = points.into_iter().filter_map(|declared| {
        let DeclaredPoint {
            point,
            name,
            comment,
        } = declared;
        is_name(&name).then_some((point, Row { name, comment }))
    });
    let rows: Vec<_> = rows.collect();
    document.with_rows(rows)
}

/// The text of a document, which compiles to its codes.
///
/// # Errors
/// What is wrong in it, where a board takes no such program.
pub fn text(document: &Document, form: WriteAs, board: Board) -> Result<String, Vec<Mistake>> {
    let emitted = Emitted::of(document);
    let opened =
        |text: &str| Written::new(String::new(), text.into(), board).or_in(Some(form.into()));
    text_of(&emitted, form, board, |text| {
        let source = opened(text).check(None);
        source.is_ok_and(|source| says(&source, &emitted))
    })
}

/// The same, where somebody else knows whether a text comes to the codes of the document. Only where it does not, it is
/// compiled again and again until it does; what would make it something else stays out.
///
/// # Errors
/// All that is wrong in the document, where a board takes no such program.
pub fn text_of(
    emitted: &Emitted<'_>,
    form: WriteAs,
    board: Board,
    comes_to: impl FnOnce(&str) -> bool,
) -> Result<String, Vec<Mistake>> {
    if emitted.codes().is_ok() {
        let text = written(emitted, form);
        if comes_to(&text) {
            return Ok(text);
        }
    }
    let mistakes = emitted.check(board);
    if mistakes.iter().any(|mistake| mistake.what.is_error()) {
        return Err(mistakes);
    }
    Ok(match form {
        WriteAs::Numeric => numeric::text(emitted),
        WriteAs::Il => il::compiled(emitted, board),
    })
}

/// The text of a document, which nobody has compiled: it may not come to its codes.
pub fn written(emitted: &Emitted<'_>, form: WriteAs) -> String {
    match form {
        WriteAs::Numeric => numeric::text(emitted),
        WriteAs::Il => il::text(emitted),
    }
}

/// Whether a program has the codes of a document.
pub fn says(source: &Source, emitted: &Emitted<'_>) -> bool {
    let codes = source.program().steps().flat_map(|step| step.codes());
    let codes = std::iter::once(START).chain(codes);
    emitted.codes().is_ok_and(|wanted| codes.eq(wanted))
}

impl From<WriteAs> for WrittenIn {
    fn from(form: WriteAs) -> WrittenIn {
        match form {
            WriteAs::Numeric => WrittenIn::Numeric,
            WriteAs::Il => WrittenIn::Il,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::{Path, PathBuf};

    fn programs() -> Vec<PathBuf> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
        let folders = [root.clone(), root.join("tutorial"), root.join("il")];
        let files = folders
            .iter()
            .flat_map(|folder| fs::read_dir(folder).unwrap());
        let files = files.map(|entry| entry.unwrap().path());
        let ends = |path: &PathBuf| {
            path.extension()
                .is_some_and(|end| end == "il" || end == "txt")
        };
        let is_program = |path: &PathBuf| ends(path) && !path.ends_with("STATE.TXT");
        files.filter(is_program).collect()
    }

    fn read(name: &str, text: &str) -> Source {
        let written = Written::new(
            name.to_owned(),
            text.as_bytes().to_vec(),
            unoclp_core::Board::UNO,
        );
        let Ok(source) = written.check(None) else {
            panic!("{name}:\n{text}");
        };
        source
    }

    #[test]
    fn each_program_is_the_same_when_its_drawing_is_written_again() {
        let mut seen = 0;
        for path in programs() {
            let text = crate::decode(&fs::read(&path).unwrap());
            let written = Written::new(
                path.display().to_string(),
                text.into_bytes(),
                unoclp_core::Board::UNO,
            );
            let Ok(source) = written.check(None) else {
                continue;
            };
            let document = document(&source);
            let codes = document.codes().unwrap();
            // Instruction List keeps the words of a comment, not its blanks and empty lines.
            let words = |lines: &[String]| -> Vec<String> {
                let words = lines.iter().map(|line| line.trim().to_owned());
                words.filter(|line| !line.is_empty()).collect()
            };
            let about = |document: &Document| -> Vec<Vec<String>> {
                document.rungs().map(|rung| words(&rung.comment)).collect()
            };
            for (form, name) in [(WriteAs::Il, "a.il"), (WriteAs::Numeric, "a.txt")] {
                let text = super::text(&document, form, Board::UNO).unwrap();
                let again = super::document(&read(name, &text));
                let place = path.display();
                assert_eq!(again.codes().unwrap(), codes, "{place}:\n{text}");
                assert_eq!(
                    words(again.title()),
                    words(document.title()),
                    "{place}:\n{text}"
                );
                assert_eq!(about(&again), about(&document), "{place}:\n{text}");
                if form == WriteAs::Il {
                    let names = |document: &Document| document.table().names();
                    assert_eq!(names(&again), names(&document), "{place}:\n{text}");
                }
            }
            seen += 1;
        }
        assert!(seen > 40, "{seen}");
    }

    #[test]
    fn what_the_language_has_for_itself_is_no_name() {
        for name in ["motor", "_a", "pressao", "start_2"] {
            assert!(is_name(name), "{name}");
        }
        for name in ["", "I1", "2a", "a b", "END_VAR", "a.b", "x; END_VAR"] {
            assert!(!is_name(name), "{name}");
        }
    }
}
