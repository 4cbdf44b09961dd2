//! From words to the syntax tree: the block, its declarations and its list of commands.
//!
//! Owns what ends a list and what separates its commands. `statement` and `expression` read the commands, `recovery`
//! says what students write in their place.

use super::ast::{Decl, Program, Statement};
use super::words::{RULES, Word};
use unoclp_small::cursor::{Cursor, Keywords, Parsed, Told};
use unoclp_small::rules::Sign;
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_tree::Base;

pub(super) struct Parser<'t, 'f> {
    pub cursor: Cursor<'t, 'f, Word>,
    pub decls: Vec<Decl>,
    /// What ends the parts that are open.
    pub ends: Vec<Word>,
    /// A command has been read, so declarations come too late.
    commands: bool,
    /// They have come too late, which has been told.
    late: bool,
    /// VAR stands before the declarations, which has been told.
    pub var: bool,
    /// The expression is a condition, in which `:=` can mean nothing but `=`.
    pub condition: bool,
    /// The word before which an end is missing, which has been told.
    unclosed: Option<usize>,
}

/// The program of a text; none where there is nothing to be checked.
pub(super) fn parse(text: &str, found: &mut Found) -> Option<Program> {
    let mut parser = Parser {
        cursor: Cursor::new(text, &RULES, found),
        decls: Vec::new(),
        ends: Vec::new(),
        commands: false,
        late: false,
        var: false,
        condition: false,
        unclosed: None,
    };
    let program = parser.program().ok();
    program.filter(|_| !parser.cursor.dead)
}

const BEGIN: (&str, &str) = (
    "a program is BLOCO … END_BLOCK",
    "um programa é BLOCO … END_BLOCK",
);

