//! Where the literals of Structured Text end.
//!
//! Must not know what they are worth.

use super::lexer::Lexer;
use unoclp_text::diagnostics::{Code, Span};

impl Lexer<'_, '_> {
    fn digits(&mut self, also: fn(u8) -> bool) {
        self.scan
            .skip_while(|byte| byte.is_ascii_digit() || byte == b'_' || also(byte));
    }

    pub(super) fn number(&mut self) {
        self.digits(|_| false);
        if self.scan.peek(0) == b'#' {
            self.scan.at += 1;
            self.digits(|byte| byte.is_ascii_alphanumeric());
            return;
        }
        if self.scan.peek(0) == b'.' && self.scan.peek(1).is_ascii_digit() {
            self.scan.at += 1;
            self.digits(|_| false);
        }
        if matches!(self.scan.peek(0), b'e' | b'E') {
            let signed = usize::from(matches!(self.scan.peek(1), b'+' | b'-'));
            if self.scan.peek(1 + signed).is_ascii_digit() {
                self.scan.at += 1 + signed;
                self.digits(|_| false);
            }
        }
        // What sticks to it belongs to it: 5s.
        self.digits(|byte| byte.is_ascii_alphabetic());
    }

    /// `T# 5s`, as some write it.
    fn blanks(&mut self) {
        let rest = self.scan.rest().as_bytes();
        let blanks = rest.iter().take_while(|byte| b" \t".contains(byte)).count();
        if rest.get(blanks).is_some_and(u8::is_ascii_digit) {
            self.scan.at += blanks;
        }
    }

    /// After `T#`, `INT#`, `Color#`.
    pub(super) fn typed(&mut self, start: usize) {
        let prefix = self.scan.since(start).trim_end_matches('#');
        let prefix = prefix.to_ascii_uppercase();
        if matches!(prefix.as_str(), "T" | "TIME") {
            self.blanks();
        }
        if matches!(self.scan.peek(0), b'-' | b'+') {
            self.scan.at += 1;
        }
        match prefix.as_str() {
            "T" | "TIME" | "LTIME" => {
                self.digits(|byte| byte.is_ascii_alphanumeric() || byte == b'.')
            }
            "D" | "DATE" => self.digits(|byte| byte == b'-'),
            "TOD" | "TIME_OF_DAY" => self.digits(|byte| matches!(byte, b':' | b'.')),
            "DT" | "DATE_AND_TIME" => self.digits(|byte| matches!(byte, b'-' | b':' | b'.')),
            "STRING" if self.scan.peek(0) == b'\'' => self.quoted(b'\''),
            "WSTRING" if self.scan.peek(0) == b'"' => self.quoted(b'"'),
            _ if self.scan.peek(0).is_ascii_digit() => self.number(),
            _ => {
                self.scan.word();
            }
        }
    }

    /// A text, with `$` before what would end it. It ends on its line.
    pub(super) fn quoted(&mut self, quote: u8) {
        let start = self.scan.at;
        self.scan.at += 1;
        loop {
            match self.scan.peek(0) {
                b'$' if self.scan.peek(1) != b'\n' => {
                    self.scan.at = (self.scan.at + 2).min(self.scan.text.len())
                }
                byte if byte == quote => {
                    self.scan.at += 1;
                    return;
                }
                b'\n' | 0 => break,
                _ => self.scan.at += 1,
            }
        }
        // To the next bound of characters.
        while !self.scan.text.is_char_boundary(self.scan.at) {
            self.scan.at += 1;
        }
        let span = Span {
            start: start as u32,
            end: start as u32 + 1,
        };
        let sign = if quote == b'"' { "\"" } else { "'" };
        self.found.tell(Code::StTextOpen, span, [sign.into()]);
    }
}
