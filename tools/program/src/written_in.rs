//! The languages that files are written in, and their names.

use std::path::Path;
use unoclp_lang::TextLanguage;

/// The language of a file that has been read, and not yet checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WrittenIn {
    /// Numeric code.
    Numeric,
    /// Instruction List.
    Il,
    /// A typed language: Structured Text, InterSCL, LCE.
    Typed(TextLanguage),
    /// A project in PLCopen XML, whose programs are ladder diagrams or texts.
    Xml,
}

impl WrittenIn {
    /// All of them.
    pub fn all() -> Vec<WrittenIn> {
        let typed = TextLanguage::all().into_iter();
        let typed = typed.filter(|language| *language != TextLanguage::Il);
        let others = [WrittenIn::Il, WrittenIn::Xml, WrittenIn::Numeric];
        typed.map(WrittenIn::Typed).chain(others).collect()
    }

    /// Its name for `--language`, by which the names of its files end too; those of numeric code in `.txt`.
    pub const fn name(self) -> &'static str {
        match self {
            WrittenIn::Numeric => "numeric",
            WrittenIn::Il => "il",
            WrittenIn::Typed(language) => language.name(),
            WrittenIn::Xml => "xml",
        }
    }

    /// The language with this name.
    pub fn named(name: &str) -> Option<WrittenIn> {
        WrittenIn::all()
            .into_iter()
            .find(|language| language.name() == name)
    }

    /// The language of the files whose names end so; none where any text may have such a name.
    pub fn of_name(path: &Path) -> Option<WrittenIn> {
        let end = path.extension()?.to_str()?.to_ascii_lowercase();
        WrittenIn::named(&end).filter(|language| *language != WrittenIn::Numeric)
    }
}
