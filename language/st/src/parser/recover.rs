//! Where statements end, and how the parser goes on after what is wrong.

use super::super::ast::{Node, NodeKind, Statement};
use super::super::token::Kind;
use super::super::words::{Keyword, meant};
use super::{Parsed, Parser, Told};
use unoclp_text::diagnostics::{Code, Span};

fn opener(keyword: Keyword) -> &'static str {
    match keyword {
        Keyword::EndIf | Keyword::Else | Keyword::Elsif => "IF",
        Keyword::EndFor => "FOR",
        Keyword::EndWhile => "WHILE",
        Keyword::EndRepeat | Keyword::Until => "REPEAT",
        Keyword::EndCase => "CASE",
        Keyword::EndRegion => "REGION",
        _ => "PROGRAM",
    }
}

impl Parser<'_, '_> {
    pub(super) fn ends_statements(&mut self) -> bool {
        self.take_for_end();
        let keyword = self.keyword();
        if self.is(Kind::End) || keyword.ends_unit() || keyword.begins_unit() {
            return true;
        }
        if self.ends_in_chart() {
            return true;
        }
        if keyword.ends_part() {
            return !self.stray_end(keyword);
        }
        // Within CASE a label ends what stands before it.
        self.closers.last() == Some(&Keyword::EndCase) && self.is_label()
    }

    /// Takes `ENDIF` and `ELSEIF` for the words that are meant, where what they end is open.
    fn take_for_end(&mut self) {
        let token = self.token();
        if token.kind != Kind::Word || self.keyword() != Keyword::None {
            return;
        }
        let follows = self.ahead(1).kind;
        if matches!(follows, Kind::Assign | Kind::Dot | Kind::OpenSquare) {
            return;
        }
        let keyword = meant(&self.slice(token.span).to_uppercase());
        let open = match keyword {
            Keyword::Elsif => self.closers.contains(&Keyword::EndIf),
            keyword if keyword.ends_unit() => true,
            keyword => keyword.ends_part() && self.closers.contains(&keyword),
        };
        if open {
            self.tell_other_word(token.span, keyword);
            let at = self.at;
            self.keywords[at] = keyword;
        }
    }

    /// Whether an END that no open statement waits for stands here; it is told and passed over.
    fn stray_end(&mut self, keyword: Keyword) -> bool {
        let waits = |closer: &Keyword| {
            *closer == keyword
                || *closer == Keyword::EndIf && matches!(keyword, Keyword::Else | Keyword::Elsif)
                || *closer == Keyword::EndCase && keyword == Keyword::Else
                || *closer == Keyword::EndRepeat && keyword == Keyword::Until
        };
        if self.closers.iter().any(waits) {
            return false;
        }
        let span = self.token().span;
        let written = self.short(span);
        // One that is open is closed by the wrong word.
        if let Some(closer) = self.closers.last().copied().filter(|c| *c != Keyword::None)
            && !matches!(keyword, Keyword::Else | Keyword::Elsif)
        {
            self.tell(
                Code::StOtherWord,
                span,
                [written.into(), closer.name().into()],
            );
            let at = self.at;
            self.keywords[at] = match closer {
                Keyword::EndRepeat => Keyword::EndRepeat,
                closer => closer,
            };
            return false;
        }
        let opener = opener(keyword);
        self.tell(Code::StStrayEnd, span, [written.into(), opener.into()]);
        self.next();
        true
    }

    /// Goes past the statement that is wrong.
    pub(super) fn recover(&mut self) {
        let start = self.at;
        let mut open = 0_u32;
        while !self.is(Kind::End) {
            let keyword = self.keyword();
            if keyword.ends_unit() || keyword.begins_unit() || keyword.is_section() {
                return;
            }
            if self.ends_in_chart() {
                return;
            }
            if matches!(keyword, Keyword::Then | Keyword::Do | Keyword::Of) {
                let first = self.at == start;
                self.next();
                if !first {
                    self.skip_block();
                }
                return;
            }
            if open == 0 && self.is(Kind::Semicolon) {
                self.next();
                return;
            }
            if open == 0
                && (keyword.ends_part() || keyword.begins_statement())
                && self.on_new_line()
            {
                return;
            }
            // What the wrong statement has opened is passed over with it.
            if matches!(
                keyword,
                Keyword::EndIf
                    | Keyword::EndCase
                    | Keyword::EndFor
                    | Keyword::EndWhile
                    | Keyword::EndRepeat
            ) {
                return;
            }
            if open == 0
                && self.on_new_line()
                && self.is(Kind::Word)
                && matches!(self.ahead(1).kind, Kind::Assign)
            {
                return;
            }
            open += u32::from(self.is(Kind::Open));
            open -= u32::from(self.is(Kind::Close) && open > 0);
            self.next();
        }
    }

