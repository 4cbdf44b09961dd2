//! From the bytes of a text to its words.
//!
//! Owns comments, numbers and names; must not know an operator from a name. Of `;` it knows that it ends a
//! declaration between VAR and END_VAR, and begins a comment elsewhere.

use std::collections::HashMap;
use unoclp_text::comments;
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_text::scanner::Scanner;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A name or address: `LD`, `%IX1`, `I0.0`, `T1.Q`, `% IX1`.
    Name,
    /// Digits, perhaps with a point, and letters that stick to them: `20`, `0.00`, `5s`.
    Number,
    /// `T#20s`, `16#FF`.
    Literal,
    Open,
    Close,
    Comma,
    Colon,
    /// `:=`
    Assign,
    /// `=>`
    Arrow,
    /// `=`
    Equals,
    Semicolon,
    /// `&`
    And,
    Minus,
    Plus,
    /// `'text'`, `"text"`
    Text,
    /// A sign of Structured Text, which has a meaning within pieces of it: `[`, `..`, `<`.
    Sign,
    /// The end of a line.
    NewLine,
    /// The end of the text.
    End,
}

/// A token and its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Token {
    pub kind: Kind,
    pub span: Span,
}

/// Words that begin declarations, by the standard; not all of them can be compiled.
pub(crate) const SECTIONS: [&str; 9] = [
    "VAR",
    "VAR_TEMP",
    "VAR_GLOBAL",
    "VAR_INPUT",
    "VAR_OUTPUT",
    "VAR_IN_OUT",
    "VAR_EXTERNAL",
    "VAR_ACCESS",
    "VAR_CONFIG",
];

/// What a text consists of.
pub(crate) struct Words {
    /// A [`Kind::End`] is the last.
    pub tokens: Vec<Token>,
    /// The comments between them, with what begins and ends them.
    pub comments: Vec<Span>,
    /// Of these the ones that `;` begins, without it.
    pub remarks: Vec<Span>,
}

pub(crate) fn words(text: &str, found: &mut Found) -> Words {
    let mut lexer = Lexer {
        scan: Scanner::new(text),
        unclosed: 0,
        nested: comments::nested(text.as_bytes()),
        comments: Vec::new(),
        declares: false,
        remarks: Vec::new(),
        found,
    };
    let mut tokens = Vec::with_capacity(text.len() / 3 + 1);
    while let Some(token) = lexer.next() {
        tokens.push(token);
    }
    let end = Span {
        start: text.len() as u32,
        end: text.len() as u32,
    };
    tokens.push(Token {
        kind: Kind::End,
        span: end,
    });
    let Lexer {
        comments, remarks, ..
    } = lexer;
    Words {
        tokens,
        comments,
        remarks,
    }
}

struct Lexer<'t, 'f> {
    scan: Scanner<'t>,
    /// There is no `*)` from `at` to here.
    unclosed: usize,
    /// Comments that hold others: where they begin, and where they end.
    nested: HashMap<usize, usize>,
    comments: Vec<Span>,
    /// Between VAR and END_VAR.
    declares: bool,
    remarks: Vec<Span>,
    found: &'f mut Found,
}

