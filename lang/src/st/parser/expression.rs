//! Expressions, by the precedence of the norm (table 55): `**`, then `-` and `NOT`, `* / MOD`, `+ -`, `< > <= >=`,
//! `= <>`, `AND`, `XOR`, `OR`; from left to right.

use super::super::ast::{Arg, Name, Node, NodeKind, Op, Part, Path};
use super::super::lexer::Kind;
use super::super::literal;
use super::super::words::Keyword;
use super::{MOST_HIGH, Parsed, Parser, Told};
use crate::diagnostics::{Code, Span, Word};
use crate::typed::{Base, Binary, Compare, Value};

const OPERAND: (&str, &str) = ("a value", "um valor");
const OPERAND_HELP: (&str, &str) = (
    "write a number, a variable, or an expression in ( )",
    "escreva um número, uma variável ou uma expressão entre ( )",
);

/// The operator that stands here and how tightly it binds.
fn operator(kind: Kind, keyword: Keyword) -> Option<(Op, u32)> {
    Some(match (kind, keyword) {
        (Kind::Word, Keyword::Or) => (Op::Logic(Binary::Or), 1),
        (Kind::Word, Keyword::Xor) => (Op::Logic(Binary::Xor), 2),
        (Kind::And, _) | (Kind::Word, Keyword::And) => (Op::Logic(Binary::And), 3),
        (Kind::Equal, _) => (Op::Compare(Compare::Equal), 4),
        (Kind::NotEqual, _) => (Op::Compare(Compare::NotEqual), 4),
        (Kind::Less, _) => (Op::Compare(Compare::Less), 5),
        (Kind::LessEqual, _) => (Op::Compare(Compare::LessEqual), 5),
        (Kind::Greater, _) => (Op::Compare(Compare::Greater), 5),
        (Kind::GreaterEqual, _) => (Op::Compare(Compare::GreaterEqual), 5),
        (Kind::Plus, _) => (Op::Arithmetic(Binary::Add), 6),
        (Kind::Minus, _) => (Op::Arithmetic(Binary::Subtract), 6),
        (Kind::Star, _) => (Op::Arithmetic(Binary::Multiply), 7),
        (Kind::Slash, _) => (Op::Arithmetic(Binary::Divide), 7),
        (Kind::Word, Keyword::Mod) => (Op::Arithmetic(Binary::Modulo), 7),
        (Kind::Power, _) => (Op::Power, 9),
        _ => return None,
    })
}

/// How tightly `-` and `NOT` bind.
const UNARY: u32 = 8;

impl Parser<'_, '_> {
    pub(super) fn expression(&mut self) -> Parsed<Node> {
        self.binding(1)
    }

    /// An expression whose operators bind at least so tightly.
    fn binding(&mut self, least: u32) -> Parsed<Node> {
        self.deeper()?;
        let left = self.operand();
        self.open -= 1;
        let mut left = left?;
        let mut compared = false;
        loop {
            if self.is(Kind::Assign) && least <= 4 && self.open_condition() {
                let span = self.token().span;
                self.tell(Code::StAssignForEquals, span, []);
                self.next();
                let right = self.binding(5)?;
                left = self.joined(Op::Compare(Compare::Equal), left, right)?;
                continue;
            }
            if self.is(Kind::Arrow) && self.open_condition() {
                let span = self.token().span;
                self.tell(Code::StOtherWord, span, ["=>".into(), ">=".into()]);
                self.next();
                let right = self.binding(6)?;
                left = self.joined(Op::Compare(Compare::GreaterEqual), left, right)?;
                continue;
            }
            let Some((op, binds)) = operator(self.kind(), self.keyword()) else {
                return Ok(left);
            };
            if binds < least {
                return Ok(left);
            }
            if binds == 5 && compared {
                return Err(self.twice_compared(&left));
            }
            compared = binds == 5;
            self.next();
            self.deeper()?;
            let right = self.binding(binds + 1);
            self.open -= 1;
            let right = right?;
            left = self.joined(op, left, right)?;
        }
    }

    /// Whether the innermost open part is a condition, in which `:=` and `=>` can mean nothing else.
    fn open_condition(&self) -> bool {
        self.closers.last() == Some(&Keyword::Then)
    }

    /// `1 < x < 10`
    fn twice_compared(&mut self, left: &Node) -> Told {
        let (middle, sign) = match &left.kind {
            NodeKind::Binary(_, _, middle) => {
                (self.slice(middle.span).to_owned(), self.token().span)
            }
            _ => (String::new(), self.token().span),
        };
        let begin = self.short(left.span);
        let sign = self.slice(sign).to_owned();
        let written = format!("{begin} {sign} …");
        let meant = format!("{begin} AND {middle} {sign} …");
        self.tell(Code::StOtherWord, left.span, [written.into(), meant.into()]);
        Told
    }

    fn joined(&mut self, op: Op, a: Node, b: Node) -> Parsed<Node> {
        let span = a.span.to(b.span);
        let height = a.height.max(b.height) + 1;
        self.node(NodeKind::Binary(op, Box::new(a), Box::new(b)), span, height)
    }

    fn node(&mut self, kind: NodeKind, span: Span, height: u32) -> Parsed<Node> {
        if height > MOST_HIGH {
            return Err(self.too_deep());
        }
        Ok(Node { kind, span, height })
    }

