//! What students write in place of InterSCL: each told once, and read as what was meant where that is plain.
//!
//! Owns words of other languages, ends that end nothing, and how the parser goes on. Must not know types.

use super::ast::Decl;
use super::parser::Parser;
use super::words::{Word, lacking};
use unoclp_small::cursor::{Keywords, Parsed, Told};
use unoclp_small::rules::Sign;
use unoclp_text::diagnostics::Code;
use unoclp_text::near::nearest;
use unoclp_tree::Base;

/// What a command or a declaration may begin with.
const FIRST: [Word; 8] = [
    Word::While,
    Word::Print,
    Word::Real,
    Word::Bool,
    Word::EndIf,
    Word::EndWhile,
    Word::EndFor,
    Word::EndBlock,
];

impl Parser<'_, '_> {
    /// A word of another language where a command begins: told, and taken for the keyword that it stands for.
    pub(super) fn instead(&mut self) {
        if !self.cursor.is(Sign::Word) || self.cursor.keyword() != Word::None {
            return;
        }
        let behind = self.cursor.ahead(1).sign;
        if matches!(
            behind,
            Sign::Assign | Sign::Equal | Sign::Colon | Sign::Foreign
        ) {
            return;
        }
        let written = self.cursor.written();
        let mut meant = Word::meant(written);
        if meant == Word::None && lacking(written).is_none() {
            let names = FIRST.iter().map(|word| word.name());
            if let Some(near) = nearest(written, names) {
                meant = Word::of(near);
            }
        }
        if meant == Word::None {
            return;
        }
        let span = self.cursor.token().span;
        let words = [written.into(), meant.name().into()];
        self.cursor.tell(Code::StOtherWord, span, words);
        self.cursor.take_for(meant);
    }

    /// What Structured Text declares in another way: `VAR`, `x : INT`, `DINT x`.
    pub(super) fn declares_as_st(&mut self) -> Parsed<bool> {
        if !self.cursor.is(Sign::Word) || self.cursor.keyword() != Word::None {
            return Ok(false);
        }
        let span = self.cursor.token().span;
        let written = self.cursor.written();
        let upper = written.to_ascii_uppercase();
        match (upper.as_str(), self.cursor.ahead(1).sign) {
            (_, Sign::Assign | Sign::Equal) => Ok(false),
            ("VAR", _) => {
                self.var = true;
                let help = (
                    "delete it and write the declarations after BLOCO: INT x;",
                    "apague-o e escreva as declarações depois de BLOCO: INT x;",
                );
                self.cursor
                    .tell(Code::IsclLacks, span, [written.into(), help.into()]);
                self.cursor.advance();
                while self.cursor.keyword() == Word::None
                    && matches!(self.cursor.ahead(1).sign, Sign::Comma | Sign::Colon)
                {
                    self.typed_last()?;
                    if !self.cursor.accept(Sign::Semicolon) {
                        break;
                    }
                }
                // What follows is a declaration or END_VAR, so no `;` is missing.
                self.end_var();
                Err(Told)
            }
            ("END_VAR", _) => {
                let told = self.var;
                self.var = false;
                let help = ("delete it", "apague-o");
                if !told {
                    self.cursor
                        .tell(Code::IsclLacks, span, [written.into(), help.into()]);
                }
                self.cursor.advance();
                Err(Told)
            }
            (_, Sign::Colon) => {
                let ty = self.cursor.slice(self.cursor.ahead(2).span);
                if !self.var {
                    let words = [ty.into(), written.into()];
                    self.cursor.tell(Code::IsclTypeFirst, span, words);
                }
                self.typed_last()?;
                Ok(true)
            }
            ("PROGRAM" | "FUNCTION" | "FUNCTION_BLOCK" | "TYPE" | "BEGIN", _) => {
                let help = (
                    "write the whole program between BLOCO and END_BLOCK",
                    "escreva o programa inteiro entre BLOCO e END_BLOCK",
                );
                self.cursor
                    .tell(Code::IsclLacks, span, [written.into(), help.into()]);
                Err(Told)
            }
            (_, Sign::Word)
                if lacking(written).is_none() && self.cursor.keyword_ahead(1) == Word::None =>
            {
                self.cursor.tell(Code::IsclNoType, span, [written.into()]);
                self.cursor.advance();
                let name = self.cursor.named(self.cursor.token().span);
                self.cursor.advance();
                // Of no known type, so its uses are not told.
                self.decls.push(Decl {
                    base: Base::AnyInt,
                    name,
                    point: None,
                });
                Ok(true)
            }
            _ => Ok(false),
        }
    }

    fn end_var(&mut self) {
        if self.cursor.written().eq_ignore_ascii_case("END_VAR") {
            self.var = false;
            self.cursor.advance();
            self.cursor.accept(Sign::Semicolon);
        }
    }

