//! `VAR … END_VAR`.

use super::Parser;
use crate::ast::{Operand, Section, Unit, Var, Word};
use crate::diagnostics::Code;
use crate::lexer::{Kind, Token};
use crate::operators;

impl Parser<'_, '_> {
    /// The section that this word opens.
    pub(super) fn section(&self, token: Token) -> Option<Section> {
        let words = [
            ("VAR", Section::Local),
            ("VAR_TEMP", Section::Local),
            ("VAR_GLOBAL", Section::Local),
            ("VAR_INPUT", Section::Input),
            ("VAR_OUTPUT", Section::Output),
        ];
        let mut words = words.into_iter();
        words
            .find(|(word, _)| self.is(token, word))
            .map(|(_, section)| section)
    }

    /// From behind the word that opens a section to END_VAR.
    pub(super) fn declarations(&mut self, opening: Token, mut section: Section, unit: &mut Unit) {
        if self.is(self.peek(), "RETAIN") {
            self.advance();
            section = Section::Retain;
        } else if self.is(self.peek(), "CONSTANT") {
            self.advance();
        }
        loop {
            let token = self.peek();
            match token.kind {
                Kind::NewLine | Kind::Semicolon => self.at += 1,
                Kind::Name if self.is(token, "END_VAR") => {
                    self.at += 1;
                    return;
                }
                Kind::Name if !self.is_instruction() => self.declaration(section, unit),
                Kind::Name | Kind::End => {
                    let why = (
                        "write END_VAR behind the declarations",
                        "escreva END_VAR depois das declarações",
                    );
                    let word = self.text_of(opening.span).to_owned();
                    return self.tell(Code::Structure, opening.span, [word.into(), why.into()]);
                }
                _ => self.unexpected(),
            }
        }
    }

    /// Whether an instruction comes, and not a declaration.
    fn is_instruction(&self) -> bool {
        let next = self.ahead(1);
        let declares = matches!(next.kind, Kind::Colon | Kind::Comma) || self.is(next, "AT");
        !declares && operators::find(&self.word(self.peek()).text).is_some()
    }

    /// `start, stop AT %IX1 : BOOL := TRUE;`
    fn declaration(&mut self, section: Section, unit: &mut Unit) {
        let mut names = Vec::new();
        while let Some(name) = self.take(Kind::Name) {
            names.push(self.word(name));
            if self.take(Kind::Comma).is_none() {
                break;
            }
        }
        let mut at = None;
        if self.is(self.peek(), "AT") {
            self.advance();
            at = self.operand();
        }
        if self.take(Kind::Colon).is_none() {
            return self.unexpected();
        }
        let Some(ty) = self.take(Kind::Name) else {
            return self.unexpected();
        };
        let ty = self.word(ty);
        let init = match self.take(Kind::Assign) {
            Some(_) => self.init(),
            None => None,
        };
        for name in names {
            unit.vars.push(Var {
                section,
                name,
                at: at.clone(),
                ty: Word { ..ty.clone() },
                init: init.clone(),
            });
        }
        if self.take(Kind::Semicolon).is_none() && self.peek().kind != Kind::NewLine {
            self.unexpected();
        }
    }

    /// `T#5s`, or `(PT := T#5s)`.
    fn init(&mut self) -> Option<Operand> {
        if self.take(Kind::Open).is_none() {
            return self.operand();
        }
        self.take(Kind::Name);
        self.take(Kind::Assign);
        let operand = self.operand();
        if self.take(Kind::Close).is_none() {
            self.unexpected();
        }
        operand
    }
}
