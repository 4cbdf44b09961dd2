//! What is wrong with a text, or worth a second look.

pub use crate::messages::{Code, Row, Words};
pub use crate::severity::Severity;
use std::collections::HashSet;
use std::ops::Deref;
use std::ops::Range;
pub use unoclp_words::Lang;

/// A word that a place in the text adds to a message: the same in every language, or one for each.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Word {
    /// What is in the text.
    Text(String),
    /// English, and Portuguese.
    Both(String, String),
    /// The name that may have been meant: "did you mean `motor`?"
    Near(String),
}

impl From<&str> for Word {
    fn from(text: &str) -> Word {
        Word::Text(text.to_owned())
    }
}

impl From<String> for Word {
    fn from(text: String) -> Word {
        Word::Text(text)
    }
}

impl From<(&str, &str)> for Word {
    fn from((en, pt): (&str, &str)) -> Word {
        Word::Both(en.to_owned(), pt.to_owned())
    }
}

impl From<(String, String)> for Word {
    fn from((en, pt): (String, String)) -> Word {
        Word::Both(en, pt)
    }
}

/// Bytes of the text, from the first to after the last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Span {
    /// The first byte.
    pub start: u32,
    /// After the last.
    pub end: u32,
}

impl Span {
    /// As a range of indices.
    pub fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }

    /// Its place without its text.
    pub fn empty(self) -> Span {
        Span {
            end: self.start,
            ..self
        }
    }

    /// From the beginning of this to the end of that.
    pub fn to(self, end: Span) -> Span {
        Span {
            start: self.start,
            end: end.end.max(self.end),
        }
    }
}

/// One error or warning at one place of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// What it is about.
    pub code: Code,
    /// The offending text.
    pub span: Span,
    words: Vec<Word>,
}

impl Diagnostic {
    /// A diagnostic whose message takes these words.
    pub fn new(code: Code, span: Span, words: Vec<Word>) -> Diagnostic {
        Diagnostic { code, span, words }
    }

    /// The same of another text, in which it is here.
    #[must_use]
    pub fn at(&self, span: Span) -> Diagnostic {
        Diagnostic {
            span,
            ..self.clone()
        }
    }

    /// Whether there is a program anyway.
    pub fn severity(&self) -> Severity {
        self.code.severity()
    }

    /// What is wrong, in a sentence without a full stop.
    pub fn message(&self, lang: Lang) -> String {
        let words = match lang {
            Lang::En => self.code.english(),
            Lang::Pt => self.code.portuguese(),
        };
        self.fill(words.message, lang)
    }

    /// What to do about it; empty where there is nothing to say.
    pub fn help(&self, lang: Lang) -> String {
        let words = match lang {
            Lang::En => self.code.english(),
            Lang::Pt => self.code.portuguese(),
        };
        self.fill(words.help, lang)
    }

    /// What the place in the text adds to the message.
    pub fn words(&self) -> &[Word] {
        &self.words
    }

    fn fill(&self, template: &str, lang: Lang) -> String {
        let mut text = String::with_capacity(template.len());
        let mut rest = template;
        while let Some((before, behind)) = rest.split_once('{') {
            text.push_str(before);
            let Some((number, after)) = behind.split_once('}') else {
                break;
            };
            match number.parse().ok().and_then(|n: usize| self.words.get(n)) {
                Some(Word::Text(word)) => text.push_str(word),
                Some(Word::Both(en, pt)) => text.push_str(match lang {
                    Lang::En => en,
                    Lang::Pt => pt,
                }),
                Some(Word::Near(name)) => {
                    let [before, after] = match lang {
                        Lang::En => ["did you mean `", "`?"],
                        Lang::Pt => ["você quis dizer `", "`?"],
                    };
                    text.extend([before, name, after]);
                }
                None => {}
            }
            rest = after;
        }
        text.push_str(rest);
        text
    }
}

/// Where the lines of a text begin.
#[derive(Clone, Debug)]
pub struct Lines(Vec<u32>);

impl Lines {
    /// Of this text.
    pub fn new(text: &str) -> Lines {
        let behind = text.bytes().zip(1..).filter(|(byte, _)| *byte == b'\n');
        Lines(std::iter::once(0).chain(behind.map(|(_, at)| at)).collect())
    }

    /// The line that this byte is in, from 1.
    pub fn line(&self, byte: u32) -> u32 {
        self.0.partition_point(|&start| start <= byte) as u32
    }

