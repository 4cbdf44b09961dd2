//! Expressions: OR binds loosest, then AND, one comparison, `+ -`, `* /`, and closest `-` and NOT; left to right.

use super::ast::{Node, NodeKind, Op};
use super::parser::Parser;
use super::words::Word;
use unoclp_small::cursor::{Keywords, Parsed, Told};
use unoclp_small::rules::Sign;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Base, Binary, Compare, Value, literal};

/// How tightly comparisons bind.
const COMPARES: u32 = 3;
/// And `-` and NOT.
const UNARY: u32 = 6;

/// The operator that stands here and how tightly it binds.
fn operator(sign: Sign, keyword: Word) -> Option<(Op, u32)> {
    Some(match (sign, keyword) {
        (Sign::Or, _) | (_, Word::Or) => (Op::Logic(Binary::Or), 1),
        (Sign::And, _) | (_, Word::And) => (Op::Logic(Binary::And), 2),
        (Sign::Equal, _) => (Op::Compare(Compare::Equal), COMPARES),
        (Sign::NotEqual, _) => (Op::Compare(Compare::NotEqual), COMPARES),
        (Sign::Less, _) => (Op::Compare(Compare::Less), COMPARES),
        (Sign::LessEqual, _) => (Op::Compare(Compare::LessEqual), COMPARES),
        (Sign::Greater, _) => (Op::Compare(Compare::Greater), COMPARES),
        (Sign::GreaterEqual, _) => (Op::Compare(Compare::GreaterEqual), COMPARES),
        (Sign::Plus, _) => (Op::Arithmetic(Binary::Add), 4),
        (Sign::Minus, _) => (Op::Arithmetic(Binary::Subtract), 4),
        (Sign::Star, _) => (Op::Arithmetic(Binary::Multiply), 5),
        (Sign::Slash, _) => (Op::Arithmetic(Binary::Divide), 5),
        _ => return None,
    })
}

impl Parser<'_, '_> {
    pub(super) fn expression(&mut self) -> Parsed<Node> {
        self.binding(1)
    }

    /// An expression whose operators bind at least so tightly.
    fn binding(&mut self, least: u32) -> Parsed<Node> {
        self.cursor.deeper()?;
        let mut left = self.operand()?;
        self.cursor.higher();
        let mut compared = false;
        loop {
            self.other_operator()?;
            let Some((op, binds)) = operator(self.cursor.sign(), self.cursor.keyword()) else {
                return Ok(left);
            };
            if binds < least {
                return Ok(left);
            }
            if binds == COMPARES && compared {
                return Err(self.twice_compared(&left));
            }
            compared = binds == COMPARES;
            self.cursor.advance();
            self.cursor.deeper()?;
            let right = self.binding(binds + 1)?;
            self.cursor.higher();
            let span = left.span.to(right.span);
            let below = left.height.max(right.height);
            let kind = NodeKind::Binary(op, Box::new(left), Box::new(right));
            left = self.node(kind, span, below)?;
        }
    }

    /// `:=` in a condition, and words of other languages: told, and read as what is meant.
    fn other_operator(&mut self) -> Parsed<()> {
        if self.condition && self.cursor.is(Sign::Assign) {
            let span = self.cursor.token().span;
            self.cursor.tell(Code::StAssignForEquals, span, []);
            self.cursor.take_sign(Sign::Equal);
        }
        if self.cursor.is(Sign::Foreign) {
            return self.lacks().map_or(Ok(()), Err);
        }
        if !self.cursor.is(Sign::Word) || self.cursor.keyword() != Word::None {
            return Ok(());
        }
        let written = self.cursor.written();
        let meant = match (Word::meant(written), written) {
            (Word::Or, _) => Word::Or,
            (_, "E" | "e") => Word::And,
            _ if written.eq_ignore_ascii_case("MOD") || written.eq_ignore_ascii_case("XOR") => {
                return self.lacks().map_or(Ok(()), Err);
            }
            _ => return Ok(()),
        };
        let words = [written.into(), meant.name().into()];
        let span = self.cursor.token().span;
        self.cursor.tell(Code::StOtherWord, span, words);
        self.cursor.take_for(meant);
        Ok(())
    }

