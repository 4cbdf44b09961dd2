//! What is no Instruction List, or no more of it: numeric code, Structured Text, comments that read like code.

use super::Parser;
use crate::ast::Unit;
use crate::lexer::{Kind, Token};
use crate::operators;
use unoclp_core::isa::{Row, TABLE};
use unoclp_text::diagnostics::{Code, Span};

impl Parser<'_, '_> {
    pub(super) fn is_digits(&self, token: Token) -> bool {
        let mut digits = self.text_of(token.span).bytes();
        digits.all(|byte| byte.is_ascii_digit())
    }

    /// Whether a line says nothing but a number that is a numeric code.
    pub(super) fn is_numeric_code(&self) -> bool {
        let minus = usize::from(self.peek().kind == Kind::Minus);
        let (number, next) = (self.ahead(minus), self.ahead(minus + 1));
        let code = self.text_of(number.span).parse().unwrap_or(0);
        // A comment of numeric code begins with /, which is no word here.
        let between = Span {
            start: number.span.end,
            end: next.span.start,
        };
        let ends = matches!(next.kind, Kind::NewLine | Kind::End);
        let remark = next.kind == Kind::Sign && self.text_of(next.span) == "/";
        (ends || remark || self.text_of(between).trim_start().starts_with('/')) && is_code(code)
    }

    /// From CONFIGURATION to END_CONFIGURATION: who runs the program, and how often, is no question here. What
    /// is declared there holds for the program.
    pub(super) fn configuration(&mut self, unit: &mut Unit) {
        let opening = self.advance();
        self.tell(Code::Configuration, opening.span, []);
        loop {
            let token = self.peek();
            if token.kind == Kind::End {
                let why = (
                    "write END_CONFIGURATION after it",
                    "escreva END_CONFIGURATION depois dela",
                );
                let words = ["CONFIGURATION".into(), why.into()];
                return self.tell(Code::Structure, opening.span, words);
            }
            self.at += 1;
            if self.is(token, "END_CONFIGURATION") {
                return while self.take(Kind::Semicolon).is_some() {};
            }
            if let Some(section) = self.section(token) {
                self.declarations(token, section, unit);
            }
        }
    }

    /// Structured Text is told once: what else could be said of it helps nobody.
    pub(super) fn structured_text(&mut self, span: Span) {
        let text = self.text_of(span).to_owned();
        self.tell(Code::StructuredText, span, [text.into()]);
        self.skip_line();
    }

    /// A comment after `;` that reads as an instruction does: whoever ends lines with `;` is told that
    /// nothing stands after it.
    pub(super) fn remark(&mut self, span: Span) {
        let text = self.text_of(span);
        let trimmed = text.trim();
        let words: Vec<&str> = trimmed.split_whitespace().take(3).collect();
        let done = match words[..] {
            [word] | [word, _] => {
                let operator = operators::find(&word.to_uppercase());
                operator.is_some_and(|spelling| spelling.op.takes_operand() == (words.len() == 2))
            }
            _ => false,
        };
        if done {
            let start = span.start + (text.len() - text.trim_start().len()) as u32;
            let end = start + trimmed.len() as u32;
            let words = [trimmed.to_owned().into()];
            self.tell(Code::Commented, Span { start, end }, words);
        }
    }
}

/// Whether a number of this size is a code, and not the number of a line.
fn is_code(number: i32) -> bool {
    let of_row = |row: &Row| match row.kind.has_number() {
        true => row.code / 100 == number / 100,
        false => row.code == number,
    };
    number >= 10_000 && TABLE.iter().any(of_row)
}
