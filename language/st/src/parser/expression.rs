//! Expressions, by the precedence of the standard (table 55): `**`, then `-` and `NOT`, `* / MOD`, `+ -`, `< > <= >=`,
//! `= <>`, `AND`, `XOR`, `OR`; from left to right.

use super::super::ast::{Node, NodeKind, Op};
use super::super::token::Kind;
use super::super::words::Keyword;
use super::{MOST_HIGH, Parsed, Parser, Told};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Binary, Compare};

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
pub(super) const UNARY: u32 = 8;

impl Parser<'_, '_> {
    pub(in super::super) fn expression(&mut self) -> Parsed<Node> {
        self.binding(1)
    }

    /// An expression whose operators bind at least so tightly.
    pub(super) fn binding(&mut self, least: u32) -> Parsed<Node> {
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
    pub(super) fn open_condition(&self) -> bool {
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

    pub(super) fn node(&mut self, kind: NodeKind, span: Span, height: u32) -> Parsed<Node> {
        if height > MOST_HIGH {
            return Err(self.too_deep());
        }
        Ok(Node { kind, span, height })
    }
}
