//! From the bytes of a text to its words, by the signs that a language has.
//!
//! Owns comments, the bounds of numbers, and what other languages write for a sign. Must not know a keyword from a
//! name. Takes time in proportion to the text.

use crate::diagnostics::{Code, Found, Span};

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    /// A keyword or a name.
    Word,
    /// `%IX1`
    Address,
    /// `20`, `16#FF`, `1.5`, and what sticks to it.
    Number,
    /// `'text'`, `"text"`
    Text,
    /// What stands behind a word that takes the rest of its line.
    Title,
    Assign,
    Colon,
    Semicolon,
    Comma,
    Open,
    Close,
    OpenBrace,
    CloseBrace,
    Plus,
    Minus,
    Star,
    Slash,
    And,
    Or,
    Xor,
    Not,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    /// An operator of other languages that stands for more than one here: `+=`, `++`.
    Foreign,
    End,
}

/// A token and its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Token {
    pub sign: Sign,
    pub span: Span,
}

/// What a language writes.
pub(crate) struct Rules {
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
    /// The words behind which the rest of the line is a text, in upper case.
    pub titles: &'static [&'static str],
    /// What is told of a comment that is not `//`.
    pub comment: Code,
    /// What is told of a comma in a number.
    pub comma: Code,
}

pub(crate) fn tokens(text: &str, rules: &Rules, found: &mut Found) -> Vec<Token> {
    let mut lexer = Lexer {
        text,
        bytes: text.as_bytes(),
        at: 0,
        rules,
        titled: false,
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
        sign: Sign::End,
        span: Span { start: end, end },
    });
    tokens
}

struct Lexer<'t, 'f, 'r> {
    text: &'t str,
    bytes: &'t [u8],
    at: usize,
    rules: &'r Rules,
    /// The last word takes the rest of its line.
    titled: bool,
    found: &'f mut Found,
}

