//! The signs of the small languages, and what each of them says of its own.
//!
//! Must not know where in a text they stand.

use unoclp_text::diagnostics::{Code, Span};

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// A keyword or a name.
    Word,
    /// `%IX1`
    Address,
    /// `20`, `16#FF`, `1.5`, and what sticks to it.
    Number,
    /// `'text'`, `"text"`
    Text,
    /// What stands after a word that takes the rest of its line.
    Title,
    /// `:=`
    Assign,
    /// `:`
    Colon,
    /// `;`
    Semicolon,
    /// `,`
    Comma,
    /// `(`
    Open,
    /// `)`
    Close,
    /// `{`
    OpenBrace,
    /// `}`
    CloseBrace,
    /// `+`
    Plus,
    /// `-`
    Minus,
    /// `*`
    Star,
    /// `/`
    Slash,
    /// AND, as a sign
    And,
    /// OR, as a sign
    Or,
    /// XOR, as a sign
    Xor,
    /// NOT, as a sign
    Not,
    /// Equal to.
    Equal,
    /// Not equal to.
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// An operator of other languages that stands for more than one here: `+=`, `++`.
    Foreign,
    /// The end of the text.
    End,
}

/// A token and its place.
#[derive(Clone, Copy, Debug)]
pub struct Token {
    /// What it is.
    pub sign: Sign,
    /// Where it stands.
    pub span: Span,
}

/// What a language writes.
pub struct Rules {
    /// Its name in messages.
    pub language: &'static str,
    /// Its signs, the longer ones first.
    pub signs: &'static [(&'static str, Sign)],
    /// What other languages write: the characters, the sign that is meant, and how it is written here.
    pub meant: &'static [(&'static str, Sign, &'static str)],
    /// What other languages write for more than one sign.
    pub foreign: &'static [&'static str],
    /// Whether a point and a number belong to the word before them: `I0.0`.
    pub points: bool,
    /// The words after which the rest of the line is a text, in upper case.
    pub titles: &'static [&'static str],
    /// What is told of a comment that is not `//`.
    pub comment: Code,
    /// What is told of a comma in a number.
    pub comma: Code,
}
