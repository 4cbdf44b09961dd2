//! Expressions: from the lowest precedence: `|`, `^`, `&`, one comparison, `+ -`, `* /`, `!`; left to right.
//!
//! Owns the places of spaces and signs. Must not know the types of values.

use super::ast::{Kind, Node, NodeKind, Op};
use super::parser::Parser;
use super::words::{Word, lacking};
use unoclp_small::cursor::{Keywords, Parsed, Told};
use unoclp_small::rules::Sign;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Binary, Compare, Value, literal};

/// The precedence of comparisons.
const COMPARES: u32 = 4;

/// The operator that a sign stands for, and its precedence.
fn operator(sign: Sign) -> Option<(Op, u32)> {
    Some(match sign {
        Sign::Or => (Op::Logic(Binary::Or), 1),
        Sign::Xor => (Op::Logic(Binary::Xor), 2),
        Sign::And => (Op::Logic(Binary::And), 3),
        Sign::Equal | Sign::Assign => (Op::Compare(Compare::Equal), COMPARES),
        Sign::NotEqual => (Op::Compare(Compare::NotEqual), COMPARES),
        Sign::Less => (Op::Compare(Compare::Less), COMPARES),
        Sign::LessEqual => (Op::Compare(Compare::LessEqual), COMPARES),
        Sign::Greater => (Op::Compare(Compare::Greater), COMPARES),
        Sign::GreaterEqual => (Op::Compare(Compare::GreaterEqual), COMPARES),
        Sign::Plus => (Op::Arithmetic(Binary::Add), 5),
        Sign::Minus => (Op::Arithmetic(Binary::Subtract), 5),
        Sign::Star => (Op::Arithmetic(Binary::Multiply), 6),
        Sign::Slash => (Op::Arithmetic(Binary::Divide), 6),
        _ => return None,
    })
}

impl Parser<'_, '_> {
    pub(super) fn expression(&mut self) -> Parsed<Node> {
        self.binding(1)
    }

    /// An expression whose operators have at least this precedence.
    fn binding(&mut self, least: u32) -> Parsed<Node> {
        self.cursor.deeper()?;
        let mut left = self.operand()?;
        self.cursor.higher();
        let mut compared = false;
        loop {
            let Some((op, binds)) = self.operator_here()? else {
                return Ok(left);
            };
            if binds < least {
                return Ok(left);
            }
            if binds == COMPARES && compared {
                return Err(self.twice_compared(&left));
            }
            compared = binds == COMPARES;
            let (kind, sign) = self.take_operator(op)?;
            self.cursor.deeper()?;
            let right = self.binding(binds + 1)?;
            self.cursor.higher();
            let span = left.span.to(right.span);
            let below = left.height.max(right.height);
            let both = Box::new((left, right));
            left = self.node(NodeKind::Binary(op, kind, sign, both), span, below)?;
        }
    }

    /// The operator that is here, after its type if it has one.
    fn operator_here(&mut self) -> Parsed<Option<(Op, u32)>> {
        let mut sign = self.cursor.sign();
        if sign == Sign::Foreign {
            return Err(self.lacks());
        }
        if sign == Sign::Word && self.cursor.keyword() == Word::None {
            let written = self.cursor.written();
            sign = self.cursor.ahead(1).sign;
            let letter = written.chars().count() == 1;
            if !letter || operator(sign).is_none() {
                let Some(help) = lacking(written) else {
                    return Ok(None);
                };
                let span = self.cursor.token().span;
                self.cursor
                    .tell(Code::LceLacks, span, [written.into(), help.into()]);
                return Err(Told);
            }
        } else if sign == Sign::Assign {
            let span = self.cursor.token().span;
            self.cursor.tell(Code::StAssignForEquals, span, []);
            self.cursor.take_sign(Sign::Equal);
        }
        Ok(operator(sign))
    }

    /// Takes the operator and its type, and looks at the spaces beside it.
    fn take_operator(&mut self, op: Op) -> Parsed<(Option<Kind>, Span)> {
        let left = self.cursor.behind().end;
        let begin = self.cursor.token().span;
        let mut told = self.cursor.found.was_told(
            Code::LceSpace,
            Span {
                start: left,
                end: begin.end,
            },
        );
        let mut kind = self.stuck.take();
        if let Some(kind) = kind {
            // `V0R+ 1`: told where the type was found.
            let _ = kind;
            told = true;
        } else if self.cursor.is(Sign::Word) {
            let before = self.cursor.found.errors().count();
            kind = self.letter()?;
            told |= self.cursor.found.errors().count() > before;
        }
        let sign = self.cursor.advance().span;
        let whole = begin.to(sign);
        let apart = left < whole.start && sign.end < self.cursor.token().span.start;
        let ends = matches!(
            self.cursor.sign(),
            Sign::End | Sign::Semicolon | Sign::Close
        );
        if !apart && !told && !ends {
            self.told_space(whole.start, sign);
        }
        if kind == Some(Kind::R) && matches!(op, Op::Logic(_)) {
            let words = [self.cursor.slice(sign).into()];
            self.cursor.tell(Code::LceRealLogic, whole, words);
            return Err(Told);
        }
        Ok((kind, whole))
    }

    /// `1 < V0 < 10`
    fn twice_compared(&mut self, left: &Node) -> Told {
        let NodeKind::Binary(.., both) = &left.kind else {
            return Told;
        };
        let (begin, middle) = (self.cursor.short(left.span), self.cursor.short(both.1.span));
        let sign = self.cursor.written();
        let words = [begin.into(), middle.into(), sign.into()];
        self.cursor.tell(Code::LceChained, left.span, words);
        Told
    }

