//! From words to the syntax tree.
//!
//! - `unit`: programs, functions, blocks, and what stands around them
//! - `declare`, `types`, `initial`: variables, their types, and what they begin with
//! - `statement`, `compound` (loops), `choice`: statements; `recover`: what is done after one that is wrong
//! - `enable`, `own_enable`: EN and ENO of a call; `chart`: steps, transitions, actions
//! - `expression`, `operand`, `path`: the rest
//!
//! It tells what is not written as the grammar has it, once for each place, and goes on after the statement.

mod chart;
mod choice;
mod compound;
mod declare;
mod dialect;
mod enable;
mod expression;
mod initial;
mod operand;
mod own_enable;
mod path;
mod recover;
mod statement;
mod types;
mod unit;

use super::ast::{File, Name, Node};
use super::lexer::tokens;
use super::token::{Dialect, Kind, Token};
use super::words::{Keyword, meant};
use std::collections::HashSet;
use unoclp_text::diagnostics::{Code, Found, Span, Word};
use unoclp_text::near::nearest;

/// Statements and parentheses nest no deeper.
const MOST_OPEN: u32 = 200;
/// No part of an expression stands deeper in it.
const MOST_HIGH: u32 = 300;

/// The tree of a text, and whether its declarations can be trusted.
pub(super) fn parse(text: &str, dialect: Dialect, found: &mut Found) -> (File, bool) {
    let mut parser = Parser::new(text, dialect, found);
    let file = parser.file();
    let trusted = parser.is_right();
    (file, trusted)
}

/// A text that is one expression, from its first word to its last; none where it is not, which is told.
pub(super) fn expression(text: &str, found: &mut Found) -> Option<Node> {
    let mut parser = Parser::new(text, Dialect::Iec, found);
    let node = parser.expression().ok()?;
    if !parser.is(Kind::End) {
        let help = (
            "a condition is one expression, without a semicolon",
            "uma condição é uma só expressão, sem ponto e vírgula",
        );
        parser.missing(("the end", "o fim"), help);
        return None;
    }
    (!parser.dead).then_some(node)
}

pub(super) struct Parser<'t, 'f> {
    text: &'t str,
    tokens: Vec<Token>,
    keywords: Vec<Keyword>,
    at: usize,
    /// It reads a piece of Instruction List.
    list: bool,
    /// A unit declares a parameter EN or ENO of its own.
    declares_en: bool,
    /// The units above with code for another machine, in capitals.
    foreign: HashSet<String>,
    /// How many parentheses and statements are open.
    open: u32,
    /// What ends the statements that are open.
    closers: Vec<Keyword>,
    /// It reads a chart.
    in_chart: bool,
    /// Nothing more is told: what was told last leaves nothing to be read.
    dead: bool,
    /// What is named further on may be what a wrong declaration was to declare.
    wrong_declarations: bool,
    /// In this unit a declaration after statements has been told.
    late: bool,
    /// Declarations without VAR and END_VAR have been told.
    headless: bool,
    /// Keywords that were to be names, which has been told.
    reserved: Vec<Keyword>,
    found: &'f mut Found,
}

/// What was not there has been told.
#[derive(Debug)]
pub(super) struct Told;

pub(super) type Parsed<T> = Result<T, Told>;

impl<'t, 'f> Parser<'t, 'f> {
    /// At the first word of a text.
    fn new(text: &'t str, dialect: Dialect, found: &'f mut Found) -> Parser<'t, 'f> {
        let tokens = tokens(text, 0, dialect, found);
        Parser::of(text, tokens, dialect, found)
    }

    /// At the first word of a piece of a list.
    pub(super) fn of_piece(text: &'t str, piece: Span, found: &'f mut Found) -> Parser<'t, 'f> {
        let text = text.get(..piece.end as usize).unwrap_or_default();
        let tokens = tokens(text, piece.start as usize, Dialect::Il, found);
        Parser::of(text, tokens, Dialect::Il, found)
    }

    fn of(
        text: &'t str,
        tokens: Vec<Token>,
        dialect: Dialect,
        found: &'f mut Found,
    ) -> Parser<'t, 'f> {
        let keyword = |token: &Token| match (token.kind, token.meant) {
            (Kind::Word, Some(meant)) => Keyword::of(meant),
            (Kind::Word, None) => {
                let quoted = token.span.start > 0
                    && matches!(
                        text.as_bytes().get(token.span.start as usize - 1),
                        Some(b'"' | b'#')
                    );
                match quoted && dialect == Dialect::Scl {
                    true => Keyword::None,
                    false => Keyword::of(text.get(token.span.range()).unwrap_or_default()),
                }
            }
            _ => Keyword::None,
        };
        let keywords: Vec<Keyword> = tokens.iter().map(keyword).collect();
        let declares_en = own_enable::declares_en(text, &tokens, &keywords);
        // A comment, or code for another machine, that swallows the rest is the one mistake.
        let open = [Code::StCommentOpen, Code::StNotClosed];
        let dead = open.into_iter().any(|code| found.place_of(code).is_some());
        Parser {
            text,
            tokens,
            keywords,
            at: 0,
            list: dialect == Dialect::Il,
            declares_en,
            foreign: HashSet::new(),
            open: 0,
            closers: Vec::new(),
            in_chart: false,
            dead,
            wrong_declarations: false,
            late: false,
            headless: false,
            reserved: Vec::new(),
            found,
        }
    }
}

impl Parser<'_, '_> {
    /// Whether what has been read can be trusted.
    pub(super) fn is_right(&self) -> bool {
        !self.wrong_declarations && !self.dead
    }

    /// The byte after the last word.
    pub(super) fn end(&self) -> u32 {
        self.behind().end
    }

