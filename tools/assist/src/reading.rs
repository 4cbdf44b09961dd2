//! A text as it is read: what is compiled by its words as it stands, a project with all its units as one.

use crate::reader::Reader;
use unoclp_lang::{Span, TextLanguage};
use unoclp_plcopen::Whole;
use unoclp_program::{Written, WrittenIn};

/// A text in a language, and where it stands in the file.
pub(crate) enum Reading {
    /// The file is the text.
    Text(String, TextLanguage),
    /// The file is a project.
    Project(Whole),
}

impl Reading {
    /// None of numeric code, and of what is no text.
    pub fn of(written: &Written) -> Option<Reading> {
        match written.language.as_ref().ok()? {
            WrittenIn::Il => Some(Reading::Text(written.text(), TextLanguage::Il)),
            WrittenIn::Typed(language) => Some(Reading::Text(written.text(), *language)),
            WrittenIn::Xml => Whole::of(&written.text()).map(Reading::Project),
            WrittenIn::Numeric => None,
        }
    }

    /// Its words and declarations.
    pub fn reader(&self) -> Reader<'_> {
        match self {
            Reading::Text(text, language) => Reader::new(text, *language),
            Reading::Project(whole) => {
                let mut reader = Reader::new(whole.text(), TextLanguage::St);
                reader.types.extend(whole.units());
                reader.programs.extend(whole.programs());
                reader
            }
        }
    }

    /// Where a byte of the file stands in what is read; none where nothing of it does.
    pub fn byte(&self, byte: u32) -> Option<u32> {
        match self {
            Reading::Text(..) => Some(byte),
            Reading::Project(whole) => whole.in_text(byte),
        }
    }

    /// Where this of what is read stands in the file; none where it does not.
    pub fn span(&self, of: Span) -> Option<Span> {
        match self {
            Reading::Text(..) => Some(of),
            Reading::Project(whole) => whole.in_file(of),
        }
    }
}
