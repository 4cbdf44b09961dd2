//! The lines of Instruction List: labels, operators and what they work on.
//!
//! An operand is what Structured Text has for one, so that names, members, subscripts and literals are read in one
//! place.

use super::super::ast::{Arg, Instruction, Line, Name, Section, Vars};
use super::super::token::Kind;
use super::super::words::Keyword;
use super::{Parsed, Parser, Told};
use crate::diagnostics::{Code, Span};
use crate::operators::{self, Op};

impl Parser<'_, '_> {
    /// Lines up to the end of the unit. Declarations may stand between them.
    pub(super) fn list_body(&mut self, vars: &mut Vec<Vars>, globals: &mut Vec<Vars>) -> Vec<Line> {
        let mut lines = self.lines();
        while self.keyword().is_section() {
            let section = self.section();
            match section.section {
                Section::Global => globals.push(section),
                _ => vars.push(section),
            }
            lines.append(&mut self.lines());
        }
        lines
    }

    fn lines(&mut self) -> Vec<Line> {
        let mut lines = Vec::new();
        let mut open = 0_u32;
        loop {
            while self.accept(Kind::Semicolon) {}
            let keyword = self.keyword();
            let labelled = self.ahead(1).kind == Kind::Colon;
            let ends = keyword.ends_unit() || keyword.begins_unit() || keyword == Keyword::EndVar;
            if self.is(Kind::End) || (ends || keyword.is_section()) && !labelled {
                return lines;
            }
            let before = self.at;
            match self.line(&mut open) {
                Ok(Some(line)) => lines.push(line),
                Ok(None) => {}
                Err(Told) => {
                    self.rest_of_line(before);
                    lines.push(Line::Wrong);
                    open = 0;
                }
            }
        }
    }

    fn rest_of_line(&mut self, before: usize) {
        if self.at == before {
            self.next();
        }
        while !self.on_new_line() && !self.is(Kind::End) {
            self.next();
        }
    }

    fn line(&mut self, open: &mut u32) -> Parsed<Option<Line>> {
        let token = self.token();
        match token.kind {
            Kind::Close => {
                self.next();
                *open = open.saturating_sub(1);
                Ok(Some(Line::Close(token.span)))
            }
            // The number of a line, as listings have it.
            Kind::Number if self.on_new_line() || self.at == 0 => {
                self.next();
                Ok(None)
            }
            Kind::Word if self.ahead(1).kind == Kind::Colon => {
                let label = self.named(token.span);
                self.next();
                self.next();
                Ok(Some(Line::Label(label)))
            }
            Kind::Word if self.slice(token.span).eq_ignore_ascii_case("NETWORK") => {
                self.rest_of_line(self.at);
                Ok(None)
            }
            Kind::Word if self.ahead(1).kind == Kind::Assign => {
                let written = self.slice(token.span.to(self.ahead(1).span)).to_owned();
                let span = token.span.to(self.ahead(1).span);
                self.tell(Code::StructuredText, span, [written.into()]);
                Err(Told)
            }
            Kind::Word | Kind::And | Kind::Equal => self.instruction(open).map(Some),
            _ => Err(self.unexpected(token.span)),
        }
    }

    fn unexpected(&mut self, span: Span) -> Told {
        let written = self.short(span);
        self.tell(Code::Unexpected, span, [written.into()]);
        Told
    }

