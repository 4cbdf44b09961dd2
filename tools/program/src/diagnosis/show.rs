//! Faults as text: the line of the file, a caret under what is wrong, and help.

use super::help::help;
use super::portuguese::portuguese;
use crate::words;
use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet};
use std::ops::Range;
use unoclp_checked::Diagnosis;
use unoclp_core::Cause;
use unoclp_lang::Lang;

/// More faults than this are only counted: a file that is no program at all has one in each line.
const SHOWN: usize = 20;

/// The byte-order mark of UTF-8. It is allowed (NC-3), and not shown.
const UTF8_MARK: &[u8] = b"\xEF\xBB\xBF";

/// Shows the faults of a file with this name. The bytes of the file may be anything.
pub fn show(
    name: &str,
    file: &[u8],
    faults: &[Diagnosis],
    lang: Lang,
    renderer: &Renderer,
) -> String {
    let mut text = String::new();
    for diagnosis in faults.iter().take(SHOWN) {
        text.push_str(&show_one(name, file, diagnosis, lang, renderer));
        text.push_str("\n\n");
    }
    if let more @ 1.. = faults.len().saturating_sub(SHOWN) {
        text += &format!("{}\n\n", words::more_faults(lang, more));
    }
    text + &match faults.len() {
        1 => words::one_fault(lang, name),
        count => words::faults(lang, name, count),
    }
}

/// A fault as a person is told it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The line, counted from 1; none where the whole file is meant.
    pub line: Option<u32>,
    /// What is wrong in it: characters from the beginning of the line.
    pub columns: Range<usize>,
    /// What is wrong.
    pub message: &'static str,
    /// What to do, where more can be said.
    pub help: Option<String>,
}

/// Tells one fault of a file. The bytes of the file may be anything.
pub fn tell(file: &[u8], diagnosis: &Diagnosis, lang: Lang) -> Problem {
    let fault = diagnosis.fault;
    let mut problem = Problem {
        line: fault.line,
        columns: 0..0,
        message: cause(fault.cause, lang),
        help: None,
    };
    if let Some(Excerpt { text, mark, .. }) = Excerpt::new(file, diagnosis) {
        let column = |byte: usize| text[..byte].chars().count();
        problem.columns = column(mark.start)..column(mark.end);
        problem.help = help(
            fault.cause,
            &text[mark],
            (diagnosis.lacking, diagnosis.board),
            lang,
        );
    }
    problem
}

/// What is wrong, in this language.
pub const fn cause(cause: Cause, lang: Lang) -> &'static str {
    match lang {
        Lang::En => cause.text(),
        Lang::Pt => portuguese(cause),
    }
}

fn show_one(
    name: &str,
    file: &[u8],
    diagnosis: &Diagnosis,
    lang: Lang,
    renderer: &Renderer,
) -> String {
    let fault = diagnosis.fault;
    let (level, help_level) = match lang {
        Lang::En => (Level::ERROR, Level::HELP),
        Lang::Pt => (
            Level::ERROR.with_name("erro"),
            Level::HELP.with_name("ajuda"),
        ),
    };
    let title = level
        .primary_title(cause(fault.cause, lang))
        .id(fault.cause.number().to_string());
    let group = match Excerpt::new(file, diagnosis) {
        Some(excerpt) => {
            let text = &excerpt.text[excerpt.mark.clone()];
            let help = help(
                fault.cause,
                text,
                (diagnosis.lacking, diagnosis.board),
                lang,
            );
            let mark = AnnotationKind::Primary.span(excerpt.mark);
            let snippet = Snippet::source(excerpt.text)
                .line_start(excerpt.line as usize)
                .path(name)
                .annotation(mark);
            let help = help.map(|help| help_level.message(help));
            title.element(snippet).elements(help)
        }
        None => title.element(Origin::path(name)),
    };
    renderer.render(&[group])
}

/// The line of a fault, made fit to be shown.
struct Excerpt {
    /// The number of the line, counted from 1.
    line: u32,
    /// The line without its end; bytes that are not UTF-8 are replaced.
    text: String,
    /// What is wrong in it: a range of its bytes, at the bounds of characters.
    mark: Range<usize>,
}

impl Excerpt {
    /// None where the fault has no line, or the file has no lines to show.
    fn new(file: &[u8], diagnosis: &Diagnosis) -> Option<Excerpt> {
        let line = diagnosis.fault.line?;
        if diagnosis.fault.cause == Cause::Utf16 {
            return None;
        }
        let lines_before = file.split_inclusive(|&byte| byte == b'\n');
        let mut start = lines_before
            .take((line as usize).saturating_sub(1))
            .map(<[u8]>::len)
            .sum();
        if file.starts_with(UTF8_MARK) && start == 0 {
            start = UTF8_MARK.len();
        }
        let bytes = file.get(start..)?.split(|&byte| byte == b'\n').next()?;
        // A CR that belongs to the line's end is not shown.
        let ended = file.len() > start + bytes.len();
        let bytes = match bytes {
            [bytes @ .., b'\r'] if ended => bytes,
            bytes => bytes,
        };
        let told_at = diagnosis.told_at.and_then(|at| at.checked_sub(start));
        let mark = match diagnosis.fault.cause {
            Cause::StrayCharacter => told_at.filter(|&at| at < bytes.len()),
            Cause::StrayCarriageReturn => bytes.iter().position(|&byte| byte == b'\r'),
            _ => None,
        };
        let mark = match mark {
            Some(at) => at..at + 1,
            None => code(bytes),
        };
        let (text, mark) = lossy(bytes, mark);
        Some(Excerpt { line, text, mark })
    }
}

/// Where the code of a line stands: what is left without blanks and comment.
fn code(line: &[u8]) -> Range<usize> {
    let comment = line.iter().position(|&byte| byte == b'/');
    let before = &line[..comment.unwrap_or(line.len())];
    let start = before.len() - before.trim_ascii_start().len();
    start..start + before.trim_ascii().len()
}

/// The bytes as text, in which U+FFFD replaces what is not UTF-8; and a range of them as a range
/// of the text, widened to whole characters.
fn lossy(bytes: &[u8], range: Range<usize>) -> (String, Range<usize>) {
    let mut text = String::new();
    let mut mark = None;
    let mut at = 0;
    let mut push = |character: char, width: usize| {
        let shown = text.len()..text.len() + character.len_utf8();
        if at < range.end && range.start < at + width {
            let start = mark
                .take()
                .map_or(shown.start, |mark: Range<usize>| mark.start);
            mark = Some(start..shown.end);
        }
        text.push(character);
        at += width;
    };
    for chunk in bytes.utf8_chunks() {
        chunk.valid().chars().for_each(|c| push(c, c.len_utf8()));
        if !chunk.invalid().is_empty() {
            push(char::REPLACEMENT_CHARACTER, chunk.invalid().len());
        }
    }
    // Nothing is marked where there is nothing to mark: the fault is that the line ends.
    let mark = mark.unwrap_or(text.len()..text.len());
    (text, mark)
}