    /// Variables that are declared after statements.
    pub(super) fn late_section(&mut self, start: Span) -> Parsed<Option<Statement>> {
        let written = self.short(start);
        if !self.late {
            self.tell(Code::StLateDeclaration, start, [written.into()]);
        }
        self.late = true;
        self.wrong_declarations = true;
        while !self.is(Kind::End) && !self.accept_keyword(Keyword::EndVar) {
            self.next();
        }
        Ok(None)
    }

    /// Whether a declaration stands where a statement is expected: a colon comes before what makes a statement.
    pub(super) fn is_declaration(&self) -> bool {
        if self.closers.contains(&Keyword::EndCase) {
            return false;
        }
        for by in 1..16 {
            match self.ahead(by).kind {
                // `x : = 5` stores.
                Kind::Colon => return self.ahead(by + 1).kind != Kind::Equal,
                Kind::Word | Kind::Comma | Kind::Address => {}
                _ => return false,
            }
            let keyword = self.keyword_ahead(by);
            if !matches!(keyword, Keyword::None | Keyword::At) {
                return false;
            }
        }
        false
    }

    /// Declarations whose VAR or TYPE is missing: they are passed over to their end, if that is there.
    pub(super) fn headless_section(&mut self, start: Span) -> Parsed<Option<Statement>> {
        self.wrong_declarations = true;
        if self.headless {
            return Err(Told);
        }
        let mut by = 0;
        let end = loop {
            let keyword = self.keyword_ahead(by);
            if matches!(keyword, Keyword::EndVar | Keyword::EndType) {
                break Some(keyword);
            }
            let other = keyword.ends_unit() || keyword.begins_unit() || keyword.is_section();
            if other || self.ahead(by).kind == Kind::End {
                break None;
            }
            by += 1;
        };
        let written = self.short(start);
        let (missing, help) = match end {
            Some(Keyword::EndType) => (
                "TYPE",
                (
                    "types are declared between TYPE and END_TYPE",
                    "tipos são declarados entre TYPE e END_TYPE",
                ),
            ),
            _ => (
                "VAR",
                (
                    "variables are declared between VAR and END_VAR",
                    "variáveis são declaradas entre VAR e END_VAR",
                ),
            ),
        };
        self.tell(
            Code::StExpected,
            start,
            [missing.into(), written.into(), help.into()],
        );
        match end {
            Some(_) => {
                for _ in 0..=by {
                    self.next();
                }
                Ok(None)
            }
            None => {
                self.headless = true;
                Err(Told)
            }
        }
    }

    /// Passes over what THEN, DO or OF has begun, to its end.
    pub(super) fn skip_block(&mut self) {
        let mut open = 1_u32;
        while !self.is(Kind::End) {
            let keyword = self.keyword();
            if keyword.ends_unit() || keyword.begins_unit() {
                return;
            }
            let begins = matches!(
                keyword,
                Keyword::If | Keyword::Case | Keyword::For | Keyword::While | Keyword::Repeat
            );
            let ends = matches!(
                keyword,
                Keyword::EndIf
                    | Keyword::EndCase
                    | Keyword::EndFor
                    | Keyword::EndWhile
                    | Keyword::EndRepeat
            );
            self.next();
            open = match (begins, ends) {
                (true, _) => open + 1,
                (_, true) => open - 1,
                _ => open,
            };
            if open == 0 {
                self.accept(Kind::Semicolon);
                return;
            }
        }
    }

    pub(super) fn not_closed(&mut self, start: Span, closer: Keyword) {
        let written = self.short(start);
        self.tell(
            Code::StNotClosed,
            start,
            [written.into(), closer.name().into()],
        );
    }

    pub(super) fn wrong_node(&self, span: Span) -> Node {
        Node {
            kind: NodeKind::Wrong,
            span,
            height: 1,
        }
    }

    /// After a head that is wrong, to where its statements begin: its line ends, or THEN, DO, OF stand.
    pub(super) fn seek_part(&mut self) {
        while !self.is(Kind::End) {
            let keyword = self.keyword();
            if matches!(keyword, Keyword::Then | Keyword::Do | Keyword::Of) {
                self.next();
                return;
            }
            if self.on_new_line()
                || keyword.ends_part()
                || keyword.ends_unit()
                || self.is(Kind::Semicolon)
            {
                return;
            }
            self.next();
        }
    }
}
