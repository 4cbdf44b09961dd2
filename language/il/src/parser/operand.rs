//! Operands and parameters.

use super::Parser;
use crate::ast::{Operand, OperandKind, Param, Word};
use crate::lexer::Kind;
use crate::operators::{self, Op};
use unoclp_point::{LETTERS, is_block};
use unoclp_st::pieces::Piece;
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_text::literal;
use unoclp_tree::Base;

impl Parser<'_, '_> {
    /// The operand that comes next; none, and nothing taken, where there is none.
    pub(super) fn operand(&mut self) -> Option<Operand> {
        let token = self.peek();
        if self.is_piece() {
            return self.piece(match token.kind {
                Kind::Name => Piece::place,
                _ => Piece::operand,
            });
        }
        let (kind, span) = match token.kind {
            Kind::Minus => {
                let number = self.ahead(1);
                if !matches!(number.kind, Kind::Number | Kind::Literal) {
                    return None;
                }
                self.at += 2;
                let span = token.span.to(number.span);
                let text = self.text_of(number.span).to_owned();
                match literal::value(&text) {
                    Some(value) => (OperandKind::Number(value.wrapping_neg()), span),
                    None if literal::is_decimal(&text) => {
                        (OperandKind::Name(format!("-{text}")), span)
                    }
                    None => (self.bad_number(&text, span), span),
                }
            }
            Kind::Plus if self.ahead(1).kind == Kind::Number => {
                self.at += 1;
                return self.operand();
            }
            Kind::Number | Kind::Literal => {
                self.at += 1;
                let text = self.text_of(token.span).to_owned();
                // A REAL, or a channel and bit, as OMRON writes points: 0.00.
                let digits = |c: char| c.is_ascii_digit() || matches!(c, '.' | '_');
                let channel = text.contains('.') && text.chars().all(digits);
                if token.kind == Kind::Number && (channel || literal::is_decimal(&text)) {
                    (OperandKind::Name(text), token.span)
                } else if token.kind == Kind::Literal
                    && text
                        .get(..5)
                        .is_some_and(|t| t.eq_ignore_ascii_case("REAL#"))
                    && let Some(bits) = literal::value(&text)
                {
                    (OperandKind::Real(bits), token.span)
                } else {
                    match literal::value(&text) {
                        // The smallest number stands only after a minus.
                        Some(value) if text.starts_with(['T', 't']) => {
                            (OperandKind::Time(value), token.span)
                        }
                        Some(value) if value < 0 && is_unsigned(&text) => {
                            (OperandKind::Unsigned(value), token.span)
                        }
                        Some(value) if token.kind == Kind::Literal || value >= 0 => {
                            (OperandKind::Number(value), token.span)
                        }
                        _ => (self.bad_number(&text, token.span), token.span),
                    }
                }
            }
            Kind::Name => {
                self.at += 1;
                let word = self.spaced(self.word(token));
                let kind = match word.text.as_str() {
                    "TRUE" => OperandKind::Bool(true),
                    "FALSE" => OperandKind::Bool(false),
                    _ => OperandKind::Name(word.text),
                };
                (kind, word.span)
            }
            _ => return None,
        };
        Some(Operand { kind, span })
    }

    /// Whether what comes is written as in Structured Text.
    fn is_piece(&self) -> bool {
        let (token, next) = (self.peek(), self.ahead(1));
        match token.kind {
            Kind::Text => true,
            Kind::Name => next.kind == Kind::Sign && self.text_of(next.span) == "[",
            Kind::Literal => {
                let text = self.text_of(token.span);
                literal::value(text).is_none() && self.is_typed_prefix(text)
            }
            _ => false,
        }
    }

    /// Whether a type of Structured Text stands before the `#` of a literal.
    fn is_typed_prefix(&self, text: &str) -> bool {
        let prefix = prefix(text);
        self.type_names.contains(&prefix)
            || Base::named(&prefix).is_some_and(|base| !base.is_plain())
            || matches!(prefix.as_str(), "D" | "DATE")
    }

    /// What comes, as Structured Text has it.
    fn piece(&mut self, read: PieceReader) -> Option<Operand> {
        let start = self.peek().span;
        let span = Span {
            start: start.start,
            end: self.end_of_piece(),
        };
        let piece = self.within(|text, found| read(text, span, found));
        let Some((piece, end)) = piece else {
            self.skip_to(span.end);
            let kind = OperandKind::Unknown;
            return Some(Operand { kind, span: start });
        };
        self.skip_to(end);
        let span = piece.span();
        let kind = OperandKind::Piece(self.pieces.add(piece));
        Some(Operand { kind, span })
    }

