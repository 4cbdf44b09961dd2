//! From the bytes of a text to its words: Structured Text, and SCL's `#name` and `"name"`.
//!
//! Owns comments, the bounds of literals, and what other languages write for an operator. Must not know a keyword
//! from a name. Takes time in proportion to the text.

use super::Dialect;
use super::words::Keyword;
use crate::diagnostics::{Code, Found, Span};

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

pub(crate) fn tokens(text: &str, dialect: Dialect, found: &mut Found) -> Vec<Token> {
    let mut lexer = Lexer {
        text,
        bytes: text.as_bytes(),
        at: 0,
        flat: false,
        scl: dialect == Dialect::Scl,
        remarks: dialect == Dialect::Il,
        list: dialect == Dialect::Il,
        found,
    };
    if text.starts_with('\u{FEFF}') {
        lexer.at = '\u{FEFF}'.len_utf8();
    }
    let mut tokens = Vec::with_capacity(text.len() / 4 + 1);
    while let Some(token) = lexer.next() {
        tokens.push(token);
    }
    let end = text.len() as u32;
    tokens.push(Token {
        kind: Kind::End,
        span: Span { start: end, end },
        meant: None,
    });
    tokens
}

/// What other languages write: the characters, the token that is meant, and how it is written here.
const MEANT: [(&str, Kind, &str); 14] = [
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

const FOREIGN: [&str; 8] = ["+=", "-=", "*=", "/=", "++", "--", "{", "}"];

const PLAIN: [(&str, Kind); 27] = [
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

struct Lexer<'t, 'f> {
    text: &'t str,
    bytes: &'t [u8],
    at: usize,
    /// A comment was found open with its inner ones counted: from there on they do not nest.
    flat: bool,
    scl: bool,
    /// `;` begins a comment, but for where declarations stand.
    remarks: bool,
    list: bool,
    found: &'f mut Found,
}

impl Lexer<'_, '_> {
    fn peek(&self, ahead: usize) -> u8 {
        self.bytes.get(self.at + ahead).copied().unwrap_or(0)
    }

    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn span(&self, start: usize) -> Span {
        Span {
            start: start as u32,
            end: self.at as u32,
        }
    }

    fn token(&self, kind: Kind, start: usize) -> Option<Token> {
        Some(Token {
            kind,
            span: self.span(start),
            meant: None,
        })
    }

    fn next(&mut self) -> Option<Token> {
        loop {
            let start = self.at;
            let first = *self.bytes.get(start)?;
            match first {
                b' ' | b'\t' | b'\r' | b'\n' | 0x0C => self.at += 1,
                b'(' if self.peek(1) == b'*' => self.comment(),
                b'/' if self.peek(1) == b'/' => self.skip_line(),
                b'/' if self.peek(1) == b'*' => self.slashed(),
                b';' if self.remarks => self.skip_line(),
                b'{' if self.is_pragma() => {}
                b'0'..=b'9' => {
                    self.number();
                    return self.token(Kind::Number, start);
                }
                b'\'' => {
                    self.quoted(b'\'');
                    return self.token(Kind::Text, start);
                }
                b'"' => {
                    self.quoted(b'"');
                    return match self.scl {
                        true => self.inner(start),
                        false => self.token(Kind::Wide, start),
                    };
                }
                b'#' if self.scl => {
                    self.at += 1;
                    if self.peek(0) == b'"' {
                        self.quoted(b'"');
                        return self.inner(start + 1);
                    }
                    if self.word() {
                        return self.token(Kind::Word, start + 1);
                    }
                    self.stray(start);
                }
                b'%' => {
                    self.at += 1;
                    if self.peek(0).is_ascii_alphabetic() {
                        while self.peek(0).is_ascii_alphanumeric()
                            || self.peek(0) == b'.' && self.peek(1).is_ascii_digit()
                        {
                            self.at += 1;
                        }
                        return self.token(Kind::Address, start);
                    }
                    return self.meant(start, Kind::Word, "MOD");
                }
                _ if self.word() => {
                    if self.peek(0) == b'#' {
                        self.at += 1;
                        self.typed(start);
                        return self.token(Kind::Typed, start);
                    }
                    self.note_section(start);
                    return self.token(Kind::Word, start);
                }
                _ => {
                    if let Some(token) = self.operator() {
                        return Some(token);
                    }
                    let width = self.rest().chars().next().map_or(1, char::len_utf8);
                    self.at += width;
                    // A space that cannot be told from others, as pasted text has it.
                    let space = self
                        .text
                        .get(start..self.at)
                        .is_some_and(|c| c.trim().is_empty() || c == "\u{200B}");
                    if !space {
                        self.stray(start);
                    }
                }
            }
        }
    }

    /// Words that begin and end declarations, in Instruction List.
    fn note_section(&mut self, start: usize) {
        if !self.list {
            return;
        }
        let word = self.text.get(start..self.at).unwrap_or_default();
        match Keyword::of(word) {
            Keyword::EndVar | Keyword::EndType => self.remarks = true,
            Keyword::Type => self.remarks = false,
            keyword if keyword.is_section() => self.remarks = false,
            _ => {}
        }
    }

    fn operator(&mut self) -> Option<Token> {
        let start = self.at;
        let rest = self.rest();
        let meant = MEANT.iter().find(|row| rest.starts_with(row.0));
        let foreign = FOREIGN.iter().find(|sign| rest.starts_with(**sign));
        // `--` and `++` are two signs where a number follows: 3--2.
        let foreign = foreign.filter(|sign| {
            let behind = rest.as_bytes().get(2).copied().unwrap_or(0);
            !(matches!(**sign, "--" | "++") && (behind.is_ascii_alphanumeric() || behind == b'('))
        });
        if let Some((sign, kind, word)) = meant {
            self.at += sign.len();
            return self.meant(start, *kind, word);
        }
        if let Some(sign) = foreign {
            self.at += sign.len();
            return self.token(Kind::Foreign, start);
        }
        let (sign, kind) = PLAIN.iter().find(|row| rest.starts_with(row.0))?;
        self.at += sign.len();
        self.token(*kind, start)
    }

    fn meant(&mut self, start: usize, kind: Kind, word: &'static str) -> Option<Token> {
        if self.at == start {
            self.at += 1;
        }
        let span = self.span(start);
        let written = self.text.get(span.range()).unwrap_or_default();
        self.found
            .tell(Code::StOtherWord, span, [written.into(), word.into()]);
        Some(Token {
            kind,
            span,
            meant: Some(word),
        })
    }

    /// What stands between the quotes of a SCL name.
    fn inner(&self, start: usize) -> Option<Token> {
        let closed = self.at > start + 1 && self.bytes.get(self.at - 1) == Some(&b'"');
        Some(Token {
            kind: Kind::Word,
            span: Span {
                start: start as u32 + 1,
                end: (self.at - usize::from(closed)).max(start + 1) as u32,
            },
            meant: None,
        })
    }

    fn skip_line(&mut self) {
        while self.at < self.bytes.len() && self.peek(0) != b'\n' {
            self.at += 1;
        }
    }

    /// `(* … *)`, which may hold others; where that leaves one open to the end of the text, they do not count.
    fn comment(&mut self) {
        let start = self.at;
        let (mut depth, mut first) = (0_usize, None);
        while self.at < self.bytes.len() {
            match (self.peek(0), self.peek(1)) {
                (b'(', b'*') => {
                    depth += usize::from(!self.flat || depth == 0);
                    self.at += 2;
                }
                (b'*', b')') => {
                    self.at += 2;
                    depth -= 1;
                    first = first.or(Some(self.at));
                    if depth == 0 {
                        return;
                    }
                }
                _ => self.at += 1,
            }
        }
        match first {
            Some(end) => {
                self.flat = true;
                self.at = end;
            }
            None => self.told_open(start, 2),
        }
    }

    /// `/* … */`
    fn slashed(&mut self) {
        let start = self.at;
        self.at += 2;
        while self.at < self.bytes.len() {
            if (self.peek(0), self.peek(1)) == (b'*', b'/') {
                self.at += 2;
                return;
            }
            self.at += 1;
        }
        self.told_open(start, 2);
    }

    fn told_open(&mut self, start: usize, width: usize) {
        let span = Span {
            start: start as u32,
            end: (start + width) as u32,
        };
        self.found.tell(Code::StCommentOpen, span, []);
    }

    /// Skips `{attribute 'x'}`, `{ S7_Optimized_Access := 'TRUE' }`: braces on one line that begin with such a word.
    fn is_pragma(&mut self) -> bool {
        let line = self.bytes.get(self.at..).unwrap_or_default();
        let line = line.iter().take(400).take_while(|byte| **byte != b'\n');
        let Some(end) = line.into_iter().position(|byte| *byte == b'}') else {
            return false;
        };
        let words = self.rest().get(1..end).unwrap_or_default().trim_start();
        let known = [
            "attribute",
            "region",
            "endregion",
            "warning",
            "info",
            "text",
            "S7_",
            "InstructionName",
            "LibVersion",
            "Extern",
            "EXTERNAL",
        ];
        let is = known.iter().any(|word| words.starts_with(word));
        if is {
            self.at += end + 1;
        }
        is
    }

    /// Letters, digits and underscores, the first no digit.
    fn word(&mut self) -> bool {
        let start = self.at;
        while let Some(&byte) = self.bytes.get(self.at) {
            match byte {
                b'A'..=b'Z' | b'a'..=b'z' | b'_' => self.at += 1,
                b'0'..=b'9' if self.at > start => self.at += 1,
                0x80.. => {
                    let letter = self.rest().chars().next();
                    let Some(letter) = letter.filter(|c| c.is_alphabetic() && *c != '\u{37e}')
                    else {
                        break;
                    };
                    self.at += letter.len_utf8();
                }
                _ => break,
            }
        }
        self.at > start
    }

    fn digits(&mut self, also: fn(u8) -> bool) {
        while self.peek(0).is_ascii_digit() || self.peek(0) == b'_' || also(self.peek(0)) {
            self.at += 1;
        }
    }

    fn number(&mut self) {
        self.digits(|_| false);
        if self.peek(0) == b'#' {
            self.at += 1;
            self.digits(|byte| byte.is_ascii_alphanumeric());
            return;
        }
        if self.peek(0) == b'.' && self.peek(1).is_ascii_digit() {
            self.at += 1;
            self.digits(|_| false);
        }
        if matches!(self.peek(0), b'e' | b'E') {
            let signed = usize::from(matches!(self.peek(1), b'+' | b'-'));
            if self.peek(1 + signed).is_ascii_digit() {
                self.at += 1 + signed;
                self.digits(|_| false);
            }
        }
        // What sticks to it belongs to it: 5s.
        self.digits(|byte| byte.is_ascii_alphabetic());
    }

    /// Behind `T#`, `INT#`, `Color#`.
    fn typed(&mut self, start: usize) {
        let prefix = self.text.get(start..self.at - 1).unwrap_or_default();
        let prefix = prefix.to_ascii_uppercase();
        if matches!(self.peek(0), b'-' | b'+') {
            self.at += 1;
        }
        match prefix.as_str() {
            "T" | "TIME" | "LTIME" => {
                self.digits(|byte| byte.is_ascii_alphanumeric() || byte == b'.')
            }
            "D" | "DATE" => self.digits(|byte| byte == b'-'),
            "TOD" | "TIME_OF_DAY" => self.digits(|byte| matches!(byte, b':' | b'.')),
            "DT" | "DATE_AND_TIME" => self.digits(|byte| matches!(byte, b'-' | b':' | b'.')),
            "STRING" if self.peek(0) == b'\'' => self.quoted(b'\''),
            "WSTRING" if self.peek(0) == b'"' => self.quoted(b'"'),
            _ if self.peek(0).is_ascii_digit() => self.number(),
            _ => {
                self.word();
            }
        }
    }

    /// A text, with `$` before what would end it. It ends on its line.
    fn quoted(&mut self, quote: u8) {
        let start = self.at;
        self.at += 1;
        loop {
            match self.peek(0) {
                b'$' if self.peek(1) != b'\n' => self.at = (self.at + 2).min(self.bytes.len()),
                byte if byte == quote => {
                    self.at += 1;
                    return;
                }
                b'\n' | 0 => break,
                _ => self.at += 1,
            }
        }
        // To the next bound of characters.
        while !self.text.is_char_boundary(self.at) {
            self.at += 1;
        }
        let span = Span {
            start: start as u32,
            end: start as u32 + 1,
        };
        let sign = if quote == b'"' { "\"" } else { "'" };
        self.found.tell(Code::StTextOpen, span, [sign.into()]);
    }

    fn stray(&mut self, start: usize) {
        let span = self.span(start);
        let text = self.text.get(span.range()).unwrap_or_default();
        let language = ("Structured Text", "Texto Estruturado");
        self.found
            .tell(Code::StStray, span, [text.into(), language.into()]);
    }
}
