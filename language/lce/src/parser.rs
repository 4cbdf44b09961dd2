//! From words to the syntax tree: the program, its parts and its lists of commands.
//!
//! Owns what begins and ends a list. `var` reads names, `command` and `expression` the rest.

use super::ast::{Alias, Program, Statement};
use super::words::{RULES, Word, lacking};
use std::collections::HashSet;
use unoclp_core::Board;
use unoclp_small::cursor::{Cursor, Keywords, Parsed, Told};
use unoclp_small::rules::Sign;
use unoclp_text::diagnostics::{Code, Found};
use unoclp_text::near::nearest;

pub(super) struct Parser<'t, 'f> {
    pub cursor: Cursor<'t, 'f, Word>,
    pub aliases: Vec<Alias>,
    /// The names that `var` has given.
    pub given: HashSet<&'t str>,
    /// The type of the next operator, which sticks to the operand before it.
    pub stuck: Option<super::ast::Kind>,
    /// How many braces are open.
    pub braces: u32,
    /// A command has been read.
    commands: bool,
    /// The board that the text is for.
    pub board: Board,
}

/// The program of a text; none where there is nothing to be checked.
pub(super) fn parse(text: &str, board: Board, found: &mut Found) -> Option<Program> {
    let mut parser = Parser {
        cursor: Cursor::new(text, &RULES, found),
        aliases: Vec::new(),
        given: HashSet::new(),
        stuck: None,
        braces: 0,
        commands: false,
        board,
    };
    let program = parser.program();
    (!parser.cursor.dead).then_some(program)
}

impl Parser<'_, '_> {
    fn program(&mut self) -> Program {
        let begin = self.cursor.token().span;
        let begun = self.cursor.keyword() == Word::Plc;
        let mut name = None;
        if begun {
            let written = self.cursor.written();
            self.cursor.advance();
            let token = self.cursor.token();
            let named = token.sign == Sign::Text
                || token.sign == Sign::Word
                    && self.cursor.keyword() == Word::None
                    && !matches!(self.cursor.ahead(1).sign, Sign::Assign | Sign::Equal);
            if named {
                self.cursor.advance();
                name = Some(self.cursor.named(token.span));
                self.cursor.accept(Sign::Semicolon);
            } else {
                self.cursor.tell(Code::LceNoName, begin, [written.into()]);
            }
        }
        let mut body = self.list();
        while self.cursor.keyword() == Word::End {
            if begun {
                break;
            }
            let written = self.cursor.written();
            let span = self.cursor.advance().span;
            let words = [written.into(), "clp".into()];
            self.cursor.tell(Code::StStrayEnd, span, words);
            body.append(&mut self.list());
        }
        if begun {
            self.end(begin);
        }
        Program {
            name,
            span: begin,
            aliases: std::mem::take(&mut self.aliases),
            body,
        }
    }

    /// `fim`, after which nothing stands.
    fn end(&mut self, begin: unoclp_text::diagnostics::Span) {
        if self.cursor.keyword() != Word::End {
            let words = [self.cursor.slice(begin).into(), "fim".into()];
            self.cursor.tell(Code::StNotClosed, begin, words);
            return;
        }
        let end = self.cursor.written();
        self.cursor.advance();
        while self.cursor.accept(Sign::Semicolon) {}
        if !self.cursor.is(Sign::End) {
            let span = self.cursor.token().span;
            let words = [self.cursor.short(span).into(), end.into()];
            self.cursor.tell(Code::LceBehind, span, words);
        }
    }

    /// Commands, up to a closing brace where one is open, or to the end of the program.
    pub fn list(&mut self) -> Vec<Statement> {
        let mut all = Vec::new();
        loop {
            while self.cursor.accept(Sign::Semicolon) {}
            let ends = match self.cursor.sign() {
                Sign::End => true,
                Sign::CloseBrace if self.braces > 0 => true,
                Sign::CloseBrace => {
                    self.stray("{");
                    continue;
                }
                _ => self.cursor.keyword() == Word::End,
            };
            if ends {
                return all;
            }
            if self.braces == 0 && self.part() {
                continue;
            }
            let (before, depth) = (self.cursor.place(), self.cursor.depth());
            match self.command() {
                Ok(statement) => {
                    self.commands = true;
                    let whole = matches!(statement.kind, super::ast::StatementKind::If(..));
                    all.push(statement);
                    if !whole {
                        self.separator();
                    }
                }
                Err(Told) => {
                    self.cursor.back_to(depth);
                    self.stuck = None;
                    self.skip(before);
                }
            }
        }
    }

