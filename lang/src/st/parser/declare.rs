//! Declarations: variables with what they begin with, and types.

use super::super::ast::{Decl, Init, Name, Node, Section, SpecKind, TypeDecl, TypeSpec, Vars};
use super::super::lexer::Kind;
use super::super::words::Keyword;
use super::{Parsed, Parser, Told};
use crate::diagnostics::{Code, Span};
use crate::typed::Base;

const NAME: (&str, &str) = ("a name", "um nome");
const DECLARATION: (&str, &str) = (
    "a declaration is a name, a colon, a type and a semicolon: x : INT;",
    "uma declaração é um nome, dois-pontos, um tipo e ponto e vírgula: x : INT;",
);

impl Parser<'_, '_> {
    /// VAR … END_VAR
    pub(super) fn section(&mut self) -> Vars {
        let start = self.token().span;
        let section = match self.keyword() {
            Keyword::VarInput => Section::Input,
            Keyword::VarOutput => Section::Output,
            Keyword::VarInOut => Section::InOut,
            Keyword::VarTemp => Section::Temp,
            Keyword::VarGlobal => Section::Global,
            Keyword::VarExternal => Section::External,
            Keyword::VarAccess | Keyword::VarConfig => {
                let written = self.short(start);
                let help = (
                    "it belongs to a CONFIGURATION, which the board has not; delete it",
                    "isso pertence a uma CONFIGURATION, que a placa não tem; apague-o",
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

    /// Declarations up to their end.
    fn declarations(&mut self, end: Keyword, start: Span) -> Vec<Decl> {
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

    fn behind_declaration(&mut self) {
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

    fn declaration(&mut self) -> Parsed<Decl> {
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
        let mut names = vec![self.name(NAME, DECLARATION)?];
        while self.accept(Kind::Comma) {
            names.push(self.name(NAME, DECLARATION)?);
        }
        let mut at = None;
        if self.accept_keyword(Keyword::At) {
            let token = self.token();
            if token.kind != Kind::Address {
                let what = ("an address like %IX1", "um endereço como %IX1");
                let help = (
                    "behind AT stands a point of the board: %IX1, %QX1, %MX1",
                    "depois de AT vem um ponto da placa: %IX1, %QX1, %MX1",
                );
                return Err(self.missing(what, help));
            }
            self.next();
            at = Some(self.named(token.span));
        }
        if self.is(Kind::Assign) || self.is(Kind::Equal) {
            let what = ("a type", "um tipo");
            return Err(self.missing(what, DECLARATION));
        }
        self.expect(Kind::Colon, ":", DECLARATION)?;
        let spec = self.spec()?;
        let edge = self.slice(self.token().span).to_uppercase();
        if matches!(edge.as_str(), "R_EDGE" | "F_EDGE") {
            let span = self.token().span;
            let help = (
                "declare an R_TRIG or F_TRIG, call it with the input, and read its Q",
                "declare um R_TRIG ou F_TRIG, chame-o com a entrada e leia o seu Q",
            );
            self.tell(Code::StUnsupported, span, [edge.into(), help.into()]);
            return Err(Told);
        }
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
        })
    }

    /// A type as it stands in a declaration.
    pub(super) fn spec(&mut self) -> Parsed<TypeSpec> {
        self.deeper()?;
        let read = self.spec_within();
        self.open -= 1;
        read
    }

    fn spec_within(&mut self) -> Parsed<TypeSpec> {
        let start = self.token().span;
        let kind = match (self.kind(), self.keyword()) {
            (Kind::Open, _) => SpecKind::Enum(self.enumeration()?),
            (Kind::Word, Keyword::Array) => self.array()?,
            (Kind::Word, Keyword::Struct) => {
                self.next();
                SpecKind::Struct(self.declarations(Keyword::EndStruct, start))
            }
            (Kind::Word, _) => self.named_spec(start)?,
            _ => {
                let what = ("a type", "um tipo");
                let help = (
                    "write a type like BOOL, INT, REAL or TIME",
                    "escreva um tipo como BOOL, INT, REAL ou TIME",
                );
                return Err(self.missing(what, help));
            }
        };
        let span = start.to(self.behind());
        Ok(TypeSpec { kind, span })
    }

    fn named_spec(&mut self, start: Span) -> Parsed<SpecKind> {
        let upper = self.slice(start).to_uppercase();
        if matches!(upper.as_str(), "POINTER" | "REF_TO" | "REFERENCE") {
            let help = (
                "VAR_IN_OUT lends a variable to a function or a block",
                "VAR_IN_OUT empresta uma variável a uma função ou a um bloco",
            );
            self.tell(Code::StUnsupported, start, [upper.into(), help.into()]);
            return Err(Told);
        }
        let what = ("a type", "um tipo");
        let help = (
            "write a type like BOOL, INT, REAL or TIME",
            "escreva um tipo como BOOL, INT, REAL ou TIME",
        );
        let name = self.name(what, help)?;
        let text = match upper.as_str() {
            "STRING" => Some(Base::Str),
            "WSTRING" => Some(Base::Wstr),
            _ => None,
        };
        if let Some(base) = text {
            let close = match self.kind() {
                Kind::OpenSquare => Kind::CloseSquare,
                Kind::Open => Kind::Close,
                _ => return Ok(SpecKind::Text(base, None)),
            };
            self.next();
            let most = self.expression()?;
            let help = ("close the length", "feche o comprimento");
            self.expect(close, if close == Kind::Close { ")" } else { "]" }, help)?;
            return Ok(SpecKind::Text(base, Some(Box::new(most))));
        }
        if self.is(Kind::Open) {
            self.next();
            let range = self.range()?;
            self.expect(Kind::Close, ")", ("close the range", "feche o intervalo"))?;
            return Ok(SpecKind::Range(name, Box::new(range)));
        }
        Ok(SpecKind::Named(name))
    }

    fn range(&mut self) -> Parsed<(Node, Node)> {
        let low = self.expression()?;
        let help = ("a range is written 1..10", "um intervalo se escreve 1..10");
        if self.is(Kind::Colon) || self.is(Kind::Minus) || self.keyword() == Keyword::To {
            let span = self.next().span;
            let written = self.short(span);
            self.tell(Code::StOtherWord, span, [written.into(), "..".into()]);
        } else {
            self.expect(Kind::Range, "..", help)?;
        }
        let high = self.expression()?;
        Ok((low, high))
    }

    fn enumeration(&mut self) -> Parsed<Vec<Name>> {
        self.next();
        let help = (
            "an enumeration is names in ( ): (Red, Green)",
            "uma enumeração são nomes entre ( ): (Verde, Vermelho)",
        );
        let mut names = Vec::new();
        loop {
            // `Color#Red` is Red.
            let token = self.token();
            if token.kind == Kind::Typed {
                self.next();
                let start =
                    token.span.start + self.slice(token.span).find('#').unwrap_or(0) as u32 + 1;
                names.push(self.named(Span {
                    start,
                    ..token.span
                }));
            } else {
                names.push(self.name(NAME, help)?);
            }
            if !self.accept(Kind::Comma) {
                break;
            }
        }
        if self.is(Kind::Assign) || self.is(Kind::Equal) {
            let span = self.token().span;
            let help = (
                "values of an enumeration count from 0 by themselves: (Red, Green)",
                "os valores de uma enumeração contam sozinhos a partir de 0: (Verde, Vermelho)",
            );
            let what = (
                "a number for a value of an enumeration",
                "um número para um valor de enumeração",
            );
            self.tell(Code::StUnsupported, span, [what.into(), help.into()]);
            return Err(Told);
        }
        self.expect(Kind::Close, ")", help)?;
        Ok(names)
    }

    fn array(&mut self) -> Parsed<SpecKind> {
        const HELP: (&str, &str) = (
            "an array is written ARRAY[1..10] OF INT",
            "uma matriz se escreve ARRAY[1..10] OF INT",
        );
        self.next();
        if self.is(Kind::Open) {
            let span = self.token().span;
            self.tell(Code::StOtherWord, span, ["(".into(), "[".into()]);
            return Err(Told);
        }
        self.expect(Kind::OpenSquare, "[", HELP)?;
        let mut bounds = vec![self.bound(HELP)?];
        while self.accept(Kind::Comma) {
            bounds.push(self.bound(HELP)?);
        }
        self.expect(Kind::CloseSquare, "]", HELP)?;
        self.expect_keyword(Keyword::Of, HELP)?;
        let of = self.spec()?;
        Ok(SpecKind::Array(bounds, Box::new(of)))
    }

    /// `1..10`; `[10]` of other languages is told.
    fn bound(&mut self, help: (&str, &str)) -> Parsed<(Node, Node)> {
        let (token, next) = (self.token(), self.ahead(1));
        if token.kind == Kind::Number && next.kind == Kind::CloseSquare {
            let written = self.short(token.span);
            let meant = match written.parse::<u32>() {
                Ok(count) if count > 0 => format!("0..{}", count - 1),
                _ => "1..10".to_owned(),
            };
            self.tell(
                Code::StOtherWord,
                token.span,
                [written.into(), meant.into()],
            );
            return Err(Told);
        }
        let _ = help;
        self.range()
    }

    /// What a variable begins with.
    fn initial(&mut self, spec: &TypeSpec) -> Parsed<Init> {
        let first = self.one_initial()?;
        // Elements without [ ], as older texts have them.
        let bare =
            self.is(Kind::Comma) && matches!(spec.kind, SpecKind::Array(..) | SpecKind::Named(_));
        let decimal = matches!(spec.kind, SpecKind::Named(ref name) if Base::named(&name.text.to_uppercase()).is_some());
        if bare && decimal {
            let before = self.behind();
            let span = before.to(self.ahead(1).span);
            let written = self.short(span);
            let meant = written.replace(',', ".").replace(' ', "");
            self.tell(Code::StOtherWord, span, [written.into(), meant.into()]);
            return Err(Told);
        }
        if !bare {
            return Ok(first);
        }
        let start = self.behind();
        let mut all = vec![(None, Some(first))];
        while self.accept(Kind::Comma) {
            all.push(self.element()?);
        }
        let span = start.to(self.behind());
        Ok(Init::Elements(all, span))
    }

    fn one_initial(&mut self) -> Parsed<Init> {
        self.deeper()?;
        let read = self.initial_within();
        self.open -= 1;
        read
    }

    fn initial_within(&mut self) -> Parsed<Init> {
        let start = self.token().span;
        match self.kind() {
            Kind::OpenSquare => {
                self.next();
                let mut all = Vec::new();
                let help = (
                    "first values of an array are written [1, 2, 3(0)]",
                    "os primeiros valores de uma matriz se escrevem [1, 2, 3(0)]",
                );
                while !self.is(Kind::CloseSquare) {
                    all.push(self.element()?);
                    if !self.accept(Kind::Comma) {
                        break;
                    }
                }
                let close = self.expect(Kind::CloseSquare, "]", help)?;
                Ok(Init::Elements(all, start.to(close)))
            }
            Kind::Open
                if self.ahead(1).kind == Kind::Word && self.ahead(2).kind == Kind::Assign =>
            {
                self.next();
                let mut all = Vec::new();
                let help = (
                    "first values of a structure are written (x := 1, y := 2)",
                    "os primeiros valores de uma estrutura se escrevem (x := 1, y := 2)",
                );
                loop {
                    let span = self.token().span;
                    if !self.is(Kind::Word) {
                        return Err(self.missing(NAME, help));
                    }
                    self.next();
                    let name = self.named(span);
                    self.expect(Kind::Assign, ":=", help)?;
                    all.push((name, self.one_initial()?));
                    if !self.accept(Kind::Comma) {
                        break;
                    }
                }
                let close = self.expect(Kind::Close, ")", help)?;
                Ok(Init::Members(all, start.to(close)))
            }
            _ => Ok(Init::Value(self.expression()?)),
        }
    }

    /// One element, or `3(0)` for three.
    fn element(&mut self) -> Parsed<(Option<Node>, Option<Init>)> {
        let repeats = matches!(self.kind(), Kind::Number) && self.ahead(1).kind == Kind::Open;
        if !repeats {
            return Ok((None, Some(self.one_initial()?)));
        }
        let times = self.count()?;
        self.next();
        if self.accept(Kind::Close) {
            return Ok((Some(times), None));
        }
        let inner = self.one_initial()?;
        // 2(1, 2) repeats both.
        let help = ("close what is repeated", "feche o que se repete");
        self.expect(Kind::Close, ")", help)?;
        Ok((Some(times), Some(inner)))
    }

    /// A number alone.
    fn count(&mut self) -> Parsed<Node> {
        let token = self.next();
        let read = super::super::literal::number(self.slice(token.span));
        match read {
            Ok((base, value)) => Ok(Node {
                kind: super::super::ast::NodeKind::Literal(base, value),
                span: token.span,
                height: 1,
            }),
            Err(fault) => {
                let written = self.short(token.span);
                self.tell(
                    Code::StLiteral,
                    token.span,
                    [written.into(), fault.what, fault.like],
                );
                Err(Told)
            }
        }
    }

    /// TYPE … END_TYPE
    pub(super) fn types(&mut self, all: &mut Vec<TypeDecl>) {
        let start = self.next().span;
        loop {
            while self.accept(Kind::Semicolon) {}
            if self.accept_keyword(Keyword::EndType) {
                return;
            }
            let keyword = self.keyword();
            if self.is(Kind::End)
                || keyword.begins_unit()
                || keyword.ends_unit()
                || keyword.is_section()
            {
                let written = self.short(start);
                self.tell(
                    Code::StNotClosed,
                    start,
                    [written.into(), "END_TYPE".into()],
                );
                return;
            }
            let before = self.at;
            match self.type_declaration() {
                Ok(ty) => all.push(ty),
                Err(Told) => self.behind_declaration(),
            }
            if self.at == before {
                self.next();
            }
        }
    }

    fn type_declaration(&mut self) -> Parsed<TypeDecl> {
        let help = (
            "a type is declared as Name : INT;",
            "um tipo se declara como Nome : INT;",
        );
        let name = self.name(NAME, help)?;
        self.expect(Kind::Colon, ":", help)?;
        let spec = self.spec()?;
        let initial = match self.accept(Kind::Assign) {
            true => Some(self.initial(&spec)?),
            false => None,
        };
        if !self.accept(Kind::Semicolon) && self.keyword() != Keyword::EndType {
            let help = (
                "each declaration ends with ;",
                "cada declaração termina com ;",
            );
            let told = self.missing(("`;`", "`;`"), help);
            if !self.on_new_line() {
                return Err(told);
            }
        }
        Ok(TypeDecl {
            name,
            spec,
            initial,
        })
    }
}