    fn instruction(&mut self, open: &mut u32) -> Parsed<Line> {
        let word = self.operator();
        let key = word.text.to_uppercase();
        let spelling = operators::find(&key);
        let defers = spelling.is_some_and(|spelling| spelling.op.may_defer());
        let mut made = Instruction {
            span: word.span,
            word,
            spelling,
            open: None,
            operands: Vec::new(),
            given: None,
        };
        // `ABS` alone, where another instruction follows on its line.
        let alone = spelling.is_none() && self.ends(*open);
        let formal = self.ahead(1).kind == Kind::Word
            && matches!(self.ahead(2).kind, Kind::Assign | Kind::Arrow);
        if self.is(Kind::Open) && (formal || !defers) {
            made.given = Some(self.arguments()?.0);
        } else if self.is(Kind::Open) {
            let paren = self.next().span;
            made.span = made.span.to(paren);
            let n = self.token();
            let negates = n.kind == Kind::Word
                && self.slice(n.span).eq_ignore_ascii_case("N")
                && !self.on_new_line()
                && !matches!(self.ahead(1).kind, Kind::Close | Kind::Dot)
                && !(self.declares_n && self.ends_line());
            if negates {
                self.next();
            }
            made.open = Some(negates);
            *open += 1;
            let loads = spelling_of(self.slice(self.token().span)) == Some(Op::Load);
            if !self.ends(0) && !loads {
                made.operands.push(self.list_operand()?);
            }
        } else if !alone
            && !self.ends(0)
            && spelling.is_none_or(|spelling| spelling.op.takes_operand())
        {
            loop {
                made.operands.push(self.list_operand()?);
                if !self.accept(Kind::Comma) {
                    break;
                }
            }
            if self.is(Kind::Open) {
                made.given = Some(self.arguments()?.0);
            }
        }
        if !self.ends(*open) {
            let span = self.token().span;
            return Err(self.unexpected(span));
        }
        made.span = made.word.span.to(self.behind());
        Ok(Line::Does(Box::new(made)))
    }

    /// The operator that comes next; `&N` is one, and so is `=`.
    fn operator(&mut self) -> Name {
        let token = self.next();
        if token.kind == Kind::Equal {
            // As the S7-200 writes it.
            return Name {
                text: "ST".to_owned(),
                span: token.span,
            };
        }
        if token.kind != Kind::And {
            return self.of_two_words(token.span);
        }
        let n = self.token();
        let negated =
            n.span.start == token.span.end && self.slice(n.span).eq_ignore_ascii_case("N");
        if negated {
            self.next();
        }
        Name {
            text: if negated { "ANDN" } else { "AND" }.to_owned(),
            span: token.span,
        }
    }

    /// `LD NOT` and `AND LD`, as OMRON writes them, or the operator alone.
    fn of_two_words(&mut self, span: Span) -> Name {
        let alone = self.named(span);
        let next = self.token();
        if next.kind != Kind::Word || self.on_new_line() {
            return alone;
        }
        let (word, more) = (
            alone.text.to_uppercase(),
            self.slice(next.span).to_uppercase(),
        );
        let negates = more == "NOT" && spelling_of(&word).is_some_and(Op::may_negate);
        let text = match (word.as_str(), more.as_str()) {
            (word, "NOT") if negates => format!("{word}N"),
            ("AND", "LD") if self.ends_line() => "ALD".to_owned(),
            ("OR", "LD") if self.ends_line() => "OLD".to_owned(),
            _ => return alone,
        };
        if spelling_of(&text).is_none() {
            return alone;
        }
        self.next();
        let span = span.to(next.span);
        Name { text, span }
    }

    /// Whether the instruction ends here; within parentheses another may follow on its line.
    fn ends(&self, open: u32) -> bool {
        let token = self.token();
        let follows = || {
            open > 0 && (token.kind == Kind::And || spelling_of(self.slice(token.span)).is_some())
        };
        matches!(token.kind, Kind::End | Kind::Close | Kind::Semicolon)
            || self.on_new_line()
            || follows()
    }

    /// Whether the word that comes is the last of its line.
    fn ends_line(&self) -> bool {
        let (word, next) = (self.token().span, self.ahead(1));
        let between = Span {
            start: word.end,
            end: next.span.start,
        };
        next.kind == Kind::End || self.slice(between).contains('\n')
    }

    fn list_operand(&mut self) -> Parsed<Arg> {
        Ok(Arg {
            name: None,
            out: false,
            node: self.operand()?,
        })
    }
}

fn spelling_of(word: &str) -> Option<Op> {
    operators::find(&word.to_uppercase()).map(|spelling| spelling.op)
}
