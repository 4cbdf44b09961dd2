//! Everything that can be said about a text, each with a stable code and its words in two languages.
//!
//! `{0}`, `{1}` stand for what the place in the text adds. A code that has been published never changes
//! its meaning. Each file here is a table: its rows, handed on to the next table and at last to `messages!`.
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

use crate::diagnostics::Severity;

/// The words of a diagnostic in one language; the help is empty where there is none.
pub(crate) struct Words {
    pub message: &'static str,
    pub help: &'static str,
}

macro_rules! messages {
    ($($number:literal $name:ident $severity:ident $en:literal $en_help:literal $pt:literal $pt_help:literal;)*) => {
        /// What a diagnostic is about. Its discriminant is the number in its code, `IL-11`, `ST-101`, `ISCL-301`, `LCE-401`, `XML-501`.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u16)]
        pub enum Code {
            $(#[doc = $en] $name = $number,)*
        }

        impl Code {
            /// Every code, in the order of its number.
            pub const ALL: &'static [Code] = &[$(Code::$name,)*];

            /// Whether the text can be compiled all the same.
            pub const fn severity(self) -> Severity {
                match self {
                    $(Code::$name => Severity::$severity,)*
                }
            }

            pub(crate) const fn english(self) -> Words {
                match self {
                    $(Code::$name => Words { message: $en, help: $en_help },)*
                }
            }

            pub(crate) const fn portuguese(self) -> Words {
                match self {
                    $(Code::$name => Words { message: $pt, help: $pt_help },)*
                }
            }
        }
    };
}

il_rows! { st_rows iscl_rows lce_rows xml_rows messages }
