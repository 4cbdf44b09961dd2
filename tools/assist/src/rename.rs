//! The same program by another name.

use crate::meaning::Meaning;
use crate::reader::Reader;
use crate::reading::Reading;
use crate::{Edit, edited, words};
use unoclp_lang::{Lang, Span, is_name};
use unoclp_program::Written;
use unoclp_workspace::Analysis;

/// Why nothing was renamed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoRename {
    /// No name stands there that the text declares.
    NothingThere,
    /// This cannot be a name.
    NoName(String),
    /// Something else has it.
    Taken(String),
    /// With that name the program would be another one, or none.
    Another(String),
}

impl NoRename {
    /// What is wrong, and what to do.
    pub fn message(&self, lang: Lang) -> String {
        match self {
            NoRename::NothingThere => words::nothing_to_rename(lang),
            NoRename::NoName(name) => words::no_name(lang, name),
            NoRename::Taken(name) => words::taken(lang, name),
            NoRename::Another(name) => words::another(lang, name),
        }
    }
}

/// The name at a byte, if it can be another.
pub fn prepare(written: &Written, byte: u32) -> Option<Span> {
    let reading = Reading::of(written)?;
    let reader = reading.reader();
    let meaning = reader.meant(reading.byte(byte)?)?;
    let Meaning::Declared(_) = meaning else {
        return None;
    };
    let uses = reading.uses(&reader, &meaning).into_iter();
    let mut here = uses.filter(|own| own.span.start <= byte && byte <= own.span.end);
    here.next().map(|own| own.span)
}

/// What gives a name at a byte another, wherever it is used, in all units of a project too. Of a text that is a program the
/// other one has the same codes.
///
/// # Errors
/// Where nothing can be renamed so.
pub fn rename(analysis: &Analysis, byte: u32, name: &str) -> Result<Vec<Edit>, NoRename> {
    let written = analysis.written();
    let reading = Reading::of(written).ok_or(NoRename::NothingThere)?;
    let reader = reading.reader();
    let meaning = reading.byte(byte).and_then(|byte| reader.meant(byte));
    let Some(meaning @ Meaning::Declared(declared)) = meaning else {
        return Err(NoRename::NothingThere);
    };
    let name = name.trim();
    let refused = |why: fn(String) -> NoRename| why(name.to_owned());
    if !is_name(name) || is_word(&reader, name) {
        return Err(refused(NoRename::NoName));
    }
    let named = reader.named(declared).ok_or(NoRename::NothingThere)?;
    if reader.written(named.name) == name {
        return Ok(Vec::new());
    }
    let here = reader.find(named.within, name);
    let other = here.or_else(|| reader.find(None, name));
    let other = other.or_else(|| reader.program(name));
    if other.is_some_and(|other| other != declared) {
        return Err(refused(NoRename::Taken));
    }
    let edits = reading.uses(&reader, &meaning).into_iter().map(|own| Edit {
        span: own.span,
        text: name.to_owned(),
    });
    let edits: Vec<Edit> = edits.collect();
    match analysis.source() {
        Some(before) => {
            let after = analysis.with_text(edited(&written.text(), &edits));
            let after = after.source();
            let is_same =
                after.is_some_and(|after| after.program().stored() == before.program().stored());
            is_same.then_some(edits).ok_or(refused(NoRename::Another))
        }
        // What does not compile has no codes to compare: the name must be new to the whole text.
        None => {
            let folded = reader.fold(name);
            let is_used = reader
                .words
                .iter()
                .any(|word| word.is_name() && reader.fold(word.text) == folded);
            match is_used && other.is_none() {
                true => Err(refused(NoRename::Taken)),
                false => Ok(edits),
            }
        }
    }
}

fn is_word(reader: &Reader<'_>, name: &str) -> bool {
    let words = reader.language.vocabulary();
    words
        .iter()
        .any(|word| reader.fold(word) == reader.fold(name))
}
