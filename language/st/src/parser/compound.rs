//! Loops, and what statements that hold others have in common.

use super::super::ast::{Counting, Node, Path, Statement, StatementKind};
use super::super::token::Kind;
use super::super::words::Keyword;
use super::{Parsed, Parser, Told};
use unoclp_text::diagnostics::{Code, Span};

impl Parser<'_, '_> {
    /// A condition with the word after it.
    pub(super) fn condition(&mut self, keyword: Keyword, help: (&str, &str)) -> Parsed<Node> {
        self.closers.push(Keyword::Then);
        let read = self.expression();
        self.closers.pop();
        let condition = read?;
        if self.is(Kind::Foreign) && self.slice(self.token().span) == "{" || self.is(Kind::Colon) {
            let span = self.token().span;
            let sign = self.short(span);
            self.tell(
                Code::StOtherWord,
                span,
                [sign.into(), keyword.name().into()],
            );
            if self.is(Kind::Foreign) {
                // A text of another language: its } would be told too.
                self.end_here();
                return Err(Told);
            }
            self.next();
            return Ok(condition);
        }
        self.expect_keyword(keyword, help)?;
        Ok(condition)
    }

    /// The statements of a part, and what is open while they are read.
    pub(super) fn part(&mut self, closer: Keyword) -> Vec<Statement> {
        self.closers.push(closer);
        let body = self.statements();
        self.closers.pop();
        body
    }

    pub(super) fn while_statement(&mut self, start: Span) -> Parsed<StatementKind> {
        self.next();
        let help = (
            "write DO after the condition",
            "escreva DO depois da condição",
        );
        let condition = match self.condition(Keyword::Do, help) {
            Ok(condition) => condition,
            Err(Told) => {
                self.seek_part();
                self.wrong_node(start)
            }
        };
        let body = self.part(Keyword::EndWhile);
        if !self.accept_keyword(Keyword::EndWhile) {
            self.not_closed(start, Keyword::EndWhile);
        }
        Ok(StatementKind::While(condition, body))
    }

    pub(super) fn repeat_statement(&mut self, start: Span) -> Parsed<StatementKind> {
        self.next();
        let body = self.part(Keyword::EndRepeat);
        if !self.accept_keyword(Keyword::Until) {
            if self.keyword() == Keyword::EndRepeat {
                let what = ("UNTIL with a condition", "UNTIL com uma condição");
                let help = (
                    "write the condition that ends the loop: UNTIL x > 10 END_REPEAT",
                    "escreva a condição que encerra o laço: UNTIL x > 10 END_REPEAT",
                );
                self.missing(what, help);
                self.next();
            } else {
                self.not_closed(start, Keyword::Until);
            }
            return Ok(StatementKind::Repeat(body, self.wrong_node(start)));
        }
        self.closers.push(Keyword::Then);
        let read = self.expression();
        self.closers.pop();
        let until = match read {
            Ok(until) => until,
            Err(Told) => {
                self.seek_part();
                self.wrong_node(start)
            }
        };
        self.accept(Kind::Semicolon);
        if !self.accept_keyword(Keyword::EndRepeat) {
            self.not_closed(start, Keyword::EndRepeat);
        }
        Ok(StatementKind::Repeat(body, until))
    }

    pub(super) fn for_statement(&mut self, start: Span) -> Parsed<StatementKind> {
        self.next();
        let head = self.for_head();
        if head.is_err() {
            self.seek_part();
        }
        let body = self.part(Keyword::EndFor);
        if !self.accept_keyword(Keyword::EndFor) {
            self.not_closed(start, Keyword::EndFor);
        }
        let (variable, from, to, by) = head?;
        Ok(StatementKind::For(Box::new(Counting {
            variable,
            from,
            to,
            by,
            body,
        })))
    }

    fn for_head(&mut self) -> Parsed<(Path, Node, Node, Option<Node>)> {
        const HELP: (&str, &str) = ("write FOR i := 1 TO 10 DO", "escreva FOR i := 1 TO 10 DO");
        let variable = self.path()?;
        if self.is(Kind::Equal) {
            let span = self.next().span;
            let written = self.short(variable.span);
            self.tell(Code::StEqualsForAssign, span, [written.into()]);
        } else {
            self.expect(Kind::Assign, ":=", HELP)?;
        }
        let from = self.expression()?;
        if self.is(Kind::Range) || self.is(Kind::Comma) {
            let span = self.next().span;
            let written = self.short(span);
            self.tell(Code::StOtherWord, span, [written.into(), "TO".into()]);
        } else {
            self.expect_keyword(Keyword::To, HELP)?;
        }
        let to = self.expression()?;
        let step =
            self.is(Kind::Word) && self.slice(self.token().span).eq_ignore_ascii_case("STEP");
        if step {
            let span = self.token().span;
            self.tell_other_word(span, Keyword::By);
        }
        let by = match step || self.keyword() == Keyword::By {
            true => {
                self.next();
                Some(self.expression()?)
            }
            false => None,
        };
        self.expect_keyword(Keyword::Do, HELP)?;
        Ok((variable, from, to, by))
    }
}
