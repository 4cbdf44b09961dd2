//! From the bytes of a text to its words.
//!
//! Owns where a word ends. Must not know a keyword from a name.

use unoclp_text::diagnostics::Span;
use unoclp_text::scanner::Scanner;

/// What a word is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Name,
    Number,
    Open,
    Close,
    LineEnd,
    /// What means nothing.
    Stray,
}

/// A word, and where it stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Word {
    pub kind: Kind,
    pub span: Span,
}

impl Word {
    /// As it is written.
    pub(crate) fn of(self, text: &str) -> &str {
        text.get(self.span.range()).unwrap_or_default()
    }
}

/// The words of a text; the last one ends a line.
pub(crate) fn words(text: &str) -> Vec<Word> {
    let mut scan = Scanner::new(text);
    let mut words = Vec::new();
    while let Some(first) = scan.first() {
        let start = scan.at;
        let kind = match first {
            b' ' | b'\t' | b'\r' => {
                scan.at += 1;
                continue;
            }
            b'/' if scan.peek(1) == b'/' => {
                scan.skip_line();
                continue;
            }
            b'0'..=b'9' => {
                scan.skip_while(|byte| byte.is_ascii_digit());
                Kind::Number
            }
            _ if scan.word() => Kind::Name,
            sign => {
                scan.skip_character();
                match sign {
                    b'(' => Kind::Open,
                    b')' => Kind::Close,
                    b'\n' => Kind::LineEnd,
                    _ => Kind::Stray,
                }
            }
        };
        let span = scan.span(start);
        words.push(Word { kind, span });
    }
    let span = scan.span(text.len());
    let kind = Kind::LineEnd;
    words.push(Word { kind, span });
    words
}
