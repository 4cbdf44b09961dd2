//! Statements: assignments, calls, and what ends each.

use super::super::ast::{NodeKind, Path, Statement, StatementKind};
use super::super::token::Kind;
use super::super::words::{Keyword, meant};
use super::enable::enabled;
use super::{Parsed, Parser, Told};
use unoclp_text::diagnostics::{Code, Span, Word};

const SEMICOLON: (&str, &str) = ("each statement ends with ;", "cada comando termina com ;");

impl Parser<'_, '_> {
    /// Statements up to what ends them.
    pub(super) fn statements(&mut self) -> Vec<Statement> {
        let mut all = Vec::new();
        loop {
            while self.accept(Kind::Semicolon) {}
            let before = self.at;
            if self.ends_statements() {
                return all;
            }
            if self.at != before {
                continue;
            }
            match self.statement() {
                Ok(Some(statement)) => all.push(statement),
                Ok(None) => {}
                Err(Told) => self.recover(),
            }
            if self.at == before {
                self.next();
            }
        }
    }

    fn statement(&mut self) -> Parsed<Option<Statement>> {
        self.deeper()?;
        let read = self.any_statement();
        self.open -= 1;
        read
    }

    fn any_statement(&mut self) -> Parsed<Option<Statement>> {
        let start = self.token().span;
        let keyword = self.statement_keyword();
        let kind = match keyword {
            Keyword::If => return self.if_statement(start).map(Some),
            Keyword::Case => self.case_statement(start)?,
            Keyword::For => self.for_statement(start)?,
            Keyword::While => self.while_statement(start)?,
            Keyword::Repeat => self.repeat_statement(start)?,
            Keyword::Exit | Keyword::Continue | Keyword::Return => {
                self.next();
                let kind = match keyword {
                    Keyword::Exit => StatementKind::Exit,
                    Keyword::Continue => StatementKind::Continue,
                    _ => StatementKind::Return,
                };
                if keyword == Keyword::Return && !self.is(Kind::Semicolon) && !self.on_new_line() {
                    let written = "RETURN x";
                    let help = (
                        "store the result in the function's name, F := x; and write RETURN; alone",
                        "guarde o resultado no nome da função, F := x; e escreva só RETURN;",
                    );
                    self.tell(Code::StUnsupported, start, [written.into(), help.into()]);
                    return Err(Told);
                }
                self.end_of_statement(false)?;
                return Ok(Some(Statement { kind, span: start }));
            }
            Keyword::Region => {
                self.next();
                while !self.on_new_line() && !self.is(Kind::End) {
                    self.next();
                }
                return Ok(None);
            }
            Keyword::EndRegion => {
                self.next();
                return Ok(None);
            }
            Keyword::Goto => {
                let help = (
                    "IF, CASE and loops decide what is done; EXIT leaves a loop",
                    "IF, CASE e laços decidem o que é feito; EXIT sai de um laço",
                );
                self.tell(Code::StUnsupported, start, ["GOTO".into(), help.into()]);
                return Err(Told);
            }
            keyword if keyword.is_section() => return self.late_section(start),
            Keyword::None if self.other_dialect() => return Err(Told),
            Keyword::None => return self.simple_statement(start),
            _ => {
                let what = ("a statement", "um comando");
                let help = (
                    "a statement begins with a variable, IF, CASE, FOR, WHILE, REPEAT, EXIT or RETURN",
                    "um comando começa com uma variável, IF, CASE, FOR, WHILE, REPEAT, EXIT ou RETURN",
                );
                return Err(self.missing(what, help));
            }
        };
        self.accept(Kind::Semicolon);
        let span = start.to(self.behind());
        Ok(Some(Statement { kind, span }))
    }

    /// The keyword here, or the one that another language's word stands for.
    fn statement_keyword(&mut self) -> Keyword {
        let token = self.token();
        if self.keyword() != Keyword::None || token.kind != Kind::Word {
            return self.keyword();
        }
        let follows = self.ahead(1).kind;
        if matches!(follows, Kind::Assign | Kind::Dot | Kind::OpenSquare) {
            return Keyword::None;
        }
        let keyword = meant(&self.slice(token.span).to_uppercase());
        if keyword.begins_statement() && follows != Kind::Open {
            self.tell_other_word(token.span, keyword);
            let at = self.at;
            self.keywords[at] = keyword;
            return keyword;
        }
        Keyword::None
    }

    pub(super) fn tell_other_word(&mut self, span: Span, keyword: Keyword) {
        let written = self.slice(span).to_owned();
        self.tell(
            Code::StOtherWord,
            span,
            [written.into(), keyword.name().into()],
        );
    }