impl Lexer<'_, '_> {
    fn next(&mut self) -> Option<Token> {
        loop {
            let start = self.scan.at;
            let first = self.scan.first()?;
            self.scan.at += 1;
            let second = self.scan.first();
            let kind = match first {
                b' ' | b'\t' | b'\r' => continue,
                b'\n' => Kind::NewLine,
                b'(' if second == Some(b'*') => {
                    self.comment(start);
                    self.comments.push(self.scan.span(start));
                    continue;
                }
                b'/' if second == Some(b'/') => {
                    self.scan.skip_line();
                    self.comments.push(self.scan.span(start));
                    continue;
                }
                b';' if !self.declares => {
                    self.scan.skip_line();
                    self.comments.push(self.scan.span(start));
                    let remark = self.scan.span(start + 1);
                    self.remarks.push(remark);
                    continue;
                }
                b'(' => Kind::Open,
                b')' => Kind::Close,
                b',' => Kind::Comma,
                b';' => Kind::Semicolon,
                b'&' => Kind::And,
                b'-' => Kind::Minus,
                b'+' => Kind::Plus,
                b':' if second == Some(b'=') => self.two(Kind::Assign),
                b':' => Kind::Colon,
                b'=' if second == Some(b'>') => self.two(Kind::Arrow),
                b'=' => Kind::Equals,
                b'\'' | b'"' if self.quoted(first) => Kind::Text,
                b'[' | b']' | b'<' | b'>' | b'*' | b'/' => Kind::Sign,
                b'.' if second == Some(b'.') => self.two(Kind::Sign),
                b'.' => Kind::Sign,
                b'0'..=b'9' => self.number(),
                // OMRON's #0050.
                b'#' if second.is_some_and(|byte| byte.is_ascii_digit()) => {
                    self.digits();
                    Kind::Literal
                }
                b'%' => {
                    self.scan.skip_while(|byte| matches!(byte, b' ' | b'\t'));
                    if self.scan.word() {
                        self.members();
                        Kind::Name
                    } else {
                        self.scan.at = start + 1;
                        self.stray(start);
                        continue;
                    }
                }
                _ => {
                    self.scan.at = start;
                    if !self.scan.word() {
                        self.scan.skip_character();
                        self.stray(start);
                        continue;
                    }
                    if self.scan.peek(0) == b'#' {
                        self.scan.at += 1;
                        self.literal();
                        Kind::Literal
                    } else {
                        self.members();
                        self.note_section(start);
                        Kind::Name
                    }
                }
            };
            let span = self.scan.span(start);
            return Some(Token { kind, span });
        }
    }

    /// Words that begin and end declarations.
    fn note_section(&mut self, start: usize) {
        let word = self.scan.since(start);
        if word.eq_ignore_ascii_case("TYPE") && self.is_alone(start) {
            self.declares = true;
        } else if word.eq_ignore_ascii_case("END_VAR") || word.eq_ignore_ascii_case("END_TYPE") {
            self.declares = false;
        } else if SECTIONS
            .iter()
            .any(|known| word.eq_ignore_ascii_case(known))
        {
            self.declares = true;
        }
    }

    /// Whether the word that begins here begins its line, and no colon stands after it.
    fn is_alone(&self, start: usize) -> bool {
        let (before, behind) = self.scan.text.split_at(start);
        let before = before.trim_end_matches([' ', '\t']);
        let word = behind.trim_start_matches(|c: char| c.is_ascii_alphabetic());
        (before.is_empty() || before.ends_with('\n')) && !word.trim_start().starts_with(':')
    }

    fn two(&mut self, kind: Kind) -> Kind {
        self.scan.at += 1;
        kind
    }

    /// `.Q`, `.1`, as often as they follow.
    fn members(&mut self) {
        while self.scan.peek(0) == b'.' {
            let point = self.scan.at;
            self.scan.at += 1;
            if !self.scan.word() && !self.digits() {
                self.scan.at = point;
                return;
            }
        }
    }

    fn digits(&mut self) -> bool {
        let start = self.scan.at;
        self.scan
            .skip_while(|byte| matches!(byte, b'0'..=b'9' | b'_'));
        self.scan.at > start
    }

    fn number(&mut self) -> Kind {
        self.digits();
        if self.scan.peek(0) == b'#' {
            self.scan.at += 1;
            self.literal();
            return Kind::Literal;
        }
        if self.scan.peek(0) == b'.' && self.scan.peek(1) != b'.' {
            self.scan.at += 1;
            self.digits();
        }
        self.decimal_comma();
        while self.scan.peek(0).is_ascii_alphanumeric() {
            self.scan.at += 1;
            self.minus_of_exponent();
        }
        Kind::Number
    }

    /// The byte before this one; 0 before the first.
    fn before(&self) -> u8 {
        let before = self.scan.at.checked_sub(1);
        let byte = before.and_then(|at| self.scan.text.as_bytes().get(at));
        byte.copied().unwrap_or(0)
    }

    /// The minus of `1E-3`.
    fn minus_of_exponent(&mut self) {
        let exponent = matches!(self.before(), b'e' | b'E') && self.scan.peek(0) == b'-';
        if exponent && self.scan.peek(1).is_ascii_digit() {
            self.scan.at += 1;
        }
    }

