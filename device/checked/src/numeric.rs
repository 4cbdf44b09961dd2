//! From a file in numeric code to a checked program, in one pass of the loader.
//!
//! Owns which comment belongs to which step, and where each fault was told. Must not know what a byte or a code
//! means: the loader says both.

use crate::{Checked, Place, SourceMap};
use unoclp_core::{Board, Fault, Loader, Part};

/// The byte-order mark of UTF-8, which is no text (NC-3).
const UTF8_MARK: &[u8] = b"\xEF\xBB\xBF";

/// A fault, and where the loader stood when it told it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Diagnosis {
    /// The fault.
    pub fault: Fault,
    /// The offset in the file, in bytes, of the byte just taken; none at the end of the file.
    pub told_at: Option<usize>,
    /// Bytes of program memory and of run memory that the whole file lacks; 0 where that is not known.
    pub lacking: [usize; 2],
    /// The board that the file was checked for.
    pub board: Board,
}

impl Diagnosis {
    /// A fault on this board, of which nothing more is known.
    pub fn new(fault: Fault, board: Board) -> Diagnosis {
        Diagnosis {
            fault,
            told_at: None,
            lacking: [0; 2],
            board,
        }
    }
}

/// Checks a file in numeric code for this board.
///
/// # Errors
/// Its faults in the order in which they are found, at least one.
pub fn numeric(file: &[u8], board: Board) -> Result<(Checked, SourceMap), Vec<Diagnosis>> {
    let mut reader = Reader::default();
    let mut faults = Vec::new();
    let mut lacking = [0; 2];
    let checked = Checked::new(board, |loader| {
        for (offset, &byte) in file.iter().enumerate() {
            if let Err(fault) = loader.push(byte) {
                faults.push(Diagnosis {
                    told_at: Some(offset),
                    ..Diagnosis::new(fault, board)
                });
            }
            if offset >= UTF8_MARK.len() || !file.starts_with(UTF8_MARK) {
                reader.take(byte, loader);
            }
        }
        while let Err(fault) = loader.end() {
            faults.push(Diagnosis::new(fault, board));
        }
        reader.end_line(loader);
        lacking = loader.lacking();
    });
    for diagnosis in &mut faults {
        diagnosis.lacking = lacking;
    }
    match checked {
        Ok(checked) => Ok((checked, reader.map)),
        Err(fault) if faults.is_empty() => Err(vec![Diagnosis::new(fault, board)]),
        Err(_) => Err(faults),
    }
}

/// Makes the map of a file whose bytes a loader takes.
#[derive(Default)]
struct Reader {
    map: SourceMap,
    /// Lines that have ended.
    lines: usize,
    /// Characters of the line before its code.
    before: usize,
    has_code: bool,
    /// The comment of the line, its first `/` included.
    comment: Vec<u8>,
    /// The comments on lines of their own since the last code.
    comments: Vec<String>,
    /// Codes up to the line before.
    codes: u16,
}

impl Reader {
    /// Takes a byte that the loader has just taken.
    fn take(&mut self, byte: u8, loader: &Loader<'_>) {
        match loader.part() {
            _ if byte == b'\n' => self.end_line(loader),
            Part::Code => self.has_code = true,
            Part::Comment => self.comment.push(byte),
            Part::Blank if !self.has_code => self.before += 1,
            Part::Blank | Part::Faulty => {}
        }
    }

    fn end_line(&mut self, loader: &Loader<'_>) {
        let line = self.lines + 1;
        let comment = std::mem::take(&mut self.comment);
        if !self.has_code {
            self.comments.extend(comment_of_line(&comment));
        } else if self.codes == 0 {
            self.map.title = paragraphs(std::mem::take(&mut self.comments));
        } else if loader.codes() > self.codes {
            self.map.steps.push(Place {
                unit: None,
                line,
                column: self.before + 1,
                last: line,
                comments: paragraphs(std::mem::take(&mut self.comments)),
                name: None,
                codes: line as u32..=line as u32,
            });
        } else if let Some(place) = self.map.steps.last_mut() {
            place.last = line;
            place.codes = *place.codes.start()..=line as u32;
            self.comments.clear();
        }
        self.codes = loader.codes();
        self.lines = line;
        self.before = 0;
        self.has_code = false;
    }
}

/// The words of a comment that has a line of its own; empty where the line is.
fn comment_of_line(comment: &[u8]) -> Option<String> {
    let text = String::from_utf8_lossy(comment);
    let words = text.trim_start_matches('/').trim_end();
    // Rules made of dashes and the like say nothing.
    let says_something = words.is_empty() || words.chars().any(char::is_alphanumeric);
    says_something.then(|| words.strip_prefix(' ').unwrap_or(words).to_owned())
}

/// The lines without the empty ones at the ends and those that follow another.
fn paragraphs(mut lines: Vec<String>) -> Vec<String> {
    lines.dedup_by(|line, before| line.is_empty() && before.is_empty());
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    if lines.first().is_some_and(String::is_empty) {
        lines.remove(0);
    }
    lines
}