    /// An assignment or a call.
    fn simple_statement(&mut self, start: Span) -> Parsed<Option<Statement>> {
        if !matches!(self.kind(), Kind::Word | Kind::Address) {
            return Err(self.no_statement());
        }
        // `END IF`
        let word = self.slice(start).to_uppercase();
        if word == "END" && self.ahead(1).kind == Kind::Word && !self.closers.is_empty() {
            let closer = format!("END_{}", self.slice(self.ahead(1).span).to_uppercase());
            let keyword = Keyword::of(&closer);
            if keyword != Keyword::None {
                let span = start.to(self.ahead(1).span);
                self.tell_other_word(span, keyword);
                self.next();
                let at = self.at;
                self.keywords[at] = keyword;
                return Ok(None);
            }
        }
        if self.is_declaration() {
            return self.headless_section(start);
        }
        let path = self.path()?;
        match self.kind() {
            Kind::Word if matches!(self.keyword(), Keyword::Then | Keyword::Do | Keyword::Of) => {
                let missing = match self.keyword() {
                    Keyword::Then => "IF",
                    Keyword::Do => "WHILE",
                    _ => "CASE",
                };
                let written = self.short(path.span);
                let help = (
                    "complete the pair: IF … THEN, WHILE … DO, CASE … OF",
                    "complete o par: IF … THEN, WHILE … DO, CASE … OF",
                );
                let words = [missing.into(), written.into(), help.into()];
                self.tell(Code::StExpected, path.span, words);
                self.next();
                self.skip_block();
                Ok(None)
            }
            Kind::Assign => {
                self.next();
                self.closers.push(Keyword::None);
                let value = self.expression();
                self.closers.pop();
                let mut value = value?;
                let span = start.to(value.span);
                self.end_of_statement(true)?;
                let enable = match &mut value.kind {
                    NodeKind::Call(_, arguments) => self.enable(arguments),
                    _ => None,
                };
                let kind = StatementKind::Assign(path, value);
                Ok(Some(enabled(enable, Statement { kind, span })))
            }
            Kind::Open => {
                let (mut arguments, close) = self.arguments()?;
                let span = start.to(close);
                self.end_of_statement(false)?;
                let enable = self.enable(&mut arguments);
                let kind = StatementKind::Call(path, arguments);
                Ok(Some(enabled(enable, Statement { kind, span })))
            }
            Kind::Equal => {
                let span = self.token().span;
                let target = self.short(path.span);
                self.tell(Code::StEqualsForAssign, span, [target.into()]);
                Err(Told)
            }
            Kind::Foreign => Err(self.foreign(&path)),
            Kind::Colon => {
                let what = ("`:=`", "`:=`");
                let help = (
                    "to store a value, write := without a space",
                    "para guardar um valor, escreva := sem espaço",
                );
                Err(self.missing(what, help))
            }
            Kind::Word | Kind::Number if !self.on_new_line() => {
                let what = ("`:=`", "`:=`");
                let help = (
                    "to store a value, write :=",
                    "para guardar um valor, escreva :=",
                );
                Err(self.missing(what, help))
            }
            Kind::Arrow => {
                let span = self.token().span;
                self.tell(Code::StOtherWord, span, ["=>".into(), ":=".into()]);
                Err(Told)
            }
            Kind::LessEqual | Kind::Less if self.keyword() == Keyword::None => {
                let span = self.token().span;
                let sign = self.slice(span).to_owned();
                self.tell(Code::StOtherWord, span, [sign.into(), ":=".into()]);
                Err(Told)
            }
            _ => {
                let written = self.short(path.span);
                self.tell(Code::StNoEffect, path.span, [written.into()]);
                Err(Told)
            }
        }
    }

    /// `x += 1`, `x++`
    fn foreign(&mut self, path: &Path) -> Told {
        let span = self.token().span;
        let (sign, name) = (self.short(span), self.short(path.span));
        let meant = match sign.as_str() {
            "++" => format!("{name} := {name} + 1"),
            "--" => format!("{name} := {name} - 1"),
            "{" | "}" => "THEN … END_IF".to_owned(),
            _ => format!("{name} := {name} {} …", sign.trim_end_matches('=')),
        };
        self.tell(Code::StOtherWord, span, [sign.into(), meant.into()]);
        Told
    }

    fn no_statement(&mut self) -> Told {
        let span = self.token().span;
        if self.is(Kind::ForeignCode) {
            self.tell(Code::StForeignCode, span, ["PROGRAM".into()]);
            self.next();
            return Told;
        }
        if self.is(Kind::Foreign) {
            let sign = self.short(span);
            let meant: Word = match sign.as_str() {
                "{" => ("THEN or DO", "THEN ou DO").into(),
                "}" => (
                    "END_IF, END_FOR or END_WHILE",
                    "END_IF, END_FOR ou END_WHILE",
                )
                    .into(),
                _ => "x := x + 1".into(),
            };
            self.tell(Code::StOtherWord, span, [sign.into(), meant]);
            return Told;
        }
        let what = ("a statement", "um comando");
        let help = (
            "a statement begins with a variable, IF, CASE, FOR, WHILE, REPEAT, EXIT or RETURN",
            "um comando começa com uma variável, IF, CASE, FOR, WHILE, REPEAT, EXIT ou RETURN",
        );
        self.missing(what, help)
    }

    /// The `;` after a statement.
    fn end_of_statement(&mut self, value: bool) -> Parsed<()> {
        if self.accept(Kind::Semicolon) {
            return Ok(());
        }
        // `2,5`
        if value && self.is(Kind::Comma) && self.ahead(1).kind == Kind::Number {
            let before = self.behind();
            let span = before.to(self.ahead(1).span);
            let written = self.short(span);
            let meant = written.replace(',', ".").replace(' ', "");
            self.tell(Code::StOtherWord, span, [written.into(), meant.into()]);
            return Err(Told);
        }
        if self.is(Kind::Assign) || self.is(Kind::Equal) {
            return Err(self.missing(("`;`", "`;`"), SEMICOLON));
        }
        if self.is(Kind::Close) {
            let span = self.token().span;
            self.tell(Code::StStrayEnd, span, [")".into(), "(".into()]);
            return Err(Told);
        }
        let told = self.missing(("`;`", "`;`"), SEMICOLON);
        // Where the next statement begins, it is read.
        match self.on_new_line() || self.keyword() != Keyword::None {
            true => Ok(()),
            false => Err(told),
        }
    }
}