    /// A comma within a time, `1,5s`, belongs to its number: after it stand digits and a unit.
    fn decimal_comma(&mut self) {
        let Some(behind) = self.scan.rest().strip_prefix(',') else {
            return;
        };
        let digits = behind.bytes().take_while(u8::is_ascii_digit).count();
        if digits > 0 && self.scan.peek(1 + digits).is_ascii_alphabetic() {
            self.scan.at += 1 + digits;
        }
    }

    /// A text up to the quote that closes it, where its line has that.
    fn quoted(&mut self, quote: u8) -> bool {
        let rest = self.scan.text.as_bytes().get(self.scan.at..);
        let mut line = rest
            .into_iter()
            .flatten()
            .take_while(|byte| **byte != b'\n');
        let length = line.position(|byte| *byte == quote);
        self.scan.at += length.map_or(0, |length| length + 1);
        length.is_some()
    }

    /// What follows a `#`.
    fn literal(&mut self) {
        if let quote @ (b'\'' | b'"') = self.scan.peek(0) {
            self.scan.at += 1;
            self.quoted(quote);
            return;
        }
        let date = self.is_date();
        if self.scan.peek(0) == b'-' {
            self.scan.at += 1;
        }
        let is_part = |byte: u8| match byte {
            b'-' | b':' => date,
            byte => byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.'),
        };
        while is_part(self.scan.peek(0)) || self.is_typed_radix() {
            self.scan.at += 1;
            self.minus_of_exponent();
            if self.before().is_ascii_digit() {
                self.decimal_comma();
            }
        }
    }

    /// Whether the `#` behind stands after the type of a date or a time of day.
    fn is_date(&self) -> bool {
        let before = self.scan.text.get(..self.scan.at.saturating_sub(1));
        let word = before.and_then(|text| {
            text.rsplit(|c: char| !(c.is_alphanumeric() || c == '_'))
                .next()
        });
        let types = ["D", "DATE", "TOD", "TIME_OF_DAY", "DT", "DATE_AND_TIME"];
        word.is_some_and(|word| types.iter().any(|ty| word.eq_ignore_ascii_case(ty)))
    }

    /// The second `#` of `UINT#16#F`.
    fn is_typed_radix(&self) -> bool {
        self.scan.peek(0) == b'#'
            && self.before().is_ascii_digit()
            && self.scan.peek(1).is_ascii_alphanumeric()
    }

    /// A comment, from after its `(`. It may go over lines. One that the line closes by `* )` is meant to
    /// be closed there: else it would swallow the next instructions without a word.
    fn comment(&mut self, start: usize) {
        if let Some(&end) = self.nested.get(&start) {
            self.scan.at = end;
            return;
        }
        self.scan.at += 1;
        let mut spaced = None;
        while let Some(byte) = self.scan.first() {
            self.scan.at += 1;
            match byte {
                b'*' if self.scan.peek(0) == b')' => {
                    self.scan.at += 1;
                    return;
                }
                b'*' if spaced.is_none() => {
                    let rest = self.scan.text.as_bytes().get(self.scan.at..);
                    let blanks = rest.into_iter().flatten();
                    let blanks = blanks.take_while(|byte| b" \t".contains(byte)).count();
                    if self.scan.peek(blanks) == b')' {
                        let close = (self.scan.at - 1, self.scan.at + blanks + 1);
                        if self.scan.at < self.unclosed {
                            return self.close_spaced(close);
                        }
                        spaced = Some(close);
                    }
                }
                b'\n' => {
                    if let Some(close) = spaced {
                        return self.close_spaced(close);
                    }
                }
                _ => {}
            }
        }
        if let Some(close) = spaced {
            return self.close_spaced(close);
        }
        let open = Span {
            start: start as u32,
            end: start as u32 + 2,
        };
        self.found.tell(Code::CommentOpen, open, []);
    }

    /// Closes a comment at its `* )`; up to here there is no other.
    fn close_spaced(&mut self, (star, end): (usize, usize)) {
        self.unclosed = self.unclosed.max(self.scan.at);
        self.scan.at = end;
        let span = self.scan.span(star);
        self.found.tell(Code::CommentSpaced, span, []);
    }

    fn stray(&mut self, start: usize) {
        let text = self.scan.since(start);
        let span = self.scan.span(start);
        self.found.tell(Code::StrayCharacter, span, [text.into()]);
    }
}
