//! What variables begin with.

use super::super::ast::{Init, Node, SpecKind, TypeSpec};
use super::super::token::Kind;
use super::declare::NAME;
use super::{Parsed, Parser, Told};
use unoclp_text::diagnostics::Code;
use unoclp_tree::Base;

impl Parser<'_, '_> {
    /// What a variable begins with.
    pub(super) fn initial(&mut self, spec: &TypeSpec) -> Parsed<Init> {
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
                    "write the initial values of an array like [1, 2, 3(0)]",
                    "escreva os valores iniciais de uma matriz como [1, 2, 3(0)]",
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
                    "write the initial values of a structure like (x := 1, y := 2)",
                    "escreva os valores iniciais de uma estrutura como (x := 1, y := 2)",
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
        let help = (
            "write ) after the repeated value",
            "escreva ) depois do valor repetido",
        );
        self.expect(Kind::Close, ")", help)?;
        Ok((Some(times), Some(inner)))
    }

    /// A number alone.
    fn count(&mut self) -> Parsed<Node> {
        let token = self.next();
        let read = unoclp_tree::literal::number(self.slice(token.span));
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
}