    /// `1 < x < 10`
    fn twice_compared(&mut self, left: &Node) -> Told {
        let NodeKind::Binary(_, _, middle) = &left.kind else {
            return Told;
        };
        let (begin, middle) = (self.cursor.short(left.span), self.cursor.short(middle.span));
        let sign = self.cursor.written();
        let words = [begin.into(), middle.into(), sign.into()];
        self.cursor.tell(Code::IsclChained, left.span, words);
        Told
    }

    fn node(&mut self, kind: NodeKind, span: Span, below: u32) -> Parsed<Node> {
        let height = self.cursor.height(below)?;
        Ok(Node { kind, span, height })
    }

    fn operand(&mut self) -> Parsed<Node> {
        let token = self.cursor.token();
        let mut keyword = self.cursor.keyword();
        if token.sign == Sign::Word
            && self.cursor.ahead(1).sign == Sign::Word
            && Word::meant(self.cursor.written()) == Word::Not
        {
            let words = [self.cursor.written().into(), "NOT".into()];
            self.cursor.tell(Code::StOtherWord, token.span, words);
            keyword = Word::Not;
        }
        match (token.sign, keyword) {
            (Sign::Minus | Sign::Not, _) | (Sign::Word, Word::Not) => {
                self.cursor.advance();
                let inner = self.binding(UNARY)?;
                let (span, below) = (token.span.to(inner.span), inner.height);
                let inner = Box::new(inner);
                let kind = match token.sign {
                    Sign::Minus => NodeKind::Negate(inner),
                    _ => NodeKind::Not(inner),
                };
                self.node(kind, span, below)
            }
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
                let kind = self.number(token.span);
                self.node(kind, token.span, 0)
            }
            (Sign::Word, Word::True | Word::False) => {
                self.cursor.advance();
                let truth = Value::truth(keyword == Word::True);
                self.node(NodeKind::Literal(Base::Bool, truth), token.span, 0)
            }
            (Sign::Word, Word::None) => {
                self.cursor.advance();
                let name = self.cursor.named(token.span);
                if self.cursor.is(Sign::Open) {
                    return Err(self.called(&name));
                }
                self.node(NodeKind::Name(name), token.span, 0)
            }
            (Sign::Text, _) => {
                let help = (
                    "there are only INT, REAL and BOOL, and no strings",
                    "só há INT, REAL e BOOL, e não há strings",
                );
                let words = [self.cursor.short(token.span).into(), help.into()];
                self.cursor.tell(Code::IsclLacks, token.span, words);
                Err(Told)
            }
            (Sign::Address, _) => {
                let help = (
                    "give the point a name: BOOL start AT %IX1;",
                    "dê um nome ao ponto: BOOL liga AT %IX1;",
                );
                let words = [self.cursor.short(token.span).into(), help.into()];
                self.cursor.tell(Code::IsclLacks, token.span, words);
                Err(Told)
            }
            (Sign::Foreign, _) => Err(self.lacks().unwrap_or(Told)),
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

    /// A whole number or one with a point.
    fn number(&mut self, span: Span) -> NodeKind {
        let written = self.cursor.slice(span);
        if self.cursor.found.was_told(Code::IsclComma, span) {
            return NodeKind::Wrong;
        }
        let plain = !written.contains(['#', '_']) && !written.ends_with('.');
        match literal::number(written) {
            Ok((base, value)) if plain => NodeKind::Literal(base, value),
            _ => {
                let what = ("number", "número");
                let like = ("20, 1.5 or 1.5E3", "20, 1.5 ou 1.5E3");
                let words = [self.cursor.short(span).into(), what.into(), like.into()];
                self.cursor.tell(Code::StLiteral, span, words);
                NodeKind::Wrong
            }
        }
    }
}