impl<'t> Parser<'t, '_> {
    fn program(&mut self) -> Parsed<Program> {
        let begin = self.cursor.token().span;
        if self.cursor.keyword() == Word::Block {
            self.cursor.advance();
            self.block_name();
        } else if self.cursor.is(Sign::End) {
            return Err(self.cursor.missing("BLOCO", BEGIN));
        } else {
            self.outside();
            if self.of_other_language() {
                return Err(Told);
            }
            // END_BLOCK may be missing too.
            self.unclosed = Some(usize::MAX);
        }
        let body = self.list(&[Word::EndBlock]);
        if self.cursor.keyword() == Word::EndBlock {
            self.cursor.advance();
        } else if self.unclosed != Some(usize::MAX) {
            self.not_closed(begin, Word::EndBlock);
        }
        while self.cursor.accept(Sign::Semicolon) {}
        if !self.cursor.is(Sign::End) {
            self.outside();
        }
        Ok(Program {
            span: begin,
            decls: std::mem::take(&mut self.decls),
            body,
        })
    }

    /// Tells that a word stands outside of the block.
    fn outside(&mut self) {
        let span = self.cursor.token().span;
        let written = self.cursor.short(span).into();
        self.cursor.tell(Code::IsclOutside, span, [written]);
    }

    /// Whether the text begins as a program of Structured Text.
    fn of_other_language(&self) -> bool {
        let words = [
            "PROGRAM",
            "FUNCTION",
            "FUNCTION_BLOCK",
            "TYPE",
            "VAR_GLOBAL",
        ];
        let written = self.cursor.written();
        words.iter().any(|word| word.eq_ignore_ascii_case(written))
    }

    /// `BLOCO teste`: a name where there is none.
    fn block_name(&mut self) {
        let token = self.cursor.token();
        let behind = self.cursor.ahead(1).sign;
        let named = token.sign == Sign::Text
            || token.sign == Sign::Word
                && self.cursor.keyword() == Word::None
                && behind == Sign::Word
                && super::words::lacking(self.cursor.written()).is_none()
                && !self.cursor.written().eq_ignore_ascii_case("VAR")
                && Word::meant(self.cursor.written()) == Word::None
                && self.cursor.keyword_ahead(1) != Word::None;
        if named {
            let written = self.cursor.short(token.span).into();
            self.cursor.tell(Code::IsclNamed, token.span, [written]);
            self.cursor.advance();
        }
    }

    /// Commands up to one of these words, or to a word that ends what is open around them.
    pub fn list(&mut self, ends: &[Word]) -> Vec<Statement> {
        self.ends.extend(ends);
        let mut all = Vec::new();
        loop {
            while self.cursor.accept(Sign::Semicolon) {}
            if self.cursor.is(Sign::End) {
                break;
            }
            let keyword = self.cursor.keyword();
            if keyword.is_end() {
                if self.ends.contains(&keyword) {
                    break;
                }
                if self.wrong_end(keyword, ends) {
                    continue;
                }
                break;
            }
            let (before, depth) = (self.cursor.place(), self.cursor.depth());
            match self.item() {
                Ok(Some(statement)) => {
                    self.commands = true;
                    let whole = statement.is_whole();
                    all.push(statement);
                    self.separator(whole);
                }
                Ok(None) => self.separator(false),
                Err(Told) => {
                    self.cursor.back_to(depth);
                    self.condition = false;
                    self.skip(before);
                }
            }
        }
        self.ends.truncate(self.ends.len() - ends.len());
        all
    }

    /// A declaration, which is kept, or a command.
    fn item(&mut self) -> Parsed<Option<Statement>> {
        self.instead();
        if self.cursor.keyword().is_type() {
            let begin = self.cursor.token().span;
            self.declaration()?;
            if self.commands && !self.late && !self.var {
                self.late = true;
                let span = begin.to(self.cursor.behind());
                let written = self.cursor.short(span).into();
                self.cursor.tell(Code::IsclLate, span, [written]);
            }
            return Ok(None);
        }
        if self.declares_as_st()? {
            return Ok(None);
        }
        self.command().map(Some)
    }

    /// What stands between two commands. Where it is missing after the end of a part, the text is read.
    fn separator(&mut self, whole: bool) {
        let (sign, keyword) = (self.cursor.sign(), self.cursor.keyword());
        if matches!(sign, Sign::Semicolon | Sign::End) || keyword.is_end() {
            return;
        }
        let last = self.cursor.behind();
        if whole {
            let end = self.cursor.slice(last).into();
            self.cursor.tell(Code::IsclSeparator, last, [end]);
            return;
        }
        let before = self.cursor.place();
        let help = (
            "a `;` ends each statement and each declaration",
            "um `;` encerra cada comando e cada declaração",
        );
        let behind = self.cursor.ahead(1).sign;
        let stores = matches!(behind, Sign::Assign | Sign::Equal | Sign::Colon);
        let begins = keyword.begins() || keyword.is_type() || sign == Sign::Word && stores;
        self.cursor.missing("`;`", help);
        if !begins {
            self.skip(before);
        }
    }

    /// `INT x`, `BOOL start AT %IX1`
    fn declaration(&mut self) -> Parsed<()> {
        let written = self.cursor.written();
        let base = match self.cursor.keyword() {
            Word::Real => Base::Real,
            Word::Bool => Base::Bool,
            _ => Base::Int,
        };
        self.cursor.advance();
        if self.cursor.is(Sign::Colon) && self.cursor.ahead(1).sign == Sign::Word {
            self.cursor.advance();
        }
        let name = self.declared(base)?;
        if self.cursor.is(Sign::Comma) {
            let span = self.cursor.token().span;
            let second = self.cursor.slice(self.cursor.ahead(1).span);
            let words = [written.into(), name.into(), second.into()];
            self.cursor.tell(Code::IsclOneName, span, words);
            while self.cursor.accept(Sign::Comma) {
                if self.cursor.keyword().is_type() {
                    self.cursor.advance();
                }
                self.declared(base)?;
            }
        }
        if matches!(self.cursor.sign(), Sign::Assign | Sign::Equal) {
            let span = self.cursor.token().span;
            self.cursor.advance();
            let value = self.expression()?.span;
            let value = self.cursor.short(value);
            let words = [written.into(), name.into(), value.into()];
            self.cursor.tell(Code::IsclFirstValue, span, words);
        }
        Ok(())
    }

    fn declared(&mut self, base: Base) -> Parsed<&'t str> {
        let what = ("the name of the variable", "o nome da variável");
        let help = (
            "write it after its type: INT x;",
            "escreva-o depois do tipo: INT x;",
        );
        let name = self.cursor.name(what, help)?;
        let mut point = None;
        if self.cursor.keyword() == Word::At {
            self.cursor.advance();
            let help = (
                "inputs are %IX1 to %IX8, outputs %QX1 to %QX4",
                "as entradas são %IX1 a %IX8, as saídas %QX1 a %QX4",
            );
            if !self.cursor.is(Sign::Address) {
                return Err(self
                    .cursor
                    .missing(("the address of a point", "o endereço de um ponto"), help));
            }
            let span = self.cursor.advance().span;
            point = Some(self.cursor.named(span));
        }
        let span = name.span;
        self.decls.push(Decl { base, name, point });
        Ok(self.cursor.slice(span))
    }

    /// Tells that a part has no end, once for each place where ends are missing.
    pub fn not_closed(&mut self, begin: Span, end: Word) {
        let here = self.cursor.place();
        if self.unclosed.replace(here) == Some(here) {
            return;
        }
        let written = self.cursor.short(begin).into();
        let words = [written, end.name().into()];
        self.cursor.tell(Code::StNotClosed, begin, words);
    }
}
