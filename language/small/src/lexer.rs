//! From the bytes of a text to its words, by the signs that a language has.
//!
//! Owns comments, the bounds of numbers, and what other languages write for a sign. Must not know a keyword from a
//! name. Takes time in proportion to the text.

use super::rules::{Rules, Sign, Token};
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_text::scanner::{Scanner, is_space, shown};

pub fn tokens(text: &str, rules: &Rules, found: &mut Found) -> Vec<Token> {
    let mut lexer = Lexer {
        scan: Scanner::new(text),
        rules,
        titled: false,
        found,
    };
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
    scan: Scanner<'t>,
    rules: &'r Rules,
    /// The last word takes the rest of its line.
    titled: bool,
    found: &'f mut Found,
}

impl Lexer<'_, '_, '_> {
    fn token(&self, sign: Sign, start: usize) -> Option<Token> {
        Some(Token {
            sign,
            span: self.scan.span(start),
        })
    }

    fn next(&mut self) -> Option<Token> {
        if std::mem::take(&mut self.titled)
            && let Some(token) = self.title()
        {
            return Some(token);
        }
        loop {
            let start = self.scan.at;
            let first = self.scan.first()?;
            match first {
                b' ' | b'\t' | b'\r' | b'\n' | 0x0C => self.scan.at += 1,
                b'/' if self.scan.peek(1) == b'/' => self.scan.skip_line(),
                b'(' if self.scan.peek(1) == b'*' => self.comment("*)"),
                b'/' if self.scan.peek(1) == b'*' => self.comment("*/"),
                b'0'..=b'9' => {
                    self.number();
                    return self.token(Sign::Number, start);
                }
                b'\'' | b'"' => {
                    self.quoted(first);
                    return self.token(Sign::Text, start);
                }
                b'%' if self.scan.peek(1).is_ascii_alphabetic() => {
                    self.scan.at += 1;
                    self.scan.address();
                    return self.token(Sign::Address, start);
                }
                _ if self.word() => {
                    let word = self.scan.since(start);
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
        let (start, rules) = (self.scan.at, self.rules);
        let rest = self.scan.rest();
        let meant = rules.meant.iter().find(|row| rest.starts_with(row.0));
        let foreign = rules.foreign.iter().find(|sign| rest.starts_with(**sign));
        if let Some((written, sign, word)) = meant {
            self.scan.at += written.len();
            let words = [(*written).into(), (*word).into()];
            self.found
                .tell(Code::StOtherWord, self.scan.span(start), words);
            return self.token(*sign, start);
        }
        if let Some(sign) = foreign {
            self.scan.at += sign.len();
            return self.token(Sign::Foreign, start);
        }
        let (written, sign) = rules.signs.iter().find(|row| rest.starts_with(row.0))?;
        self.scan.at += written.len();
        self.token(*sign, start)
    }

    /// A character that is no part of any word: a space that cannot be told from others, or what means nothing.
    fn other(&mut self, start: usize) {
        let first = self.scan.skip_character();
        if let Some(sign) = first.filter(|sign| sign.is_ascii()) {
            // `...` is one mistake.
            self.scan.skip_while(|byte| byte == sign as u8);
        }
        if !first.is_some_and(is_space) {
            let text = shown(self.scan.since(start));
            let words = [text.into(), self.rules.language.into()];
            self.found.tell(Code::StStray, self.scan.span(start), words);
        }
    }

    /// A comment as other languages write it.
    fn comment(&mut self, end: &str) {
        let start = self.scan.at;
        let behind = self.scan.text.get(start + 2..).unwrap_or_default();
        let opened = Span {
            start: start as u32,
            end: start as u32 + 2,
        };
        match behind.find(end) {
            Some(length) => {
                self.scan.at = start + 2 + length + 2;
                let written = self.scan.text.get(opened.range()).unwrap_or_default();
                let words = [written.into()];
                self.found.tell(self.rules.comment, opened, words);
            }
            None => {
                self.scan.at = self.scan.text.len();
                self.found.tell(Code::StCommentOpen, opened, []);
            }
        }
    }

    /// A word, and the point and the number that belong to it where the language has points.
    fn word(&mut self) -> bool {
        let is = self.scan.word();
        if is
            && self.rules.points
            && self.scan.peek(0) == b'.'
            && self.scan.peek(1).is_ascii_digit()
        {
            self.scan.at += 1;
            self.digits();
        }
        is
    }

    fn digits(&mut self) {
        self.scan.skip_while(|byte| byte.is_ascii_digit());
    }

    fn number(&mut self) {
        let start = self.scan.at;
        self.digits();
        if self.scan.peek(0) == b'#' {
            self.scan.at += 1;
        } else if self.scan.peek(0) == b'.' {
            self.scan.at += 1;
            self.digits();
        } else if self.scan.peek(0) == b',' && self.scan.peek(1).is_ascii_digit() {
            self.scan.at += 1;
            self.digits();
            let written = self.scan.since(start);
            let words = [written.into(), written.replacen(',', ".", 1).into()];
            self.found
                .tell(self.rules.comma, self.scan.span(start), words);
            return;
        }
        let exponent = matches!(self.scan.peek(0), b'e' | b'E');
        let signed = usize::from(matches!(self.scan.peek(1), b'+' | b'-'));
        if exponent && self.scan.peek(1 + signed).is_ascii_digit() {
            self.scan.at += 1 + signed;
        }
        // What sticks to it belongs to it: 5s.
        self.scan
            .skip_while(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    }

    /// A text. It ends on its line.
    fn quoted(&mut self, quote: u8) {
        let start = self.scan.at;
        self.scan.at += 1;
        while !matches!(self.scan.peek(0), b'\n' | 0) {
            self.scan.at += 1;
            if self.scan.since(start + 1).as_bytes().last() == Some(&quote) {
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

    /// What stands after `rede` on its line: between quotes, or up to a `;`, a comment or its end.
    fn title(&mut self) -> Option<Token> {
        self.scan.skip_while(|byte| matches!(byte, b' ' | b'\t'));
        let start = self.scan.at;
        if matches!(self.scan.peek(0), b'"' | b'\'') {
            self.quoted(self.scan.peek(0));
            return self.token(Sign::Title, start);
        }
        let line = self.scan.rest().split('\n').next().unwrap_or_default();
        let line = line.split(';').next().unwrap_or_default();
        let title = line.split("//").next().unwrap_or_default().trim_end();
        self.scan.at += title.len();
        self.token(Sign::Title, start)
            .filter(|_| self.scan.at > start)
    }
}
