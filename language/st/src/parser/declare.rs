//! Declarations: sections of variables.

use super::super::ast::{Decl, Name, Section, Vars};
use super::super::token::Kind;
use super::super::words::Keyword;
use super::{Parsed, Parser, Told};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::Base;
use unoclp_tree::build::Edge;

pub(super) const NAME: (&str, &str) = ("a name", "um nome");
const DECLARATION: (&str, &str) = (
    "a declaration is a name, a colon, a type and a semicolon: x : INT;",
    "uma declaração é um nome, dois-pontos, um tipo e ponto e vírgula: x : INT;",
);

impl Parser<'_, '_> {
    /// VAR … END_VAR
    pub(super) fn section(&mut self) -> Vars {
        let start = self.token().span;
        if self.keyword() == Keyword::VarAccess {
            return self.access();
        }
        let section = match self.keyword() {
            Keyword::VarInput => Section::Input,
            Keyword::VarOutput => Section::Output,
            Keyword::VarInOut => Section::InOut,
            Keyword::VarTemp => Section::Temp,
            Keyword::VarGlobal => Section::Global,
            Keyword::VarExternal => Section::External,
            Keyword::VarConfig => {
                let written = self.short(start);
                let help = (
                    "it needs a CONFIGURATION, and the board has none; delete it",
                    "ele depende de uma CONFIGURATION, que a placa não tem; apague-o",
                );
                self.tell(Code::StUnsupported, start, [written.into(), help.into()]);
                Section::Var
            }
            _ => Section::Var,
        };
        self.next();
        let mut vars = Vars {
            section,
            constant: false,
            retain: false,
            decls: Vec::new(),
        };
        loop {
            match self.keyword() {
                Keyword::Constant => vars.constant = true,
                Keyword::Retain | Keyword::Persistent => vars.retain = true,
                Keyword::NonRetain => {}
                _ => break,
            }
            self.next();
        }
        vars.decls = self.declarations(Keyword::EndVar, start);
        self.accept(Kind::Semicolon);
        vars
    }

    /// VAR_ACCESS … END_VAR: names by which others ask for variables. They change nothing of what the program does.
    fn access(&mut self) -> Vars {
        let start = self.next().span;
        let written = self.short(start);
        self.tell(Code::StAccess, start, [written.into()]);
        while !self.accept_keyword(Keyword::EndVar) {
            let keyword = self.keyword();
            if self.is(Kind::End) || keyword.ends_unit() || keyword.begins_unit() {
                let words = [self.short(start).into(), Keyword::EndVar.name().into()];
                self.tell(Code::StNotClosed, start, words);
                break;
            }
            self.next();
        }
        Vars {
            section: Section::Var,
            constant: false,
            retain: false,
            decls: Vec::new(),
        }
    }

    /// Declarations up to their end.
    pub(super) fn declarations(&mut self, end: Keyword, start: Span) -> Vec<Decl> {
        let mut all = Vec::new();
        loop {
            while self.accept(Kind::Semicolon) {}
            if self.accept_keyword(end) {
                return all;
            }
            let token = self.token();
            let keyword = self.keyword();
            let slip = token.kind == Kind::Word
                && keyword == Keyword::None
                && super::meant(&self.slice(token.span).to_uppercase()) == end;
            if slip {
                self.tell_other_word(token.span, end);
                self.next();
                return all;
            }
            // Where statements or another section begin, this one has been left open.
            let statement = token.kind == Kind::Word
                && keyword == Keyword::None
                && matches!(self.ahead(1).kind, Kind::Assign | Kind::Open);
            let named = matches!(self.ahead(1).kind, Kind::Colon | Kind::Comma);
            let other = !named
                && (keyword.is_section()
                    || keyword.ends_unit()
                    || keyword.begins_unit()
                    || keyword.begins_statement());
            if token.kind == Kind::End
                || statement
                || other
                || matches!(
                    keyword,
                    Keyword::EndVar | Keyword::EndStruct | Keyword::EndType
                )
            {
                let written = self.short(start);
                self.tell(
                    Code::StNotClosed,
                    start,
                    [written.into(), end.name().into()],
                );
                self.wrong_declarations = true;
                return all;
            }
            let before = self.at;
            match self.declaration() {
                Ok(decl) => all.push(decl),
                Err(Told) => self.behind_declaration(),
            }
            if self.at == before {
                self.next();
            }
        }
    }