impl Lexer<'_, '_, '_> {
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

    fn token(&self, sign: Sign, start: usize) -> Option<Token> {
        Some(Token {
            sign,
            span: self.span(start),
        })
    }

    fn next(&mut self) -> Option<Token> {
        if std::mem::take(&mut self.titled)
            && let Some(token) = self.title()
        {
            return Some(token);
        }
        loop {
            let start = self.at;
            let first = *self.bytes.get(start)?;
            match first {
                b' ' | b'\t' | b'\r' | b'\n' | 0x0C => self.at += 1,
                b'/' if self.peek(1) == b'/' => self.skip_line(),
                b'(' if self.peek(1) == b'*' => self.comment("*)"),
                b'/' if self.peek(1) == b'*' => self.comment("*/"),
                b'0'..=b'9' => {
                    self.number();
                    return self.token(Sign::Number, start);
                }
                b'\'' | b'"' => {
                    self.quoted(first);
                    return self.token(Sign::Text, start);
                }
                b'%' if self.peek(1).is_ascii_alphabetic() => {
                    self.at += 1;
                    while self.peek(0).is_ascii_alphanumeric()
                        || self.peek(0) == b'.' && self.peek(1).is_ascii_digit()
                    {
                        self.at += 1;
                    }
                    return self.token(Sign::Address, start);
                }
                _ if self.word() => {
                    let word = self.text.get(start..self.at).unwrap_or_default();
                    let titles = self.rules.titles;
                    self.titled = titles.iter().any(|title| title.eq_ignore_ascii_case(word));
                    return self.token(Sign::Word, start);
                }
                _ => {
                    if let Some(token) = self.sign() {
                        return Some(token);
                    }
                    self.other(start);
                }
            }
        }
    }

    fn sign(&mut self) -> Option<Token> {
        let (start, rules) = (self.at, self.rules);
        let rest = self.rest();
        let meant = rules.meant.iter().find(|row| rest.starts_with(row.0));
        let foreign = rules.foreign.iter().find(|sign| rest.starts_with(**sign));
        if let Some((written, sign, word)) = meant {
            self.at += written.len();
            let words = [(*written).into(), (*word).into()];
            self.found.tell(Code::StOtherWord, self.span(start), words);
            return self.token(*sign, start);
        }
        if let Some(sign) = foreign {
            self.at += sign.len();
            return self.token(Sign::Foreign, start);
        }
        let (written, sign) = rules.signs.iter().find(|row| rest.starts_with(row.0))?;
        self.at += written.len();
        self.token(*sign, start)
    }

    /// A character that is no part of any word: a space that cannot be told from others, or what means nothing.
    fn other(&mut self, start: usize) {
        let first = self.rest().chars().next();
        self.at += first.map_or(1, char::len_utf8);
        if let Some(sign) = first.filter(|sign| sign.is_ascii()) {
            // `...` is one mistake.
            while self.peek(0) == sign as u8 {
                self.at += 1;
            }
        }
        let text = self.text.get(start..self.at).unwrap_or_default();
        if !text.trim().is_empty() && text != "\u{200B}" {
            let words = [text.into(), self.rules.language.into()];
            self.found.tell(Code::StStray, self.span(start), words);
        }
    }

    fn skip_line(&mut self) {
        while self.at < self.bytes.len() && self.peek(0) != b'\n' {
            self.at += 1;
        }
    }

    /// A comment as other languages write it.
    fn comment(&mut self, end: &str) {
        let start = self.at;
        let behind = self.text.get(start + 2..).unwrap_or_default();
        let opened = Span {
            start: start as u32,
            end: start as u32 + 2,
        };
        match behind.find(end) {
            Some(length) => {
                self.at = start + 2 + length + 2;
                let written = self.text.get(opened.range()).unwrap_or_default();
                let words = [written.into()];
                self.found.tell(self.rules.comment, opened, words);
            }
            None => {
                self.at = self.bytes.len();
                self.found.tell(Code::StCommentOpen, opened, []);
            }
        }
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
        let is = self.at > start;
        if is && self.rules.points && self.peek(0) == b'.' && self.peek(1).is_ascii_digit() {
            self.at += 1;
            self.digits();
        }
        is
    }

    fn digits(&mut self) {
        while self.peek(0).is_ascii_digit() {
            self.at += 1;
        }
    }

    fn number(&mut self) {
        let start = self.at;
        self.digits();
        if self.peek(0) == b'#' {
            self.at += 1;
        } else if self.peek(0) == b'.' {
            self.at += 1;
            self.digits();
        } else if self.peek(0) == b',' && self.peek(1).is_ascii_digit() {
            self.at += 1;
            self.digits();
            let written = self.text.get(start..self.at).unwrap_or_default();
            let words = [written.into(), written.replacen(',', ".", 1).into()];
            self.found.tell(self.rules.comma, self.span(start), words);
            return;
        }
        let exponent = matches!(self.peek(0), b'e' | b'E');
        let signed = usize::from(matches!(self.peek(1), b'+' | b'-'));
        if exponent && self.peek(1 + signed).is_ascii_digit() {
            self.at += 1 + signed;
        }
        // What sticks to it belongs to it: 5s.
        while self.peek(0).is_ascii_alphanumeric() || self.peek(0) == b'_' {
            self.at += 1;
        }
    }

    /// A text. It ends on its line.
    fn quoted(&mut self, quote: u8) {
        let start = self.at;
        self.at += 1;
        while !matches!(self.peek(0), b'\n' | 0) {
            self.at += 1;
            if self.bytes.get(self.at - 1) == Some(&quote) {
                return;
            }
        }
        let sign = if quote == b'"' { "\"" } else { "'" };
        let span = Span {
            start: start as u32,
            end: start as u32 + 1,
        };
        self.found.tell(Code::StTextOpen, span, [sign.into()]);
    }

    /// What stands behind `rede` on its line: between quotes, or up to a `;`, a comment or its end.
    fn title(&mut self) -> Option<Token> {
        while matches!(self.peek(0), b' ' | b'\t') {
            self.at += 1;
        }
        let start = self.at;
        if matches!(self.peek(0), b'"' | b'\'') {
            self.quoted(self.peek(0));
            return self.token(Sign::Title, start);
        }
        let line = self.rest().split('\n').next().unwrap_or_default();
        let line = line.split(';').next().unwrap_or_default();
        let title = line.split("//").next().unwrap_or_default().trim_end();
        self.at += title.len();
        self.token(Sign::Title, start).filter(|_| self.at > start)
    }
}
