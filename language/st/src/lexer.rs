//! From the bytes of a text to its words: Structured Text, and SCL's `#name` and `"name"`.
//!
//! Owns which word begins with what; where comments and literals end, `comments` and `bounds` know. Must not know a
//! keyword from a name. Takes time in proportion to the text.

use super::token::{Dialect, FOREIGN, Kind, MEANT, PLAIN, Token};
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_text::scanner::{Scanner, is_space, shown};

/// The words of a text from this byte on.
pub(crate) fn tokens(text: &str, from: usize, dialect: Dialect, found: &mut Found) -> Vec<Token> {
    let mut scan = Scanner::new(text);
    scan.at = scan.at.max(from);
    let mut lexer = Lexer {
        scan,
        flat: false,
        scl: dialect == Dialect::Scl,
        list: dialect == Dialect::Il,
        behind: 0,
        found,
    };
    let mut tokens = Vec::with_capacity(text.len().saturating_sub(from) / 4 + 1);
    while let Some(token) = lexer.next() {
        lexer.behind = lexer.scan.at;
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

pub(super) struct Lexer<'t, 'f> {
    pub scan: Scanner<'t>,
    /// A comment was found open with its inner ones counted: from there on they do not nest.
    pub flat: bool,
    scl: bool,
    list: bool,
    /// Where the last token ended.
    pub behind: usize,
    pub found: &'f mut Found,
}

impl Lexer<'_, '_> {
    fn token(&self, kind: Kind, start: usize) -> Option<Token> {
        Some(Token {
            kind,
            span: self.scan.span(start),
            meant: None,
        })
    }

    fn next(&mut self) -> Option<Token> {
        loop {
            let start = self.scan.at;
            let first = self.scan.first()?;
            match first {
                b' ' | b'\t' | b'\r' | b'\n' | 0x0C => self.scan.at += 1,
                b'(' if self.scan.peek(1) == b'*' => self.comment(),
                b'/' if self.scan.peek(1) == b'/' => self.scan.skip_line(),
                b'/' if self.scan.peek(1) == b'*' => self.slashed(),
                b'{' if self.scan.peek(1) == b'{' => {
                    self.foreign_code();
                    return self.token(Kind::ForeignCode, start);
                }
                b'{' if self.is_pragma() => {}
                b'{' if self.code_in_braces() => return self.token(Kind::ForeignCode, start),
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
                    self.scan.at += 1;
                    if self.scan.peek(0) == b'"' {
                        self.quoted(b'"');
                        return self.inner(start + 1);
                    }
                    if self.scan.word() {
                        return self.token(Kind::Word, start + 1);
                    }
                    self.stray(start);
                }
                b'%' => {
                    self.scan.at += 1;
                    // `% IX1`, as some books space it.
                    let blanks = self.scan.rest().bytes().take_while(|b| b" \t".contains(b));
                    let blanks = blanks.count();
                    if self.list && self.scan.peek(blanks).is_ascii_alphabetic() {
                        self.scan.at += blanks;
                    }
                    if self.scan.peek(0).is_ascii_alphabetic() {
                        self.scan.address();
                        return self.token(Kind::Address, start);
                    }
                    return self.meant(start, Kind::Word, "MOD");
                }
                _ if self.scan.word() => {
                    if self.scan.peek(0) == b'#' {
                        self.scan.at += 1;
                        self.typed(start);
                        return self.token(Kind::Typed, start);
                    }
                    return self.token(Kind::Word, start);
                }
                _ => {
                    if let Some(token) = self.operator() {
                        return Some(token);
                    }
                    // A space that cannot be told from others, as pasted text has it, is one.
                    let character = self.scan.skip_character();
                    if !character.is_some_and(is_space) {
                        self.stray(start);
                    }
                }
            }
        }
    }

    fn operator(&mut self) -> Option<Token> {
        let start = self.scan.at;
        let rest = self.scan.rest();
        let meant = MEANT.iter().find(|row| rest.starts_with(row.0));
        let foreign = FOREIGN.iter().find(|sign| rest.starts_with(**sign));
        // `--` and `++` are two signs where a number follows: 3--2.
        let foreign = foreign.filter(|sign| {
            let behind = rest.as_bytes().get(2).copied().unwrap_or(0);
            !(matches!(**sign, "--" | "++") && (behind.is_ascii_alphanumeric() || behind == b'('))
        });
        if let Some((sign, kind, word)) = meant {
            self.scan.at += sign.len();
            return self.meant(start, *kind, word);
        }
        if let Some(sign) = foreign {
            self.scan.at += sign.len();
            return self.token(Kind::Foreign, start);
        }
        let (sign, kind) = PLAIN.iter().find(|row| rest.starts_with(row.0))?;
        self.scan.at += sign.len();
        self.token(*kind, start)
    }

    fn meant(&mut self, start: usize, kind: Kind, word: &'static str) -> Option<Token> {
        if self.scan.at == start {
            self.scan.at += 1;
        }
        let span = self.scan.span(start);
        let written = self.scan.since(start);
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
        let closed = self.scan.at > start + 1 && self.scan.since(start).ends_with('"');
        Some(Token {
            kind: Kind::Word,
            span: Span {
                start: start as u32 + 1,
                end: (self.scan.at - usize::from(closed)).max(start + 1) as u32,
            },
            meant: None,
        })
    }

    fn stray(&mut self, start: usize) {
        let span = self.scan.span(start);
        let text = shown(self.scan.since(start));
        let language = ("Structured Text", "Texto Estruturado");
        self.found
            .tell(Code::StStray, span, [text.into(), language.into()]);
    }
}
