//! All messages about a text, each with a stable code and its words in two languages.
//!
//! The compiler fills in `{0}` and `{1}`. A code that has been published never changes its meaning. Each file here
//! is a table, which hands its rows on to the next table; the last one hands all of them to `messages!`.
//!
//! - `il`: Instruction List, 11 to 99; `docs/il-diagnostics.md` and its translation have an entry for each
//! - `st`: Structured Text and what the typed languages share, 101 to 299; `docs/st-diagnostics.md` likewise
//! - `iscl`: InterSCL alone, 301 to 399; `docs/interscl-diagnostics.md` likewise
//! - `lce`: LCE alone, 401 to 499; `docs/lce-diagnostics.md` likewise
//! - `xml`: projects in PLCopen XML, 501 to 599; `docs/plcopen-diagnostics.md` likewise

#[macro_use]
mod il;
#[macro_use]
mod st;
#[macro_use]
mod iscl;
#[macro_use]
mod lce;
#[macro_use]
mod xml;

use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};

use crate::severity::Severity;

/// The words of a diagnostic in one language.
pub struct Words {
    /// What is wrong, in a sentence without a full stop.
    pub message: &'static str,
    /// What to do about it; may be empty.
    pub help: &'static str,
}

/// A row of the tables, or of the table of a language from elsewhere.
pub struct Row {
    /// What its number follows: `ST` of `ST-101`.
    pub table: &'static str,
    /// Its number, which never changes its meaning.
    pub number: u16,
    /// The severity of a message.
    pub severity: Severity,
    /// Its words in English.
    pub english: Words,
    /// Its words in Portuguese.
    pub portuguese: Words,
}

/// What a diagnostic is about: a row of the tables, compared by its number. A program holds the rows that its code
/// names, so the page's small module comes without the texts of the typed languages.
#[derive(Clone, Copy)]
pub struct Code(&'static Row);

macro_rules! messages {
    ($($number:literal $name:ident $severity:ident $en:literal $en_help:literal $pt:literal $pt_help:literal;)*) => {
        #[expect(non_upper_case_globals, reason = "one reads them like the variants of an enum")]
        impl Code {
            $(
                #[doc = $en]
                pub const $name: Code = Code(&Row {
                    table: table($number),
                    number: $number,
                    severity: Severity::$severity,
                    english: Words { message: $en, help: $en_help },
                    portuguese: Words { message: $pt, help: $pt_help },
                });
            )*

            /// Every code, in the order of its number.
            pub const ALL: &'static [Code] = &[$(Code::$name,)*];
        }
    };
}

il_rows! { st_rows iscl_rows lce_rows xml_rows messages }

/// What the numbers of a table follow.
const fn table(number: u16) -> &'static str {
    match number {
        0..=99 => "IL",
        100..=299 => "ST",
        300..=399 => "ISCL",
        400..=499 => "LCE",
        _ => "XML",
    }
}

/// No number appears twice.
const _: () = {
    let mut next = 1;
    while next < Code::ALL.len() {
        assert!(Code::ALL[next - 1].number() < Code::ALL[next].number());
        next += 1;
    }
};

impl Code {
    /// The code of a row in the table of a language from elsewhere.
    pub const fn of(row: &'static Row) -> Code {
        Code(row)
    }

    /// The number in its name: `IL-11`, `ST-101`, `ISCL-301`, `LCE-401`, `XML-501`.
    pub const fn number(self) -> u16 {
        self.0.number
    }

    /// Whether the text can be compiled anyway.
    pub const fn severity(self) -> Severity {
        self.0.severity
    }

    /// Its words in English.
    pub const fn english(self) -> &'static Words {
        &self.0.english
    }

    /// Its words in Portuguese.
    pub const fn portuguese(self) -> &'static Words {
        &self.0.portuguese
    }
}

impl PartialEq for Code {
    fn eq(&self, other: &Code) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Code {}

impl PartialOrd for Code {
    fn partial_cmp(&self, other: &Code) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Code {
    fn cmp(&self, other: &Code) -> Ordering {
        let key = |code: &Code| (code.0.number, code.0.table);
        key(self).cmp(&key(other))
    }
}

impl Hash for Code {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.number().hash(state);
    }
}

impl fmt::Display for Code {
    /// `IL-11`, `ST-101`, `ISCL-301`, `LCE-401`, `XML-501`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Row { table, number, .. } = self.0;
        write!(f, "{table}-{number}")
    }
}

impl fmt::Debug for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
