//! Names with their members and subscripts, and what stands in the parentheses of a call.

use super::super::ast::{Arg, Name, Node, NodeKind, Part, Path};
use super::super::token::{Kind, Token};
use super::super::words::Keyword;
use super::{MOST_HIGH, Parsed, Parser};
use unoclp_text::diagnostics::{Span, Word};

impl Path {
    pub(in super::super) fn height(&self) -> u32 {
        let nodes = self.parts.iter().map(|part| match part {
            Part::Member(_) | Part::Bit(_) => 1,
            Part::Subscripts(nodes, _) => nodes.iter().map(|node| node.height).max().unwrap_or(0),
        });
        nodes.max().unwrap_or(0)
    }
}

impl Parser<'_, '_> {
    /// A name with its members and subscripts.
    pub(in super::super) fn path(&mut self) -> Parsed<Path> {
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
            "write the name of the variable here",
            "escreva aqui o nome da variável",
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
                if matches!(token.kind, Kind::Number | Kind::Address) {
                    let bit = self.bit_of(token)?;
                    path.span = path.span.to(bit.span);
                    path.parts.push(Part::Bit(bit));
                    return Ok(path);
                }
                if token.kind != Kind::Word {
                    let what = ("the name of a member", "o nome de um membro");
                    let help = ("write it after the dot", "escreva-o depois do ponto");
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

    /// `x.0` and `x.%X0`, a bit of a number by its place.
    fn bit_of(&mut self, token: Token) -> Parsed<Name> {
        let mut place = token.span;
        let written = self.slice(place).to_uppercase();
        let digits = written.strip_prefix("%X").unwrap_or(&written);
        if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            let what = ("the position of a bit", "a posição de um bit");
            let help = ("write it like x.3", "escreva como x.3");
            return Err(self.missing(what, help));
        }
        place.start = place.end - digits.len() as u32;
        self.next();
        Ok(self.named(place))
    }

    fn subscripts(&mut self) -> Parsed<Vec<Node>> {
        let mut all = vec![self.expression()?];
        while self.accept(Kind::Comma) {
            all.push(self.expression()?);
        }
        Ok(all)
    }

    pub(super) fn called(&mut self, path: Path) -> Parsed<Node> {
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
                    "separate the parameters of a call by commas",
                    "separe com vírgulas os parâmetros de uma chamada",
                );
                return Err(self.missing(what, help));
            }
            let help = ("close the call", "feche a chamada");
            let close = self.expect(Kind::Close, ")", help)?;
            return Ok((all, close));
        }
    }
}
