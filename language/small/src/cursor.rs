//! Where a parser stands in the words of a text, and what it tells is missing there.
//!
//! Owns the way forward and how deep it goes. Must not know which words a language has: it takes them as they come.

use super::lexer::tokens;
use super::rules::{Rules, Sign, Token};
use unoclp_text::diagnostics::{Code, Found, Span, Word};
use unoclp_text::near::nearest;

/// Statements and parentheses nest no deeper.
const MOST_OPEN: u32 = 200;
/// No part of an expression stands deeper in it.
const MOST_HIGH: u32 = 300;

/// What was not there has been told.
#[derive(Debug)]
pub struct Told;

/// What is read; told, where it is not there.
pub type Parsed<T> = Result<T, Told>;

/// A name and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// As it is written.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// The keywords of a language.
pub trait Keywords: Copy + PartialEq + 'static {
    /// No keyword.
    const NONE: Self;

    /// How each is written; of several ways the first is its name.
    const WORDS: &'static [(&'static str, Self)];

    /// How other languages write them.
    const MEANT: &'static [(&'static str, Self)];

    /// The keyword that is written so.
    fn of(word: &str) -> Self {
        named(Self::WORDS, word)
    }

    /// The keyword that other languages write so.
    fn meant(word: &str) -> Self {
        named(Self::MEANT, word)
    }

    /// As it is written.
    fn name(self) -> &'static str {
        let mut words = Self::WORDS.iter().filter(|row| row.1 == self);
        words.next().map_or("", |row| row.0)
    }
}

/// What a table has for a word, in whatever case it is written.
pub fn named<K: Keywords>(table: &[(&str, K)], word: &str) -> K {
    let row = table.iter().find(|row| row.0.eq_ignore_ascii_case(word));
    row.map_or(K::NONE, |row| row.1)
}

/// Where a parser stands.
pub struct Cursor<'t, 'f, K> {
    /// The text.
    pub text: &'t str,
    tokens: Vec<Token>,
    keywords: Vec<K>,
    at: usize,
    /// How many parentheses and statements are open.
    open: u32,
    /// Nothing more is told: what was told last leaves nothing to be read.
    pub dead: bool,
    /// What is told.
    pub found: &'f mut Found,
}

impl<'t, 'f, K: Keywords> Cursor<'t, 'f, K> {
    /// At the first word of a text.
    pub fn new(text: &'t str, rules: &Rules, found: &'f mut Found) -> Cursor<'t, 'f, K> {
        let tokens = tokens(text, rules, found);
        let keyword = |token: &Token| match token.sign {
            Sign::Word => K::of(text.get(token.span.range()).unwrap_or_default()),
            _ => K::NONE,
        };
        Cursor {
            text,
            keywords: tokens.iter().map(keyword).collect(),
            tokens,
            at: 0,
            open: 0,
            dead: found.place_of(Code::StCommentOpen).is_some(),
            found,
        }
    }

    /// The word here.
    pub fn token(&self) -> Token {
        self.ahead(0)
    }

    /// The word so many further on; the last, where there are no more.
    pub fn ahead(&self, by: usize) -> Token {
        let last = self.tokens.len() - 1;
        self.tokens[(self.at + by).min(last)]
    }

    /// Its sign.
    pub fn sign(&self) -> Sign {
        self.token().sign
    }

    /// Its keyword.
    pub fn keyword(&self) -> K {
        self.keyword_ahead(0)
    }

    /// The keyword so many words further on.
    pub fn keyword_ahead(&self, by: usize) -> K {
        self.keywords.get(self.at + by).copied().unwrap_or(K::NONE)
    }

    /// Whether this sign is here.
    pub fn is(&self, sign: Sign) -> bool {
        self.sign() == sign
    }

    /// Which word it stands at.
    pub fn place(&self) -> usize {
        self.at
    }

    /// Takes the word here. At the end it stays.
    pub fn advance(&mut self) -> Token {
        let token = self.token();
        if self.at + 1 < self.tokens.len() {
            self.at += 1;
        }
        token
    }

    /// Takes this sign, where it is here.
    pub fn accept(&mut self, sign: Sign) -> bool {
        let is = self.is(sign);
        if is {
            self.advance();
        }
        is
    }

    /// Takes the word here for this keyword, which has been told.
    pub fn take_for(&mut self, keyword: K) {
        if let Some(held) = self.keywords.get_mut(self.at) {
            *held = keyword;
        }
    }

    /// Takes the sign here for this one, which has been told.
    pub fn take_sign(&mut self, sign: Sign) {
        if let Some(held) = self.tokens.get_mut(self.at) {
            held.sign = sign;
        }
    }

