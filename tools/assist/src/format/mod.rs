//! The same words of a text, well placed.
//!
//! Owns blanks: no word and no comment changes, and lines stay the lines that they are. A text whose words would not come
//! back the same is left alone.

mod blocks;
mod columns;
mod gaps;
mod line;

use crate::reader::Reader;
use crate::{Edit, language};
use line::Line;
use unoclp_lang::{Lines, Span};
use unoclp_program::Written;

/// Blank lines in a row that stay.
const MOST_BLANK: usize = 2;

/// What places the words of a text well; nothing where they are, or where the language has no form. `indent`: blanks for
/// each step, as the text itself has it where none is given.
pub fn format(written: &Written, indent: Option<usize>) -> Vec<Edit> {
    let text = written.text();
    let Some(formed) = formed(written, &text, indent) else {
        return Vec::new();
    };
    changes(&text, &formed)
}

fn formed(written: &Written, text: &str, indent: Option<usize>) -> Option<String> {
    let language = language(written)?;
    let reader = Reader::new(text, language);
    let lines = lines(&reader)?;
    let step = indent.unwrap_or_else(|| step(&lines)).clamp(1, 8);
    let formed = match language.name() {
        "st" | "scl" | "iscl" => blocks::formed(&lines, blocks::Blocks::Words, step),
        "lce" => blocks::formed(&lines, blocks::Blocks::Braces, step),
        "il" => columns::formed(&lines, step),
        _ => return None,
    };
    let text_of = |lines: Vec<String>| {
        let mut all = String::new();
        let mut blank = 0;
        for line in lines {
            blank = if line.trim().is_empty() { blank + 1 } else { 0 };
            if blank <= MOST_BLANK {
                all.push_str(line.trim_end_matches([' ', '\t']));
                all.push('\n');
            }
        }
        let end = all.trim_end_matches('\n').len();
        all.truncate(end);
        all.push('\n');
        all
    };
    let formed = text_of(formed);
    // The words are the same ones, in the same order; so are the comments, which are what else is not blank.
    let same = |text: &str| -> String { text.split_whitespace().collect() };
    let again = Reader::new(&formed, language);
    let words = |reader: &Reader<'_>| -> Vec<String> {
        let words = reader.words.iter();
        words.map(|word| word.text.to_owned()).collect()
    };
    (same(text) == same(&formed) && words(&reader) == words(&again)).then_some(formed)
}

/// The lines of a text; none of one in which a word has more than one.
fn lines<'r, 't>(reader: &'r Reader<'t>) -> Option<Vec<Line<'r, 't>>> {
    let text = reader.text;
    let mut all = Vec::new();
    let (mut start, mut at) = (0, 0);
    for line in text.split('\n') {
        let end = start + line.len();
        let from = at;
        while reader
            .words
            .get(at)
            .is_some_and(|word| (word.span.start as usize) < end)
        {
            if reader.words[at].text.contains('\n') {
                return None;
            }
            at += 1;
        }
        let behind = from
            .checked_sub(1)
            .map_or(0, |before| reader.words[before].span.end as usize);
        let gap = text.get(behind..start).unwrap_or_default();
        all.push(Line {
            text: line.trim_end_matches('\r'),
            words: &reader.words[from..at],
            start,
            is_within: gaps::is_open(gap),
        });
        start = end + 1;
    }
    Some(all)
}

/// The blanks of the first line that has as many as people use.
fn step(lines: &[Line<'_, '_>]) -> usize {
    let indented = lines
        .iter()
        .filter(|line| !line.is_within && !line.words.is_empty());
    let blanks = |line: &Line<'_, '_>| {
        let text = line.text;
        let blanks = &text[..text.len() - text.trim_start().len()];
        match blanks.contains('\t') {
            true => 4,
            false => blanks.len(),
        }
    };
    let usual = |blanks: &usize| [2, 3, 4, 8].contains(blanks);
    indented.map(blanks).find(usual).unwrap_or(2)
}

/// What makes one text of another, line by line where they have the same lines.
fn changes(old: &str, new: &str) -> Vec<Edit> {
    if old == new {
        return Vec::new();
    }
    let (before, after): (Vec<&str>, Vec<&str>) =
        (old.split('\n').collect(), new.split('\n').collect());
    let starts = Lines::new(old);
    let span = |line: usize| {
        let start = starts.start(line as u32 + 1);
        Span {
            start,
            end: start + before[line].len() as u32,
        }
    };
    if before.len() == after.len() {
        let lines = before.iter().zip(&after).enumerate();
        let changed = lines.filter(|(_, (old, new))| old != new);
        let edit = |(line, (_, new)): (usize, (&&str, &&str))| Edit {
            span: span(line),
            text: (*new).to_owned(),
        };
        return changed.map(edit).collect();
    }
    vec![Edit {
        span: Span {
            start: 0,
            end: old.len() as u32,
        },
        text: new.to_owned(),
    }]
}
