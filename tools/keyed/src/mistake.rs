//! What can be wrong with a file, as values and in words.

use crate::words;
use unoclp_words::Lang;

/// A mistake, and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake<W> {
    /// The line of the file, counted from 1.
    pub line: usize,
    /// What is wrong.
    pub wrong: W,
}

/// What can be said of something that is wrong.
pub trait Reason {
    /// The reason and the remedy, in this language.
    fn text(&self, lang: Lang) -> String;
}

impl<W: Reason> Mistake<W> {
    /// The reason and the remedy, in this language.
    pub fn reason(&self, lang: Lang) -> String {
        self.wrong.text(lang)
    }

    /// The same with its place: `press.toml:7: there is no key …`
    pub fn text(&self, file: &str, lang: Lang) -> String {
        format!("{file}:{}: {}", self.line, self.reason(lang))
    }
}

/// What can be wrong with any file in TOML.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Amiss {
    /// It is no TOML.
    NoToml,
    /// There is no such key here.
    NoKey {
        /// The key.
        key: String,
        /// Those that there are.
        known: String,
    },
    /// A key is missing.
    Missing {
        /// The key.
        key: &'static str,
        /// An example of it.
        example: &'static str,
    },
    /// A value is of another kind.
    Kind {
        /// The key.
        key: &'static str,
        /// An example of it.
        example: &'static str,
    },
    /// A text is none of those that there are.
    Choice {
        /// The key.
        key: String,
        /// What was given.
        given: String,
        /// Those that there are.
        known: String,
    },
}

impl Reason for Amiss {
    fn text(&self, lang: Lang) -> String {
        match self {
            Amiss::NoToml => words::no_toml(lang),
            Amiss::NoKey { key, known } => words::no_key(lang, key, known),
            Amiss::Missing { key, example } => words::missing(lang, key, example),
            Amiss::Kind { key, example } => words::kind(lang, key, example),
            Amiss::Choice { key, given, known } => words::choice(lang, key, given, known),
        }
    }
}