    /// `x, y : INT := 5`, read without a word.
    fn typed_last(&mut self) -> Parsed<()> {
        let mut names = Vec::new();
        loop {
            let span = self.cursor.advance().span;
            names.push(self.cursor.named(span));
            if !self.cursor.accept(Sign::Comma) {
                break;
            }
        }
        self.cursor.accept(Sign::Colon);
        let base = match self.cursor.keyword() {
            Word::Int => Base::Int,
            Word::Real => Base::Real,
            Word::Bool => Base::Bool,
            _ => Base::AnyInt,
        };
        self.cursor.advance();
        for name in names {
            self.decls.push(Decl {
                base,
                name,
                point: None,
            });
        }
        if self.cursor.accept(Sign::Assign) {
            self.expression()?;
        }
        Ok(())
    }

    /// A word that InterSCL does not have; none told where it is no such word.
    pub(super) fn lacks(&mut self) -> Option<Told> {
        let token = self.cursor.token();
        let written = self.cursor.written();
        let help = match token.sign {
            Sign::Word if self.cursor.keyword() == Word::None => lacking(written)?,
            Sign::Foreign => match written {
                "%" => lacking("MOD")?,
                "**" => ("multiply: x * x", "multiplique: x * x"),
                "{" | "}" => (
                    "IF ends with END_IF, WHILE with END_WHILE, FOR with END_FOR",
                    "IF termina com END_IF, WHILE com END_WHILE, FOR com END_FOR",
                ),
                "[" | "]" => (
                    "give each value a variable of its own",
                    "dê a cada valor uma variável própria",
                ),
                _ => (
                    "write it out: x := x + 1",
                    "escreva por extenso: x := x + 1",
                ),
            },
            _ => return None,
        };
        let words = [written.into(), help.into()];
        self.cursor.tell(Code::IsclLacks, token.span, words);
        Some(Told)
    }

    /// An end that nothing open waits for: told, and taken as the end of the innermost part where it is another's.
    /// Whether the list goes on.
    pub(super) fn wrong_end(&mut self, keyword: Word, ends: &[Word]) -> bool {
        let token = self.cursor.token();
        let (written, end) = (self.cursor.written(), ends.first().copied());
        let part = |word: &str| word.trim_start_matches("END_").to_owned();
        if !matches!(keyword, Word::Else | Word::Elsif)
            && let Some(end) = end.filter(|end| *end != Word::EndBlock)
        {
            let words = [written.into(), part(end.name()).into(), end.name().into()];
            self.cursor.tell(Code::IsclWrongEnd, token.span, words);
            self.cursor.take_for(end);
            return false;
        }
        let begin = match keyword {
            Word::Else | Word::Elsif => "IF".to_owned(),
            _ => part(keyword.name()),
        };
        let words = [written.into(), begin.into()];
        self.cursor.tell(Code::StStrayEnd, token.span, words);
        self.cursor.advance();
        if keyword == Word::Elsif {
            self.skip(self.cursor.place());
        }
        true
    }

    /// Goes on after what is wrong: at the next `;`, or at a word that begins or ends something.
    pub(super) fn skip(&mut self, before: usize) {
        if self.cursor.place() == before {
            self.cursor.advance();
        }
        loop {
            let keyword = self.cursor.keyword();
            let stops = matches!(self.cursor.sign(), Sign::Semicolon | Sign::End)
                || keyword.is_end()
                || keyword.is_type()
                || keyword.begins();
            let assigns = self.cursor.is(Sign::Word)
                && self.cursor.ahead(1).sign == Sign::Assign
                && self.on_new_line();
            if stops || assigns {
                return;
            }
            self.cursor.advance();
        }
    }

    /// Goes on after the wrong head of a part: after this word, or where its commands seem to begin.
    pub(super) fn skip_head(&mut self, keyword: Word) {
        loop {
            let here = self.cursor.keyword();
            if here == keyword {
                self.cursor.advance();
                return;
            }
            let stops = matches!(self.cursor.sign(), Sign::Semicolon | Sign::End)
                || here.is_end()
                || here.begins();
            if stops || self.on_new_line() {
                return;
            }
            self.cursor.advance();
        }
    }

    /// Goes after a CASE or REPEAT of Structured Text, whose parts are not told one by one.
    pub(super) fn skip_other(&mut self) {
        let written = self.cursor.written();
        let end = match written.to_ascii_uppercase().as_str() {
            "CASE" => "END_CASE",
            "REPEAT" => "END_REPEAT",
            _ => return,
        };
        while !self.cursor.written().eq_ignore_ascii_case(end) {
            if self.cursor.is(Sign::End) {
                self.cursor.end_here();
                return;
            }
            self.cursor.advance();
        }
    }

    /// Whether a line ends between the last word and this one.
    fn on_new_line(&self) -> bool {
        let between = unoclp_text::diagnostics::Span {
            start: self.cursor.behind().end,
            end: self.cursor.token().span.start,
        };
        self.cursor.slice(between).contains('\n')
    }
}
