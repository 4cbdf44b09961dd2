//! The words of Structured Text, and the signs that it and other languages have.
//!
//! Must not know where in a text they stand.

use unoclp_text::diagnostics::Span;

/// How a text is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// IEC 61131-3.
    #[default]
    Iec,
    /// As Siemens writes it: `#name`, `"name"`, BEGIN.
    Scl,
    /// Pieces of Instruction List, which declares as Structured Text does.
    Il,
}

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A keyword or a name; of SCL's `#name` and `"name"` the span is that of the name within.
    Word,
    /// `%IX1`
    Address,
    /// `20`, `16#FF`, `1.5E3`, and what sticks to it.
    Number,
    /// `T#20s`, `INT#5`, `Color#Red`.
    Typed,
    /// `'text'`
    Text,
    /// `"text"`
    Wide,
    Assign,
    Arrow,
    Colon,
    Semicolon,
    Comma,
    Open,
    Close,
    OpenSquare,
    CloseSquare,
    Dot,
    Range,
    Plus,
    Minus,
    Star,
    Power,
    Slash,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    And,
    /// An operator of another language that stands for more than one here: `+=`, `++`, `{`.
    Foreign,
    /// `{{ … }}`, code for another machine.
    ForeignCode,
    End,
}

/// A token and its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Token {
    pub kind: Kind,
    pub span: Span,
    /// The operator was another language's, which has been told; it is read as the one that was meant.
    pub meant: Option<&'static str>,
}

/// What other languages write: the characters, the token that is meant, and how it is written here.
pub(super) const MEANT: [(&str, Kind, &str); 14] = [
    ("==", Kind::Equal, "="),
    ("!=", Kind::NotEqual, "<>"),
    ("&&", Kind::And, "AND"),
    ("||", Kind::Word, "OR"),
    ("|", Kind::Word, "OR"),
    ("!", Kind::Word, "NOT"),
    ("=<", Kind::LessEqual, "<="),
    ("=:", Kind::Assign, ":="),
    ("::=", Kind::Assign, ":="),
    ("≤", Kind::LessEqual, "<="),
    ("≥", Kind::GreaterEqual, ">="),
    ("≠", Kind::NotEqual, "<>"),
    ("×", Kind::Star, "*"),
    ("÷", Kind::Slash, "/"),
];

/// What they write for more than one of these.
pub(super) const FOREIGN: [&str; 8] = ["+=", "-=", "*=", "/=", "++", "--", "{", "}"];

/// What is written here, the longer ones first.
pub(super) const PLAIN: [(&str, Kind); 27] = [
    (":=", Kind::Assign),
    ("=>", Kind::Arrow),
    ("..", Kind::Range),
    ("**", Kind::Power),
    ("<>", Kind::NotEqual),
    ("<=", Kind::LessEqual),
    (">=", Kind::GreaterEqual),
    (":", Kind::Colon),
    (";", Kind::Semicolon),
    (",", Kind::Comma),
    ("(", Kind::Open),
    (")", Kind::Close),
    ("[", Kind::OpenSquare),
    ("]", Kind::CloseSquare),
    (".", Kind::Dot),
    ("+", Kind::Plus),
    ("-", Kind::Minus),
    ("*", Kind::Star),
    ("/", Kind::Slash),
    ("=", Kind::Equal),
    ("<", Kind::Less),
    (">", Kind::Greater),
    ("&", Kind::And),
    // An array's bounds in other languages.
    ("…", Kind::Range),
    ("−", Kind::Minus),
    ("–", Kind::Minus),
    ("\u{37e}", Kind::Semicolon),
];
