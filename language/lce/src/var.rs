//! `var`: lines of `V0 = nivel;`, a name for a variable, a point or a marker.
//!
//! Owns what such a line looks like and where the lines end. Must not know which points a board has.

use super::ast::Alias;
use super::parser::Parser;
use super::slots::is_place;
use super::words::Word;
use unoclp_small::rules::Sign;
use unoclp_text::diagnostics::Code;

impl<'t> Parser<'t, '_> {
    /// The lines after `var`.
    pub(super) fn names(&mut self) {
        while self.line() {}
    }

    /// One line; false where none is there.
    fn line(&mut self) -> bool {
        if self.cursor.accept(Sign::Semicolon) {
            return true;
        }
        let (first, behind) = (self.cursor.token(), self.cursor.ahead(1).sign);
        let is_name = matches!(first.sign, Sign::Word | Sign::Number | Sign::Address)
            && self.cursor.keyword() == Word::None;
        match behind {
            _ if !is_name => return false,
            Sign::Equal => self.alias(),
            Sign::Colon => {
                let help = (
                    "variables have no declared type; write a place and its name: V0 = nivel;",
                    "as variáveis não têm tipo declarado; escreva um lugar e o nome dele: V0 = nivel;",
                );
                let written = self.cursor.short(first.span);
                self.cursor
                    .tell(Code::LceVarForm, first.span, [written.into(), help.into()]);
                self.skip(self.cursor.place());
            }
            // A command.
            _ => return false,
        }
        true
    }

    /// `V0 = nivel;`
    fn alias(&mut self) {
        let first = self.cursor.advance();
        self.cursor.advance();
        let second = self.cursor.token();
        let (place, name) = (
            self.cursor.slice(first.span),
            self.cursor.slice(second.span),
        );
        let reserved = self.cursor.keyword() != Word::None;
        if second.sign == Sign::End || second.sign == Sign::Semicolon {
            let help = (
                "write the name that the place gets: V0 = nivel;",
                "escreva o nome que o lugar recebe: V0 = nivel;",
            );
            self.cursor.missing(("a name", "um nome"), help);
            return;
        }
        self.cursor.advance();
        if second.sign == Sign::Word && reserved {
            self.cursor
                .tell(Code::StReserved, second.span, [name.into()]);
        } else if second.sign != Sign::Word || is_place(name) && is_place(place) {
            let help = match second.sign {
                Sign::Word => (
                    "write a name of your own after the =: V0 = nivel;".to_owned(),
                    "escreva um nome seu depois do =: V0 = nivel;".to_owned(),
                ),
                _ => (
                    format!("store an initial value with a statement: {place} := {name};"),
                    format!("guarde um valor inicial com um comando: {place} := {name};"),
                ),
            };
            let span = first.span.to(second.span);
            let written = self.cursor.short(span);
            self.cursor
                .tell(Code::LceVarForm, span, [written.into(), help.into()]);
        } else if !is_place(place) && is_place(name) {
            self.cursor.tell(
                Code::LceSwapped,
                first.span.to(second.span),
                [place.into(), name.into()],
            );
            self.give(second, first);
        } else {
            self.give(first, second);
        }
        if !self.cursor.is(Sign::End) {
            self.separator();
        }
    }

    fn give(&mut self, place: unoclp_small::rules::Token, name: unoclp_small::rules::Token) {
        let written: &'t str = self.cursor.slice(name.span);
        self.given.insert(written);
        self.aliases.push(Alias {
            place: self.cursor.named(place.span),
            name: self.cursor.named(name.span),
        });
    }
}
