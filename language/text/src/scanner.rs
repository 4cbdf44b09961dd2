//! A text from its first byte to its last, for lexers.
//!
//! Owns what all languages have in common: where a word, a point's address and a line end. Must not know tokens.

use crate::diagnostics::Span;

/// A place in a text.
pub struct Scanner<'t> {
    /// All of it.
    pub text: &'t str,
    /// The next byte; what is after it is never the middle of a character that a method has skipped.
    pub at: usize,
}

impl<'t> Scanner<'t> {
    /// At the beginning of a text, after the mark of its bytes' order.
    pub fn new(text: &'t str) -> Scanner<'t> {
        let mark = '\u{FEFF}';
        let at = if text.starts_with(mark) {
            mark.len_utf8()
        } else {
            0
        };
        Scanner { text, at }
    }

    /// The next byte, if there is one.
    pub fn first(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// A byte from here on; 0 after the end.
    pub fn peek(&self, ahead: usize) -> u8 {
        let byte = self.text.as_bytes().get(self.at + ahead);
        byte.copied().unwrap_or(0)
    }

    /// Whether nothing comes any more.
    pub fn is_at_end(&self) -> bool {
        self.at >= self.text.len()
    }

    /// The text from here on.
    pub fn rest(&self) -> &'t str {
        self.text.get(self.at..).unwrap_or_default()
    }

    /// From there to here.
    pub fn span(&self, start: usize) -> Span {
        Span {
            start: start as u32,
            end: self.at as u32,
        }
    }

    /// The text from there to here.
    pub fn since(&self, start: usize) -> &'t str {
        self.text.get(start..self.at).unwrap_or_default()
    }

    /// Skips these bytes, which are of ASCII.
    pub fn skip_while(&mut self, is: impl Fn(u8) -> bool) {
        while !self.is_at_end() && is(self.peek(0)) {
            self.at += 1;
        }
    }

    /// To the end of the line.
    pub fn skip_line(&mut self) {
        let line = self.rest().find('\n').unwrap_or(self.rest().len());
        self.at += line;
    }

    /// Over one character.
    pub fn skip_character(&mut self) -> Option<char> {
        let character = self.rest().chars().next()?;
        self.at += character.len_utf8();
        Some(character)
    }

    /// Letters, digits and underscores, the first no digit; whether there is such a word.
    pub fn word(&mut self) -> bool {
        let start = self.at;
        while let Some(byte) = self.first() {
            match byte {
                b'A'..=b'Z' | b'a'..=b'z' | b'_' => self.at += 1,
                b'0'..=b'9' if self.at > start => self.at += 1,
                0x80.. => {
                    let letter = self.rest().chars().next();
                    // A Greek question mark looks like `;`.
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

    /// What follows the `%` of a point's address: letters, digits, and points before digits.
    pub fn address(&mut self) {
        while self.peek(0).is_ascii_alphanumeric()
            || self.peek(0) == b'.' && self.peek(1).is_ascii_digit()
        {
            self.at += 1;
        }
    }
}

/// Whether a character is a space, though it may not look like one.
pub fn is_space(character: char) -> bool {
    character.is_whitespace() || character == '\u{200B}'
}

/// A character that means nothing, as a message names it: one that cannot be seen by its number.
pub fn shown(written: &str) -> String {
    match written.chars().next() {
        Some(first) if first.is_control() => format!("U+{:04X}", first as u32),
        _ => written.to_owned(),
    }
}
