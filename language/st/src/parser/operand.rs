//! Operands: literals, names, calls, and what stands in parentheses.
//!
//! Owns what is told where a value is missing.

use super::super::ast::{Name, Node, NodeKind, Path};
use super::super::token::Kind;
use super::super::words::Keyword;
use super::expression::UNARY;
use super::{Parsed, Parser};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Base, Value, literal};

const OPERAND: (&str, &str) = ("a value", "um valor");

const OPERAND_HELP: (&str, &str) = (
    "write a number, a variable, or an expression in ( )",
    "escreva um número, uma variável ou uma expressão entre ( )",
);

impl Parser<'_, '_> {
    pub(in super::super) fn operand(&mut self) -> Parsed<Node> {
        let token = self.token();
        let leaf = |kind, span| Node {
            kind,
            span,
            height: 1,
        };
        match (token.kind, self.keyword()) {
            (Kind::Minus, _) | (Kind::Word, Keyword::Not) => {
                self.next();
                let inner = self.binding(UNARY)?;
                let span = token.span.to(inner.span);
                let height = inner.height + 1;
                let inner = Box::new(inner);
                let kind = match token.kind {
                    Kind::Minus => NodeKind::Negate(inner),
                    _ => NodeKind::Not(inner),
                };
                self.node(kind, span, height)
            }
            (Kind::Plus, _) => {
                self.next();
                self.binding(UNARY)
            }
            (Kind::Open, _) => {
                self.next();
                self.closers.push(match self.open_condition() {
                    true => Keyword::Then,
                    false => Keyword::None,
                });
                let inner = self.expression();
                self.closers.pop();
                let mut inner = inner?;
                let help = ("write ) to match the (", "escreva o ) que corresponde ao (");
                let close = self.expect(Kind::Close, ")", help)?;
                inner.span = token.span.to(close);
                Ok(inner)
            }
            (Kind::Number, _) => {
                self.next();
                let read = literal::number(self.slice(token.span));
                Ok(leaf(self.literal(read, token.span), token.span))
            }
            (Kind::Typed, _) => {
                self.next();
                Ok(leaf(self.typed(token.span), token.span))
            }
            (Kind::Text | Kind::Wide, _) => {
                self.next();
                let written = self.slice(token.span);
                let inner = written
                    .get(1..written.len().saturating_sub(1))
                    .unwrap_or_default();
                let base = if token.kind == Kind::Text {
                    Base::Str
                } else {
                    Base::Wstr
                };
                let kind = match literal::characters(inner) {
                    Some(text) => NodeKind::Literal(base, Value::Text(text)),
                    None => {
                        let written = self.short(token.span);
                        let what = (
                            "string: write two hexadecimal digits after $",
                            "string: escreva dois dígitos hexadecimais depois de $",
                        );
                        let like = ("'50 $$' for a $", "'50 $$' para um $");
                        self.tell(
                            Code::StLiteral,
                            token.span,
                            [written.into(), what.into(), like.into()],
                        );
                        NodeKind::Wrong
                    }
                };
                Ok(leaf(kind, token.span))
            }
            (Kind::Word, Keyword::True | Keyword::False) => {
                self.next();
                let truth = self.keywords[self.at - 1] == Keyword::True;
                Ok(leaf(
                    NodeKind::Literal(Base::Bool, Value::truth(truth)),
                    token.span,
                ))
            }
            // NOT(…), AND(…): functions by the names of operators.
            (Kind::Word, Keyword::And | Keyword::Or | Keyword::Xor | Keyword::Mod)
                if self.ahead(1).kind == Kind::Open && token.meant.is_none() =>
            {
                self.next();
                let name = self.named(token.span);
                let path = Path {
                    span: name.span,
                    name,
                    parts: Vec::new(),
                };
                self.called(path)
            }
            (Kind::Word, Keyword::None) => {
                let path = self.path()?;
                match self.is(Kind::Open) {
                    true => self.called(path),
                    false => {
                        let height = path.height() + 1;
                        let span = path.span;
                        self.node(NodeKind::Path(path), span, height)
                    }
                }
            }
            (Kind::Address, _) => {
                self.next();
                let name = self.named(token.span);
                let path = Path {
                    span: name.span,
                    name,
                    parts: Vec::new(),
                };
                Ok(leaf(NodeKind::Path(path), token.span))
            }
            _ => Err(self.missing(OPERAND, OPERAND_HELP)),
        }
    }

    fn literal(&mut self, read: Result<(Base, Value), literal::Fault>, span: Span) -> NodeKind {
        match read {
            Ok((base, value)) => NodeKind::Literal(base, value),
            Err(fault) => {
                let written = self.short(span);
                self.tell(
                    Code::StLiteral,
                    span,
                    [written.into(), fault.what, fault.like],
                );
                NodeKind::Wrong
            }
        }
    }

    fn typed(&mut self, span: Span) -> NodeKind {
        let text = self.slice(span);
        if let Some(read) = literal::typed(text) {
            return self.literal(read, span);
        }
        let Some((ty, value)) = text.split_once('#') else {
            return NodeKind::Wrong;
        };
        let middle = span.start + ty.len() as u32;
        let name = |text: &str, start, end| Name {
            text: text.to_owned(),
            span: Span { start, end },
        };
        NodeKind::Member(
            name(ty, span.start, middle),
            name(value, middle + 1, span.end),
        )
    }
}