    /// The first byte of a line, which counts from 1.
    pub fn start(&self, line: u32) -> u32 {
        let index = (line as usize).saturating_sub(1);
        self.0.get(index).or(self.0.last()).copied().unwrap_or(0)
    }

    /// The line and the column of a byte, each from 1; a column is a character.
    pub fn place(&self, text: &str, byte: u32) -> (u32, u32) {
        let line = self.line(byte);
        let start = self.0.get(line as usize - 1).copied().unwrap_or(0);
        let before = text.get(start as usize..byte as usize).unwrap_or_default();
        (line, before.chars().count() as u32 + 1)
    }

    /// The byte at this line and column.
    pub fn byte(&self, text: &str, line: usize, column: usize) -> u32 {
        let start = self.start(line as u32);
        let after = text.get(start as usize..).unwrap_or_default();
        let before = after.chars().take(column.saturating_sub(1));
        start + before.map(char::len_utf8).sum::<usize>() as u32
    }
}

/// More errors than this, and more warnings, are only counted: the first ones say what to correct.
const MOST: usize = 100;

/// The diagnostics of a run, as they are found.
#[derive(Clone, Debug, Default)]
pub struct Found {
    told: Vec<Diagnostic>,
    errors: usize,
    warnings: usize,
    /// A function's body is compiled once for each call, and says the same each time.
    seen: HashSet<(Code, Span)>,
}

impl Found {
    /// Tells this of a place, once; `words` are what the message takes.
    pub fn tell<const N: usize>(&mut self, code: Code, span: Span, words: [Word; N]) {
        if !self.seen.insert((code, span)) {
            return;
        }
        let count = match code.severity() {
            Severity::Error => &mut self.errors,
            Severity::Warning => &mut self.warnings,
        };
        *count += 1;
        if *count <= MOST {
            self.told.push(Diagnostic::new(code, span, words.into()));
        }
    }

    /// Whether one of them is an error, so that there is no program.
    pub fn has_errors(&self) -> bool {
        self.errors > 0
    }

    /// Where errors have been told.
    pub fn errors(&self) -> impl Iterator<Item = Span> + '_ {
        let errors = self.told.iter();
        let errors = errors.filter(|d| d.severity() == Severity::Error);
        errors.map(|d| d.span)
    }

    /// Whether this was told there.
    pub fn was_told(&self, code: Code, span: Span) -> bool {
        self.seen.contains(&(code, span))
    }

    /// The first place where this was told.
    pub fn place_of(&self, code: Code) -> Option<Span> {
        let told = self.told.iter().filter(|d| d.code == code);
        told.map(|d| d.span).min_by_key(|span| span.start)
    }

    /// Forgets all but what this holds of.
    pub fn keep(&mut self, holds: impl Fn(&Diagnostic) -> bool) {
        self.told.retain(holds);
        let errors = self.told.iter();
        self.errors = errors.filter(|d| d.severity() == Severity::Error).count();
        self.warnings = self.told.len() - self.errors;
    }

    /// Puts what was told behind the first `length` bytes, in a text that was added to this one, at their end.
    pub fn within(&mut self, length: usize) {
        let end = length as u32;
        for diagnostic in &mut self.told {
            let span = &mut diagnostic.span;
            (span.start, span.end) = (span.start.min(end), span.end.min(end));
        }
    }

    /// Adds the diagnostics of others.
    pub fn join(&mut self, other: Found) {
        for diagnostic in other.told {
            let Diagnostic { code, span, .. } = diagnostic;
            if self.seen.insert((code, span)) {
                match code.severity() {
                    Severity::Error => self.errors += 1,
                    Severity::Warning => self.warnings += 1,
                }
                self.told.push(diagnostic);
            }
        }
    }

    /// All of them in the order of their places.
    pub fn finish(mut self) -> Told {
        self.told
            .sort_by_key(|d| (d.span.start, d.span.end, d.code));
        Told {
            more: self.errors + self.warnings - self.told.len(),
            listed: self.told,
        }
    }
}

/// What was found in a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Told {
    /// In the order of their places.
    pub listed: Vec<Diagnostic>,
    /// How many more were found than are listed.
    pub more: usize,
}

impl Deref for Told {
    type Target = [Diagnostic];

    fn deref(&self) -> &[Diagnostic] {
        &self.listed
    }
}