    pub(super) fn behind_declaration(&mut self) {
        self.wrong_declarations = true;
        while !self.is(Kind::End) {
            let keyword = self.keyword();
            let ends = matches!(
                keyword,
                Keyword::EndVar | Keyword::EndStruct | Keyword::EndType
            );
            if ends || keyword.is_section() || keyword.ends_unit() || keyword.begins_unit() {
                return;
            }
            if self.is(Kind::Semicolon) {
                self.next();
                return;
            }
            if self.on_new_line()
                && self.is(Kind::Word)
                && matches!(self.ahead(1).kind, Kind::Colon)
            {
                return;
            }
            self.next();
        }
    }

    /// `AT %IX1`, which stands before the colon by the standard, and after the type in texts of other tools.
    fn located(&mut self) -> Parsed<Option<Name>> {
        if !self.accept_keyword(Keyword::At) {
            return Ok(None);
        }
        let token = self.token();
        if token.kind != Kind::Address {
            let what = ("an address like %IX1", "um endereço como %IX1");
            let help = (
                "after AT, write a point of the board: %IX1, %QX1, %MX1",
                "depois de AT, escreva um ponto da placa: %IX1, %QX1, %MX1",
            );
            return Err(self.missing(what, help));
        }
        self.next();
        let written = self.slice(token.span);
        let is_open = !written.ends_with(|last: char| last.is_ascii_digit());
        if is_open && self.is(Kind::Star) {
            let star = self.next().span;
            self.open_place(token.span.to(star));
            return Ok(None);
        }
        Ok(Some(self.named(token.span)))
    }

    /// `%M*`: any place among the markers or registers serves; an input or output has a wire, so its place must be told.
    fn open_place(&mut self, at: Span) {
        let written = self.slice(at).to_uppercase();
        if written.starts_with("%M") {
            return;
        }
        let help = (
            "it has no fixed address; write a point of the board, such as %IX0.0 or %QX0.0",
            "ele não tem endereço fixo; escreva um ponto da placa, como %IX0.0 ou %QX0.0",
        );
        self.tell(Code::StUnsupported, at, [written.into(), help.into()]);
    }

    /// The names, and where they stand. A point may be declared without a name: then it is its own, `AT %QW5 : WORD`.
    fn names(&mut self) -> Parsed<(Vec<Name>, Option<Name>)> {
        if self.keyword() == Keyword::At
            && self.ahead(1).kind == Kind::Address
            && let Some(point) = self.located()?
        {
            return Ok((vec![point.clone()], Some(point)));
        }
        let mut names = vec![self.name(NAME, DECLARATION)?];
        while self.accept(Kind::Comma) {
            names.push(self.name(NAME, DECLARATION)?);
        }
        Ok((names, self.located()?))
    }

    pub(in super::super) fn declaration(&mut self) -> Parsed<Decl> {
        // `INT x;`
        let (first, second) = (self.token(), self.ahead(1));
        if first.kind == Kind::Word
            && second.kind == Kind::Word
            && self.keyword_ahead(1) == Keyword::None
        {
            let (ty, name) = (
                self.slice(first.span).to_owned(),
                self.slice(second.span).to_owned(),
            );
            if Base::named(&ty.to_uppercase()).is_some() {
                let span = first.span.to(second.span);
                self.tell(Code::StTypeFirst, span, [ty.into(), name.into()]);
                return Err(Told);
            }
        }
        let (names, mut at) = self.names()?;
        if self.is(Kind::Assign) || self.is(Kind::Equal) {
            let what = ("a type", "um tipo");
            return Err(self.missing(what, DECLARATION));
        }
        self.expect(Kind::Colon, ":", DECLARATION)?;
        let spec = self.spec()?;
        if at.is_none() {
            at = self.located()?;
        }
        let edge = self.edge();
        let mut initial = None;
        if self.is(Kind::Equal) {
            let span = self.next().span;
            let written = names
                .first()
                .map(|name| name.text.clone())
                .unwrap_or_default();
            self.tell(Code::StEqualsForAssign, span, [written.into()]);
            initial = Some(self.initial(&spec)?);
        } else if self.accept(Kind::Assign) {
            initial = Some(self.initial(&spec)?);
        }
        if !self.accept(Kind::Semicolon) {
            let help = (
                "each declaration ends with ;",
                "cada declaração termina com ;",
            );
            let told = self.missing(("`;`", "`;`"), help);
            let goes_on = self.keyword() == Keyword::EndVar
                || self.keyword() == Keyword::EndStruct
                || self.is(Kind::Word) && matches!(self.ahead(1).kind, Kind::Colon | Kind::Comma);
            if !goes_on {
                return Err(told);
            }
        }
        Ok(Decl {
            names,
            at,
            spec,
            initial,
            edge,
        })
    }

    /// `R_EDGE` or `F_EDGE`, behind a type.
    fn edge(&mut self) -> Option<Edge> {
        let span = self.token().span;
        let edge = Edge::named(self.slice(span), span)?;
        self.next();
        Some(edge)
    }
}
