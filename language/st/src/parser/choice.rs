//! IF and CASE.

use super::super::ast::{Arm, Statement, StatementKind};
use super::super::token::Kind;
use super::super::words::Keyword;
use super::{MOST_OPEN, Parsed, Parser, Told};
use unoclp_text::diagnostics::{Code, Span};

impl Parser<'_, '_> {
    pub(super) fn if_statement(&mut self, start: Span) -> Parsed<Statement> {
        const THEN: (&str, &str) = (
            "write THEN after the condition",
            "escreva THEN depois da condição",
        );
        let mut arms = Vec::new();
        let mut otherwise = Vec::new();
        let open = self.open;
        self.next();
        let mut condition = self.condition(Keyword::Then, THEN);
        loop {
            let (node, failed) = match condition {
                Ok(node) => (node, false),
                Err(Told) => (self.wrong_node(start), true),
            };
            if failed {
                self.seek_part();
            }
            let body = self.part(Keyword::EndIf);
            arms.push((node, body));
            let keyword = self.keyword();
            if keyword == Keyword::Elsif {
                self.one_more_arm()?;
                self.next();
                condition = self.condition(Keyword::Then, THEN);
                continue;
            }
            if keyword == Keyword::Else {
                let at = self.next().span;
                if self.keyword() == Keyword::If && !self.on_new_line() && !self.closed_twice() {
                    let span = at.to(self.token().span);
                    self.tell_other_word(span, Keyword::Elsif);
                    self.one_more_arm()?;
                    self.next();
                    condition = self.condition(Keyword::Then, THEN);
                    continue;
                }
                otherwise = self.part(Keyword::EndIf);
                if matches!(self.keyword(), Keyword::Else | Keyword::Elsif) {
                    let span = self.token().span;
                    let written = self.short(span);
                    self.tell(Code::StStrayEnd, span, [written.into(), "IF".into()]);
                    self.next();
                    self.recover();
                    self.part(Keyword::EndIf);
                }
            }
            break;
        }
        self.open = open;
        if !self.accept_keyword(Keyword::EndIf) {
            self.not_closed(start, Keyword::EndIf);
        }
        self.accept(Kind::Semicolon);
        let kind = StatementKind::If(arms, otherwise);
        let span = start.to(self.behind());
        Ok(Statement { kind, span })
    }

    /// Each ELSIF is an IF in the ELSE before it, so it counts as one that is open until END_IF.
    fn one_more_arm(&mut self) -> Parsed<()> {
        self.open += 1;
        if self.open <= MOST_OPEN {
            return Ok(());
        }
        let span = self.token().span;
        let most = MOST_OPEN.to_string();
        self.tell(Code::StLongIf, span, [most.into()]);
        self.end_here();
        Err(Told)
    }

    /// Whether after `ELSE IF` two END_IF follow one another, so that it is an IF of its own: looked for as far as a
    /// person would.
    fn closed_twice(&self) -> bool {
        let mut open = 0_i32;
        for by in 0..600 {
            match self.keyword_ahead(by) {
                Keyword::If => open += 1,
                Keyword::EndIf => open -= 1,
                keyword if keyword.ends_unit() || keyword.begins_unit() => return false,
                _ => {}
            }
            if self.ahead(by).kind == Kind::End {
                return false;
            }
            if open == 0 {
                // The IF after ELSE ends here; does the outer one end too?
                let semicolon = usize::from(self.ahead(by + 1).kind == Kind::Semicolon);
                return self.keyword_ahead(by + 1 + semicolon) == Keyword::EndIf
                    || semicolon == 1 && {
                        let next = self.keyword_ahead(by + 2);
                        !next.ends_unit() && self.later_end_if(by + 2)
                    };
            }
        }
        true
    }