    fn token(&self) -> Token {
        self.ahead(0)
    }

    fn ahead(&self, by: usize) -> Token {
        let last = self.tokens.len() - 1;
        self.tokens[(self.at + by).min(last)]
    }

    fn kind(&self) -> Kind {
        self.token().kind
    }

    fn keyword(&self) -> Keyword {
        self.keyword_ahead(0)
    }

    fn keyword_ahead(&self, by: usize) -> Keyword {
        self.keywords
            .get(self.at + by)
            .copied()
            .unwrap_or(Keyword::None)
    }

    fn is(&self, kind: Kind) -> bool {
        self.kind() == kind
    }

    fn next(&mut self) -> Token {
        let token = self.token();
        if self.at + 1 < self.tokens.len() {
            self.at += 1;
        }
        token
    }

    fn accept(&mut self, kind: Kind) -> bool {
        let is = self.is(kind);
        if is {
            self.next();
        }
        is
    }

    fn accept_keyword(&mut self, keyword: Keyword) -> bool {
        let is = self.keyword() == keyword;
        if is {
            self.next();
        }
        is
    }

    fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).unwrap_or_default()
    }

    /// The place after the last word.
    fn behind(&self) -> Span {
        match self.at.checked_sub(1).and_then(|at| self.tokens.get(at)) {
            Some(token) => token.span,
            None => self.token().span,
        }
    }

    fn tell<const N: usize>(&mut self, code: Code, span: Span, words: [Word; N]) {
        if !self.dead {
            self.found.tell(code, span, words);
        }
    }

    /// Tells that something is missing where the parser is.
    fn missing(&mut self, what: impl Into<Word>, help: impl Into<Word>) -> Told {
        let before = self.behind();
        let quoted = self.slice(before);
        let closed = quoted.len() >= 2 && quoted.ends_with(['\'', '"']);
        if quoted.starts_with(['\'', '"']) && !closed {
            // A text without its end, which has been told, swallows its line.
            return Told;
        }
        let near = [self.at, self.at.saturating_sub(1)].map(|at| self.keywords.get(at));
        let was_name =
            |keyword: &Keyword| *keyword != Keyword::None && self.reserved.contains(keyword);
        if near.into_iter().flatten().any(was_name) {
            return Told;
        }
        let token = self.token();
        if token.kind == Kind::End {
            self.tell(
                Code::StExpectedEnd,
                self.behind(),
                [what.into(), help.into()],
            );
        } else {
            let written = self.short(token.span);
            self.tell(
                Code::StExpected,
                token.span,
                [what.into(), written.into(), help.into()],
            );
        }
        Told
    }

    /// What stands there, short enough for a message.
    fn short(&self, span: Span) -> String {
        let text = self.slice(span);
        match text.char_indices().nth(24) {
            Some((end, _)) => format!("{}…", &text[..end]),
            None => text.to_owned(),
        }
    }

    /// A sign that must stand here.
    fn expect(&mut self, kind: Kind, sign: &'static str, help: impl Into<Word>) -> Parsed<Span> {
        if self.is(kind) {
            return Ok(self.next().span);
        }
        let what = ("a ", "um ");
        let what = Word::Both(format!("{}`{sign}`", what.0), format!("{}`{sign}`", what.1));
        Err(self.missing(what, help))
    }

    /// A keyword that must stand here; one that is written almost so is taken for it.
    fn expect_keyword(&mut self, keyword: Keyword, help: impl Into<Word>) -> Parsed<Span> {
        if self.keyword() == keyword {
            return Ok(self.next().span);
        }
        let token = self.token();
        if token.kind == Kind::Word && self.keyword() == Keyword::None {
            let written = self.slice(token.span).to_owned();
            let names = [keyword.name()];
            let slip = nearest(&written, names.into_iter()).is_some()
                || meant(&written.to_uppercase()) == keyword;
            if slip {
                self.tell(
                    Code::StOtherWord,
                    token.span,
                    [written.into(), keyword.name().into()],
                );
                return Ok(self.next().span);
            }
        }
        Err(self.missing(keyword.name(), help))
    }

    /// A name of somebody's own.
    fn name(&mut self, what: (&str, &str), help: impl Into<Word>) -> Parsed<Name> {
        let token = self.token();
        let goes_on = self.keyword().is_section() && self.on_new_line();
        if token.kind != Kind::Word || token.meant.is_some() || goes_on {
            return Err(self.missing(what, help));
        }
        if self.keyword() != Keyword::None {
            let written = self.slice(token.span).to_owned();
            self.tell(Code::StReserved, token.span, [written.into()]);
            self.reserved.push(self.keyword());
            return Err(Told);
        }
        self.next();
        Ok(self.named(token.span))
    }

    fn named(&self, span: Span) -> Name {
        Name {
            text: self.slice(span).to_owned(),
            span,
        }
    }

    /// Goes one deeper; told where that is too deep, and nothing more is read.
    fn deeper(&mut self) -> Parsed<()> {
        self.open += 1;
        match self.open > MOST_OPEN {
            true => Err(self.too_deep()),
            false => Ok(()),
        }
    }

    fn too_deep(&mut self) -> Told {
        let span = self.token().span;
        self.tell(Code::StTooDeep, span, []);
        self.end_here();
        Told
    }

    /// Nothing more is read, nor told.
    fn end_here(&mut self) {
        self.dead = true;
        self.at = self.tokens.len() - 1;
    }

    /// Whether a line ends between the last word and the next one.
    fn on_new_line(&self) -> bool {
        let between = Span {
            start: self.behind().end,
            end: self.token().span.start,
        };
        self.slice(between).contains('\n')
    }
}