    /// Where an operand ends at the latest: at its line's end, or, between parentheses, where the next parameter begins.
    fn end_of_piece(&self) -> u32 {
        let mut open = 0_u32;
        for token in self.tokens.iter().skip(self.at) {
            match token.kind {
                Kind::Open => open += 1,
                Kind::Sign if self.text_of(token.span) == "[" => open += 1,
                Kind::Sign if self.text_of(token.span) == "]" => open = open.saturating_sub(1),
                Kind::Close if open == 0 => return token.span.start,
                Kind::Close => open -= 1,
                Kind::Comma if open == 0 => return token.span.start,
                Kind::NewLine if !self.in_call => return token.span.start,
                Kind::End => return token.span.start,
                _ => {}
            }
        }
        self.text.len() as u32
    }

    /// Whether the parameter that comes is more than an operand: `n > 50`.
    fn is_expression(&self) -> bool {
        let begins = [1, 2].map(|more| self.ahead(more).kind);
        if matches!(begins, [Kind::Name, Kind::Assign | Kind::Arrow]) {
            return false;
        }
        let rest = self.tokens.iter().skip(self.at).enumerate();
        for (at, token) in rest {
            match token.kind {
                Kind::Open | Kind::Sign | Kind::And | Kind::Equals => return true,
                Kind::Plus | Kind::Minus if at > 0 => return true,
                Kind::Name if at > 0 => {
                    let joins = ["AND", "OR", "XOR", "MOD"];
                    if joins.iter().any(|word| self.is(*token, word)) {
                        return true;
                    }
                }
                Kind::Comma | Kind::Close | Kind::Assign | Kind::Arrow | Kind::End => return false,
                _ => {}
            }
        }
        false
    }

    /// `I 0.0`, as Siemens spaces addresses, and `TIM 000`, as OMRON does.
    fn spaced(&mut self, letters: Word) -> Word {
        let number = self.peek();
        let spelt = letters.text.trim_start_matches('%');
        if number.kind != Kind::Number || !LETTERS.contains(&spelt) {
            return letters;
        }
        let digits = self.text_of(number.span).to_owned();
        if !digits.bytes().all(|b| b.is_ascii_digit() || b == b'.') {
            return letters;
        }
        self.at += 1;
        Word {
            text: letters.text + &digits,
            span: letters.span.to(number.span),
        }
    }

    /// A REAL number without `REAL#`; none, and nothing taken, where none comes next.
    pub(super) fn real(&mut self) -> Option<Operand> {
        let minus = usize::from(matches!(self.peek().kind, Kind::Minus | Kind::Plus));
        let number = self.ahead(minus);
        if number.kind != Kind::Number {
            return None;
        }
        let span = self.peek().span.to(number.span);
        let bits = literal::real(self.text_of(number.span))?;
        let negative = self.peek().kind == Kind::Minus;
        self.at += minus + 1;
        let sign = if negative { i32::MIN } else { 0 };
        let kind = OperandKind::Number(bits ^ sign);
        Some(Operand { kind, span })
    }

    fn bad_number(&mut self, text: &str, span: Span) -> OperandKind {
        let (code, meant) = literal::fault(text);
        let written = self.text_of(span).to_owned();
        self.tell(code, span, [written.into(), meant.into()]);
        OperandKind::Unknown
    }

    /// Operands with commas between them; with `more`, one that is missing is told.
    pub(super) fn operands(&mut self, more: bool) -> Vec<Operand> {
        if !more && let Some(fraction) = self.fraction() {
            return vec![fraction];
        }
        let Some(first) = self.operand() else {
            return Vec::new();
        };
        // Most instructions have one, and take room for no more.
        let mut operands = vec![first];
        while self.take(Kind::Comma).is_some() || more && self.tell_comma() {
            match self.operand() {
                Some(operand) => operands.push(operand),
                None => break,
            }
        }
        operands
    }

    /// What is stored to. Mitsubishi's OUT may start a timer or counter: `T0 K50`, `C1 D5`.
    pub(super) fn stored(&mut self) -> Vec<Operand> {
        let mut operands = self.operands(false);
        let behind = matches!(self.peek().kind, Kind::Name | Kind::Number);
        if let [block] = &operands[..]
            && behind
            && block.name().is_some_and(is_block)
        {
            operands.extend(self.operand().map(maker_constant));
        }
        operands
    }

    /// `000 #0050` after TIM and CNT: the number is that of the timer or counter.
    pub(super) fn omron_operands(&mut self, op: Op) -> Vec<Operand> {
        let number = self.peek();
        let letters = if op == Op::OmronTimer { "TIM" } else { "CNT" };
        let mut operands = Vec::new();
        if number.kind == Kind::Number && self.is_digits(number) {
            let kind = OperandKind::Name(letters.to_owned() + self.text_of(number.span));
            self.at += 1;
            let span = number.span;
            operands.push(Operand { kind, span });
        } else {
            operands.extend(self.operand());
        }
        if !operands.is_empty() {
            self.take(Kind::Comma);
            operands.extend(self.operand().map(maker_constant));
        }
        operands
    }

