//! Types as they are written.

use super::super::ast::{Name, Node, SpecKind, TypeDecl, TypeSpec};
use super::super::token::Kind;
use super::super::words::Keyword;
use super::declare::NAME;
use super::{Parsed, Parser, Told};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::Base;

impl Parser<'_, '_> {
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
                "VAR_IN_OUT passes a variable to a function or a block by reference",
                "VAR_IN_OUT passa uma variável por referência a uma função ou a um bloco",
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
        let help = (
            "write a range like 1..10",
            "escreva um intervalo como 1..10",
        );
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

    fn enumeration(&mut self) -> Parsed<Vec<(Name, Option<Node>)>> {
        self.next();
        let help = (
            "an enumeration is a list of names in ( ): (Red, Green)",
            "uma enumeração é uma lista de nomes entre ( ): (Verde, Vermelho)",
        );
        let mut values = Vec::new();
        loop {
            // `Color#Red` is Red.
            let token = self.token();
            let name = if token.kind == Kind::Typed {
                self.next();
                let start =
                    token.span.start + self.slice(token.span).find('#').unwrap_or(0) as u32 + 1;
                self.named(Span {
                    start,
                    ..token.span
                })
            } else {
                self.name(NAME, help)?
            };
            if self.is(Kind::Equal) {
                let span = self.token().span;
                let written = name.text.clone();
                self.tell(Code::StEqualsForAssign, span, [written.into()]);
                return Err(Told);
            }
            let number = match self.accept(Kind::Assign) {
                true => Some(self.expression()?),
                false => None,
            };
            values.push((name, number));
            if !self.accept(Kind::Comma) {
                break;
            }
        }
        self.expect(Kind::Close, ")", help)?;
        // `(Red, Green) INT`: its values are numbers of INT in any case.
        let word = self.slice(self.token().span).to_uppercase();
        if Base::named(&word).is_some_and(|base| base.is_int()) {
            self.next();
        }
        Ok(values)
    }

    fn array(&mut self) -> Parsed<SpecKind> {
        const HELP: (&str, &str) = (
            "write an array like ARRAY[1..10] OF INT",
            "escreva uma matriz como ARRAY[1..10] OF INT",
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

    /// TYPE … END_TYPE
    pub(in super::super) fn types(&mut self, all: &mut Vec<TypeDecl>) {
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
            "declare a type like Name : INT;",
            "declare um tipo como Nome : INT;",
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