    fn node(&mut self, kind: NodeKind, span: Span, below: u32) -> Parsed<Node> {
        let height = self.cursor.height(below)?;
        Ok(Node { kind, span, height })
    }

    fn operand(&mut self) -> Parsed<Node> {
        let token = self.cursor.token();
        match (token.sign, self.cursor.keyword()) {
            (Sign::Not, _) | (Sign::Word, Word::Not) => {
                self.cursor.advance();
                self.cursor.deeper()?;
                let inner = self.operand()?;
                self.cursor.higher();
                let (span, below) = (token.span.to(inner.span), inner.height);
                self.node(NodeKind::Not(Box::new(inner)), span, below)
            }
            (Sign::Minus | Sign::Plus, _) => self.signed(),
            (Sign::Open, _) => {
                self.cursor.advance();
                let mut inner = self.expression()?;
                let help = ("write ) to match the (", "escreva o ) que corresponde ao (");
                let close = self.cursor.expect(Sign::Close, ")", help)?;
                inner.span = token.span.to(close);
                Ok(inner)
            }
            (Sign::Number, _) => {
                self.cursor.advance();
                let kind = self.number(token.span, false);
                self.node(kind, token.span, 0)
            }
            (Sign::Word, Word::None) => self.named(),
            (Sign::Address, _) => Err(self.address()),
            (Sign::Foreign, _) => Err(self.lacks()),
            (Sign::Text, _) => {
                let help = ("use a number or a bit instead", "use um número ou um bit");
                let words = [self.cursor.short(token.span).into(), help.into()];
                self.cursor.tell(Code::LceLacks, token.span, words);
                Err(Told)
            }
            _ => {
                let what = ("a value", "um valor");
                let help = (
                    "write a number, a variable, or an expression in ( )",
                    "escreva um número, uma variável ou uma expressão entre ( )",
                );
                Err(self.cursor.missing(what, help))
            }
        }
    }

    /// A name, or a name to which the type of the next operator sticks.
    fn named(&mut self) -> Parsed<Node> {
        let written = self.cursor.written();
        if Word::meant(written) == Word::Not && self.cursor.ahead(1).sign == Sign::Word {
            let span = self.cursor.token().span;
            let words = [written.into(), "nao".into()];
            self.cursor.tell(Code::StOtherWord, span, words);
            self.cursor.take_for(Word::Not);
            return self.operand();
        }
        if !self.given.contains(written)
            && let Some(help) = lacking(written)
        {
            let span = self.cursor.token().span;
            self.cursor
                .tell(Code::LceLacks, span, [written.into(), help.into()]);
            return Err(Told);
        }
        let span = self.cursor.advance().span;
        let mut name = self.cursor.named(span);
        if let Some(kind) = self.sticks(&name)
            && operator(self.cursor.sign()).is_some()
        {
            name.text.pop();
            name.span.end -= 1;
            self.stuck = Some(kind);
            let sign = self.cursor.token().span;
            self.told_space(name.span.end, sign);
        }
        let span = name.span;
        self.node(NodeKind::Name(name), span, 0)
    }

    /// A sign and its number.
    fn signed(&mut self) -> Parsed<Node> {
        let sign = self.cursor.advance();
        let minus = sign.sign == Sign::Minus;
        let token = self.cursor.token();
        let written = self.cursor.written();
        if token.sign != Sign::Number {
            if matches!(token.sign, Sign::Word | Sign::Open) {
                let short = match token.sign {
                    Sign::Open => "( … )".to_owned(),
                    _ => self.cursor.short(token.span),
                };
                let span = sign.span.to(token.span);
                self.cursor.tell(Code::LceSignOfName, span, [short.into()]);
                return Err(Told);
            }
            let help = (
                "write the number after its sign",
                "escreva o número depois do sinal",
            );
            return Err(self.cursor.missing(("a number", "um número"), help));
        }
        let span = sign.span.to(token.span);
        if sign.span.end != token.span.start {
            let short = self.cursor.short(token.span);
            self.cursor.tell(Code::LceSignApart, span, [short.into()]);
        }
        self.cursor.advance();
        let mut kind = self.number(token.span, minus);
        if let (NodeKind::Number(_, true), true) = (&kind, minus) {
            if let NodeKind::Number(value, _) = &kind {
                let words = [written.into(), value.int().to_string().into()];
                self.cursor.tell(Code::LceNegative, span, words);
            }
            kind = NodeKind::Wrong;
        }
        self.node(kind, span, 0)
    }

    /// A number: decimal, with a point, with 2# or 16#.
    fn number(&mut self, span: Span, minus: bool) -> NodeKind {
        let written = self.cursor.slice(span);
        if self.cursor.found.was_told(Code::LceComma, span) {
            return NodeKind::Wrong;
        }
        let based = written.contains('#');
        let plain = !written.contains('_')
            && !written.ends_with('.')
            && (!based || written.starts_with("2#") || written.starts_with("16#"));
        match literal::number(written) {
            Ok((_, value)) if plain => {
                let value = match (value, minus && !based) {
                    (Value::Int(number), true) => Value::Int(-number),
                    (Value::Real(number), true) => Value::Real(-number),
                    (value, _) => value,
                };
                NodeKind::Number(value, based)
            }
            _ => {
                let what = ("number", "número");
                let like = ("20, 1.5, 2#1010 or 16#1C", "20, 1.5, 2#1010 ou 16#1C");
                let words = [self.cursor.short(span).into(), what.into(), like.into()];
                self.cursor.tell(Code::StLiteral, span, words);
                NodeKind::Wrong
            }
        }
    }
}