    /// What stands at a place.
    pub fn slice(&self, span: Span) -> &'t str {
        self.text.get(span.range()).unwrap_or_default()
    }

    /// The word here, as it is written.
    pub fn written(&self) -> &'t str {
        self.slice(self.token().span)
    }

    /// The place of the last word.
    pub fn behind(&self) -> Span {
        match self.at.checked_sub(1).and_then(|at| self.tokens.get(at)) {
            Some(token) => token.span,
            None => self.token().span,
        }
    }

    /// Whether nothing stands between this word and the next.
    pub fn touches(&self, ahead: usize) -> bool {
        self.ahead(ahead).span.end == self.ahead(ahead + 1).span.start
    }

    /// Tells something, unless nothing more is told.
    pub fn tell<const N: usize>(&mut self, code: Code, span: Span, words: [Word; N]) {
        if !self.dead {
            self.found.tell(code, span, words);
        }
    }

    /// Tells that something is missing here.
    pub fn missing(&mut self, what: impl Into<Word>, help: impl Into<Word>) -> Told {
        let (what, help) = (what.into(), help.into());
        let token = self.token();
        let stray = self.found.place_of(Code::StTextOpen);
        if stray.is_some_and(|at| at.start == self.behind().start || at.start == token.span.start) {
            // A text without its end, which has been told, swallows its line.
            return Told;
        }
        if token.sign == Sign::End {
            self.tell(Code::StExpectedEnd, self.behind(), [what, help]);
        } else {
            let written = self.short(token.span);
            self.tell(Code::StExpected, token.span, [what, written.into(), help]);
        }
        Told
    }

    /// What stands there, short enough for a message.
    pub fn short(&self, span: Span) -> String {
        let text = self.slice(span);
        match text.char_indices().nth(24) {
            Some((end, _)) => format!("{}…", &text[..end]),
            None => text.to_owned(),
        }
    }

    /// A sign that must stand here.
    pub fn expect(&mut self, sign: Sign, what: &'static str, help: (&str, &str)) -> Parsed<Span> {
        if self.is(sign) {
            return Ok(self.advance().span);
        }
        let what = Word::Both(format!("a `{what}`"), format!("um `{what}`"));
        Err(self.missing(what, help))
    }

    /// A keyword that must stand here; one that is written almost so is taken for it.
    pub fn expect_keyword(&mut self, keyword: K, help: (&str, &str)) -> Parsed<Span> {
        if self.keyword() == keyword {
            return Ok(self.advance().span);
        }
        let token = self.token();
        if token.sign == Sign::Word && self.keyword() == K::NONE {
            let written = self.slice(token.span);
            let near = nearest(written, [keyword.name()].into_iter()).is_some();
            if near || K::meant(written) == keyword {
                let words = [written.into(), keyword.name().into()];
                self.tell(Code::StOtherWord, token.span, words);
                return Ok(self.advance().span);
            }
        }
        Err(self.missing(keyword.name(), help))
    }

    /// A name of somebody's own.
    pub fn name(&mut self, what: (&str, &str), help: (&str, &str)) -> Parsed<Name> {
        let token = self.token();
        if token.sign != Sign::Word {
            return Err(self.missing(what, help));
        }
        if self.keyword() != K::NONE {
            let written = self.slice(token.span).to_owned();
            self.tell(Code::StReserved, token.span, [written.into()]);
            return Err(Told);
        }
        self.advance();
        Ok(self.named(token.span))
    }

    /// What stands at a place, as a name.
    pub fn named(&self, span: Span) -> Name {
        Name {
            text: self.slice(span).to_owned(),
            span,
        }
    }

    /// Goes one deeper; told where that is too deep, and nothing more is read.
    pub fn deeper(&mut self) -> Parsed<()> {
        self.open += 1;
        match self.open > MOST_OPEN {
            true => Err(self.too_deep()),
            false => Ok(()),
        }
    }

    /// Comes back from one deeper.
    pub fn higher(&mut self) {
        self.open = self.open.saturating_sub(1);
    }

    /// How deep it is, to go back there after what is wrong.
    pub fn depth(&self) -> u32 {
        self.open
    }

    /// Goes back to where it was.
    pub fn back_to(&mut self, depth: u32) {
        self.open = depth;
    }

    /// The height of a node above these; told where that is too high.
    pub fn height(&mut self, below: u32) -> Parsed<u32> {
        match below >= MOST_HIGH {
            true => Err(self.too_deep()),
            false => Ok(below + 1),
        }
    }

    fn too_deep(&mut self) -> Told {
        let span = self.token().span;
        self.tell(Code::StTooDeep, span, []);
        self.end_here();
        Told
    }

    /// Nothing more is read, nor told.
    pub fn end_here(&mut self) {
        self.dead = true;
        self.at = self.tokens.len() - 1;
    }
}