    /// `rede` with its text, or `var` with its names.
    fn part(&mut self) -> bool {
        match self.cursor.keyword() {
            Word::Network => {
                self.cursor.advance();
                self.cursor.accept(Sign::Title);
                self.cursor.accept(Sign::Colon);
            }
            Word::Var => {
                let span = self.cursor.advance().span;
                if self.commands {
                    self.cursor.tell(Code::LceLateVar, span, []);
                }
                self.names();
            }
            Word::Else => {
                self.stray("se");
                if self.cursor.accept(Sign::OpenBrace) {
                    self.orphans();
                }
            }
            _ => return false,
        }
        true
    }

    fn stray(&mut self, begin: &str) {
        let written = self.cursor.written();
        let span = self.cursor.advance().span;
        let words = [written.into(), begin.into()];
        self.cursor.tell(Code::StStrayEnd, span, words);
    }

    /// The `;` after a command.
    pub fn separator(&mut self) {
        if self.cursor.accept(Sign::Semicolon) {
            return;
        }
        let before = self.cursor.place();
        let help = ("a `;` ends each statement", "um `;` encerra cada comando");
        let sign = self.cursor.sign();
        let stores = match self.cursor.ahead(1).sign {
            Sign::Word => self.cursor.ahead(2).sign == Sign::Assign,
            sign => matches!(sign, Sign::Assign | Sign::Equal),
        };
        let begins = self.cursor.keyword() != Word::None
            || matches!(sign, Sign::CloseBrace | Sign::End)
            || sign == Sign::Word && stores;
        self.cursor.missing("`;`", help);
        if !begins {
            self.skip(before);
        }
    }

    /// Goes on after what is wrong: at the next `;`, at a brace, or at a word that begins something.
    pub fn skip(&mut self, before: usize) {
        if self.cursor.place() == before {
            self.cursor.advance();
        }
        loop {
            let keyword = self.cursor.keyword();
            let stops = matches!(
                self.cursor.sign(),
                Sign::Semicolon | Sign::End | Sign::CloseBrace
            ) || keyword.begins()
                || matches!(keyword, Word::End | Word::Network | Word::Var);
            if stops {
                return;
            }
            if self.cursor.is(Sign::OpenBrace) {
                // The body of a `se` whose head is wrong: its commands are read.
                self.cursor.advance();
                self.orphans();
                return;
            }
            self.cursor.advance();
        }
    }

    /// The commands of a `se` whose head is wrong, and of its `senao`: only looked through.
    fn orphans(&mut self) {
        if self.cursor.deeper().is_err() {
            return;
        }
        loop {
            self.braces += 1;
            self.list();
            self.braces -= 1;
            let closed = self.cursor.accept(Sign::CloseBrace);
            let more = closed
                && self.cursor.keyword() == Word::Else
                && self.cursor.ahead(1).sign == Sign::OpenBrace;
            if !more {
                break;
            }
            self.cursor.advance();
            self.cursor.advance();
        }
        self.cursor.higher();
    }

    /// A word of another language where a command begins: told, and taken for the keyword that it stands for.
    pub fn instead(&mut self) -> Parsed<()> {
        if !self.cursor.is(Sign::Word) || self.cursor.keyword() != Word::None {
            return Ok(());
        }
        let behind = self.cursor.ahead(1).sign;
        let written = self.cursor.written();
        let typed = behind == Sign::Word && self.cursor.ahead(2).sign == Sign::Assign;
        if matches!(behind, Sign::Assign | Sign::Equal) || typed || self.given.contains(written) {
            return Ok(());
        }
        let span = self.cursor.token().span;
        if let Some(help) = lacking(written) {
            self.cursor
                .tell(Code::LceLacks, span, [written.into(), help.into()]);
            return Err(Told);
        }
        let mut meant = Word::meant(written);
        if meant == Word::None {
            let words = ["aciona", "desliga", "liga", "operate", "senao", "rede"];
            if let Some(near) = nearest(written, words.into_iter()) {
                meant = Word::of(near);
            }
        }
        if meant != Word::None {
            let words = [written.into(), meant.name().into()];
            self.cursor.tell(Code::StOtherWord, span, words);
            self.cursor.take_for(meant);
            if self.part() {
                return Err(Told);
            }
        }
        Ok(())
    }
}