    pub(super) fn operand(&mut self) -> Parsed<Node> {
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
                let help = ("close what the ( opens", "feche o que o ( abre");
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
                            "text: $ begins a code of two digits",
                            "texto: $ inicia um código de dois dígitos",
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

    /// A name with its members and subscripts.
    pub(super) fn path(&mut self) -> Parsed<Path> {
        let token = self.token();
        if token.kind == Kind::Address {
            self.next();
            let name = self.named(token.span);
            return Ok(Path {
                span: name.span,
                name,
                parts: Vec::new(),
            });
        }
        let what = ("the name of a variable", "o nome de uma variável");
        let help = (
            "write the variable that is meant",
            "escreva a variável de que se trata",
        );
        let name = self.name(what, help)?;
        let mut path = Path {
            span: name.span,
            name,
            parts: Vec::new(),
        };
        loop {
            if self.is(Kind::Dot) {
                self.next();
                let token = self.token();
                if token.kind == Kind::Number && self.list && path.parts.is_empty() {
                    // `I0.0`
                    self.next();
                    path.name = self.named(path.span.to(token.span));
                    path.span = path.name.span;
                    continue;
                }
                if token.kind == Kind::Number {
                    return Err(self.bit_of(token.span));
                }
                if token.kind != Kind::Word {
                    let what = ("the name of a member", "o nome de um membro");
                    let help = ("write it behind the point", "escreva-o depois do ponto");
                    return Err(self.missing(what, help));
                }
                // A member may have a keyword's name.
                self.next();
                let name = self.named(token.span);
                path.span = path.span.to(name.span);
                path.parts.push(Part::Member(name));
            } else if self.is(Kind::OpenSquare) {
                let open = self.next().span;
                self.closers.push(Keyword::None);
                let subscripts = self.subscripts();
                self.closers.pop();
                let subscripts = subscripts?;
                let help = ("close the subscript", "feche o índice");
                let close = self.expect(Kind::CloseSquare, "]", help)?;
                path.span = path.span.to(close);
                path.parts
                    .push(Part::Subscripts(subscripts, open.to(close)));
            } else {
                return Ok(path);
            }
            if path.parts.len() as u32 > MOST_HIGH {
                return Err(self.too_deep());
            }
        }
    }

    /// `x.0`, a bit of a number by its place.
    fn bit_of(&mut self, place: Span) -> Told {
        let bit = format!(".{}", self.short(place));
        let help = (
            "to read a bit write (SHR(x, 3) AND 16#1) <> 16#0; to set it x OR 16#8; to clear it x AND 16#F7",
            "para ler um bit escreva (SHR(x, 3) AND 16#1) <> 16#0; para ligá-lo x OR 16#8; para desligá-lo x AND 16#F7",
        );
        self.tell(Code::StUnsupported, place, [bit.into(), help.into()]);
        Told
    }

    fn subscripts(&mut self) -> Parsed<Vec<Node>> {
        let mut all = vec![self.expression()?];
        while self.accept(Kind::Comma) {
            all.push(self.expression()?);
        }
        Ok(all)
    }

    fn called(&mut self, path: Path) -> Parsed<Node> {
        let (arguments, close) = self.arguments()?;
        let deepest = arguments.iter().map(|arg| arg.node.height).max();
        let height = deepest.unwrap_or(0).max(path.height()) + 1;
        let span = path.span.to(close);
        self.node(NodeKind::Call(path, arguments), span, height)
    }

    /// `(a, b)` or `(IN := a, Q => b)`
    pub(super) fn arguments(&mut self) -> Parsed<(Vec<Arg>, Span)> {
        self.closers.push(Keyword::None);
        let read = self.arguments_within();
        self.closers.pop();
        read
    }

    fn arguments_within(&mut self) -> Parsed<(Vec<Arg>, Span)> {
        self.next();
        let mut all = Vec::new();
        if self.is(Kind::Close) {
            return Ok((all, self.next().span));
        }
        loop {
            // NOT before an output inverts it, which is not read.
            let named = matches!(self.ahead(1).kind, Kind::Assign | Kind::Arrow);
            let name = match named && self.is(Kind::Word) {
                true => {
                    let span = self.next().span;
                    Some(self.named(span))
                }
                false => None,
            };
            let out = name.is_some() && self.next().kind == Kind::Arrow;
            let node = self.expression()?;
            all.push(Arg { name, out, node });
            if self.accept(Kind::Comma) {
                continue;
            }
            if self.is(Kind::Close) {
                return Ok((all, self.next().span));
            }
            if self.is(Kind::Equal) || self.is(Kind::Word) || self.is(Kind::Number) {
                let what = Word::Both("a comma".into(), "uma vírgula".into());
                let help = (
                    "commas stand between what a call takes",
                    "o que uma chamada recebe é separado por vírgulas",
                );
                return Err(self.missing(what, help));
            }
            let help = ("close the call", "feche a chamada");
            let close = self.expect(Kind::Close, ")", help)?;
            return Ok((all, close));
        }
    }
}

impl Path {
    fn height(&self) -> u32 {
        let nodes = self.parts.iter().map(|part| match part {
            Part::Member(_) => 1,
            Part::Subscripts(nodes, _) => nodes.iter().map(|node| node.height).max().unwrap_or(0),
        });
        nodes.max().unwrap_or(0)
    }
}