    /// `2,5`, where no second operand can stand.
    fn fraction(&mut self) -> Option<Operand> {
        let [whole, comma, parts] = [0, 1, 2].map(|more| self.ahead(more));
        let kinds = [whole.kind, comma.kind, parts.kind];
        let span = whole.span.to(parts.span);
        let text = self.text_of(span);
        // ADD 2,4,7 adds each of them.
        let list = self.ahead(3).kind == Kind::Comma;
        let numbers = kinds == [Kind::Number, Kind::Comma, Kind::Number];
        if !numbers || list || !literal::is_fraction(text) {
            return None;
        }
        let text = text.to_owned();
        self.at += 3;
        let kind = self.bad_number(&text, span);
        Some(Operand { kind, span })
    }

    /// Tells that a comma is missing, where an operand or parameter follows.
    fn tell_comma(&mut self) -> bool {
        let next = self.peek();
        let follows = matches!(
            next.kind,
            Kind::Number | Kind::Literal | Kind::Name | Kind::Minus | Kind::Plus
        );
        let is_operator =
            next.kind == Kind::Name && operators::find(&self.word(next).text).is_some();
        // PT := … in a call is a parameter, whatever its name.
        if !follows || is_operator && self.ahead(1).kind != Kind::Assign {
            return false;
        }
        let text = self.text_of(next.span).to_owned();
        self.tell(Code::CommaMissing, next.span, [text.into()]);
        true
    }

    /// From after the parenthesis of a call to its end. They may go over lines.
    pub(super) fn params(&mut self) -> Vec<Param> {
        self.in_call = true;
        let params = self.params_within();
        self.in_call = false;
        params
    }

    fn params_within(&mut self) -> Vec<Param> {
        let mut params = Vec::new();
        loop {
            while self.take(Kind::NewLine).is_some() {}
            if self.take(Kind::Close).is_some() {
                return params;
            }
            if self.begins_instruction() {
                let span = self.peek().span;
                let text = self.text_of(span).to_owned();
                self.tell(Code::Unexpected, span, [text.into()]);
                return params;
            }
            let Some(param) = self.param() else {
                self.unexpected();
                return params;
            };
            params.push(param);
            while self.take(Kind::NewLine).is_some() {}
            if self.take(Kind::Comma).is_none()
                && self.peek().kind != Kind::Close
                && !self.tell_comma()
            {
                self.unexpected();
                return params;
            }
        }
    }

    /// Whether a line begins here that is no parameter: a label, or an operator with its operand.
    fn begins_instruction(&self) -> bool {
        let (word, next) = (self.peek(), self.ahead(1));
        let operator = operators::find(&self.word(word).text).is_some();
        let acts = next.kind == Kind::Colon || operator && next.kind == Kind::Name;
        word.kind == Kind::Name && self.begins_line() && acts
    }

    /// `IN := %IX1`, `Q => %QX1`, `%IX1`; each value may be after NOT.
    fn param(&mut self) -> Option<Param> {
        let (mut name, mut out) = (None, false);
        let token = self.peek();
        if token.kind == Kind::Name && matches!(self.ahead(1).kind, Kind::Assign | Kind::Arrow) {
            self.at += 1;
            name = Some(self.word(token));
            out = self.advance().kind == Kind::Arrow;
        }
        if token.kind == Kind::Name && self.ahead(1).kind == Kind::Equals {
            self.at += 1;
            self.equals_for_assign();
            self.at += 1;
            name = Some(self.word(token));
        }
        let expression = !out && self.is_expression();
        let negated = !expression && self.is(self.peek(), "NOT");
        if negated {
            self.at += 1;
        }
        let value = match expression {
            true => self.piece(Piece::expression)?,
            false => self.operand()?,
        };
        Some(Param {
            name,
            out,
            negated,
            value,
        })
    }
}

/// What reads a piece of a text, and where that ends.
type PieceReader = fn(&str, Span, &mut Found) -> Option<(Piece, u32)>;

/// What stands before the `#` of a literal, in upper case.
fn prefix(text: &str) -> String {
    let prefix = text.split('#').next().unwrap_or_default();
    prefix.to_uppercase()
}

/// `UDINT#1`, `DWORD#16#1`.
fn is_unsigned(text: &str) -> bool {
    matches!(Base::named(&prefix(text)), Some(Base::Udint | Base::Dword))
}

/// Mitsubishi's `K50`, a constant.
fn maker_constant(operand: Operand) -> Operand {
    let digits = operand.name().and_then(|name| name.strip_prefix('K'));
    match digits.and_then(literal::value) {
        Some(value) => Operand {
            kind: OperandKind::Number(value),
            ..operand
        },
        None => operand,
    }
}
