//! Operations of Instruction List as expressions of Structured Text, and how tightly these hold together.

use super::super::sentences::{Piece, piece};
use std::collections::VecDeque;
use unoclp_lang::Span;

/// An operation on the accumulator and an operand.
#[derive(Clone, Copy)]
pub(super) struct Binary {
    sign: &'static str,
    tight: u8,
    negated: bool,
}

/// How tightly NOT holds, and what needs no parentheses.
const NOT: u8 = 8;
const WHOLE: u8 = 9;

/// The operation of an operator in capitals.
pub(super) fn binary(word: &str) -> Option<Binary> {
    let (sign, tight) = match word {
        "OR" | "ORN" => (" OR ", 1),
        "XOR" | "XORN" => (" XOR ", 2),
        "AND" | "ANDN" | "&" | "&N" => (" AND ", 3),
        "EQ" => (" = ", 4),
        "NE" => (" <> ", 4),
        "GT" => (" > ", 5),
        "GE" => (" >= ", 5),
        "LE" => (" <= ", 5),
        "LT" => (" < ", 5),
        "ADD" => (" + ", 6),
        "SUB" => (" - ", 6),
        "MUL" => (" * ", 7),
        "DIV" => (" / ", 7),
        "MOD" => (" MOD ", 7),
        _ => return None,
    };
    Some(Binary {
        sign,
        tight,
        negated: word.ends_with('N'),
    })
}

/// An expression.
#[derive(Clone)]
pub(super) struct Value {
    pub pieces: VecDeque<Piece>,
    tight: u8,
}

impl Value {
    /// A constant or a variable.
    pub(super) fn plain(text: &str, at: Span) -> Value {
        let mut value = Value::whole(vec![piece(text, at)]);
        if text.starts_with(['-', '+']) {
            value.tight = 0;
        }
        value
    }

    /// What holds together by itself.
    pub(super) fn whole(pieces: Vec<Piece>) -> Value {
        Value {
            pieces: pieces.into(),
            tight: WHOLE,
        }
    }

    /// A name or a constant alone.
    pub(super) fn is_simple(&self) -> bool {
        let is_simple = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '#' | '%');
        self.pieces.len() == 1
            && self
                .pieces
                .iter()
                .all(|(text, _)| text.chars().all(is_simple))
    }

    /// Whether it is worth the same when this variable has changed, and costs nothing to be read again.
    pub(super) fn is_kept_over(&self, variable: &str) -> bool {
        let base = |text: &str| {
            let end = text.find(['.', '[']).unwrap_or(text.len());
            text[..end].to_uppercase()
        };
        let mut texts = self.pieces.iter();
        self.is_simple() && texts.all(|(text, _)| base(text) != base(variable))
    }

    pub(super) fn inverted(self, at: Span) -> Value {
        let mut value = self.holding(NOT, at);
        value.pieces.push_front(piece("NOT ", at));
        value.tight = NOT;
        value
    }

    /// The same, as it stands beside a sign that holds as tightly.
    fn holding(mut self, tight: u8, at: Span) -> Value {
        if self.tight < tight {
            self.pieces.push_front(piece("(", at));
            self.pieces.push_back(piece(")", at));
            self.tight = WHOLE;
        }
        self
    }

    pub(super) fn with(self, operation: Binary, operand: Value, at: Span) -> Value {
        let Binary {
            sign,
            tight,
            negated,
        } = operation;
        let operand = match negated {
            true => operand.inverted(at),
            false => operand,
        };
        // Comparisons do not follow one another.
        let is_comparison = matches!(tight, 4 | 5);
        let mut value = self.holding(tight + u8::from(is_comparison), at);
        value.pieces.push_back(piece(sign, at));
        value.pieces.extend(operand.holding(tight + 1, at).pieces);
        value.tight = tight;
        value
    }
}