    /// Whether more IF are closed than opened from there to the end of the unit.
    fn later_end_if(&self, from: usize) -> bool {
        let mut open = 0_i32;
        for by in from..from + 600 {
            match self.keyword_ahead(by) {
                Keyword::If => open += 1,
                Keyword::EndIf => open -= 1,
                keyword if keyword.ends_unit() => return false,
                _ => {}
            }
            if open < 0 {
                return true;
            }
            if self.ahead(by).kind == Kind::End {
                return false;
            }
        }
        false
    }

    pub(super) fn case_statement(&mut self, start: Span) -> Parsed<StatementKind> {
        self.next();
        let help = ("write OF after the value", "escreva OF depois do valor");
        self.closers.push(Keyword::None);
        let read = self.expression();
        self.closers.pop();
        let selector = read.and_then(|node| {
            self.expect_keyword(Keyword::Of, help)?;
            Ok(node)
        });
        let selector = match selector {
            Ok(selector) => selector,
            Err(Told) => {
                self.seek_part();
                self.wrong_node(start)
            }
        };
        let (mut arms, mut otherwise) = (Vec::new(), Vec::new());
        loop {
            while self.accept(Kind::Semicolon) {}
            if self.is_label() {
                match self.arm() {
                    Ok(arm) => arms.push(arm),
                    Err(Told) => {
                        self.seek_part();
                        self.part(Keyword::EndCase);
                    }
                }
                continue;
            }
            if self.accept_keyword(Keyword::Else) {
                self.accept(Kind::Colon);
                // No label is looked for after ELSE.
                otherwise = self.part(Keyword::EndCase);
                continue;
            }
            let keyword = self.keyword();
            if keyword == Keyword::EndCase
                || self.is(Kind::End)
                || keyword.ends_unit()
                || keyword.begins_unit()
            {
                break;
            }
            if keyword.ends_part() {
                break;
            }
            let what = (
                "a value with a colon, `1:`,",
                "um valor com dois-pontos, `1:`,",
            );
            let help = (
                "each part of CASE begins with its values: 1, 2: or 3..5: or a name of an enumeration",
                "cada parte de CASE começa com os seus valores: 1, 2: ou 3..5: ou um nome de enumeração",
            );
            self.missing(what, help);
            let before = self.at;
            self.recover();
            if self.at == before {
                self.next();
            }
        }
        if !self.accept_keyword(Keyword::EndCase) {
            self.not_closed(start, Keyword::EndCase);
        }
        Ok(StatementKind::Case(selector, arms, otherwise))
    }

    /// Whether a label of CASE stands here.
    pub(super) fn is_label(&self) -> bool {
        let follows =
            |by: usize| matches!(self.ahead(by).kind, Kind::Colon | Kind::Comma | Kind::Range);
        match self.kind() {
            Kind::Number | Kind::Minus | Kind::Plus | Kind::Text => true,
            Kind::Typed => follows(1),
            Kind::Word if matches!(self.keyword(), Keyword::True | Keyword::False) => follows(1),
            // `State.Idle:`
            Kind::Word if self.ahead(1).kind == Kind::Dot => {
                self.ahead(2).kind == Kind::Word && follows(3)
            }
            Kind::Word => self.keyword() == Keyword::None && follows(1),
            _ => false,
        }
    }

    fn arm(&mut self) -> Parsed<Arm> {
        let mut labels = Vec::new();
        loop {
            self.closers.push(Keyword::None);
            let low = self.expression();
            let high = match self.is(Kind::Range) {
                true => {
                    self.next();
                    self.expression().map(Some)
                }
                false => Ok(None),
            };
            self.closers.pop();
            labels.push((low?, high?));
            if !self.accept(Kind::Comma) {
                break;
            }
        }
        let help = (
            "write a colon after the values of a part",
            "escreva dois-pontos depois dos valores de uma parte",
        );
        self.expect(Kind::Colon, ":", help)?;
        let body = self.part(Keyword::EndCase);
        Ok(Arm { labels, body })
    }
}
