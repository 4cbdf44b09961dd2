//! Commands: what is stored, `aciona`, `liga`, `desliga`, `se`.

use super::ast::{Bit, Kind, Name, Statement, StatementKind};
use super::parser::Parser;
use super::slots::is_place;
use super::words::Word;
use unoclp_point::Maker;
use unoclp_small::cursor::{Parsed, Told};
use unoclp_small::rules::Sign;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_text::points;

impl Parser<'_, '_> {
    pub(super) fn command(&mut self) -> Parsed<Statement> {
        self.cursor.deeper()?;
        self.instead()?;
        let begin = self.cursor.token().span;
        let kind = match self.cursor.keyword() {
            Word::Coil => self.bit(Bit::Coil),
            Word::On => self.bit(Bit::On),
            Word::Off => self.bit(Bit::Off),
            Word::If => self.condition(),
            Word::None => self.assign(),
            _ => Err(self.no_command()),
        };
        self.cursor.higher();
        let span = begin.to(self.cursor.behind());
        Ok(Statement { kind: kind?, span })
    }

    fn no_command(&mut self) -> Told {
        let help = (
            "a statement stores a value, or begins with aciona, liga, desliga or se",
            "um comando guarda um valor ou começa com aciona, liga, desliga ou se",
        );
        self.cursor.missing(("a statement", "um comando"), help)
    }

    /// The variable that a command changes; a constant there is told.
    fn variable(&mut self) -> Parsed<Name> {
        let token = self.cursor.token();
        let constant = match token.sign {
            Sign::Number => true,
            Sign::Minus => self.cursor.ahead(1).sign == Sign::Number,
            _ => false,
        };
        if constant {
            let span = match token.sign {
                Sign::Minus => token.span.to(self.cursor.ahead(1).span),
                _ => token.span,
            };
            let help = (
                "write a variable (V0), an output (Q0.0) or a marker (M0.0)",
                "escreva uma variável (V0), uma saída (Q0.0) ou uma memória (M0.0)",
            );
            let words = [self.cursor.short(span).into(), help.into()];
            self.cursor.tell(Code::LceConstant, span, words);
            return Err(Told);
        }
        if token.sign == Sign::Address {
            return Err(self.address());
        }
        let what = ("the name of a variable", "o nome de uma variável");
        let help = (
            "write a variable (V0), an output (Q0.0) or a marker (M0.0)",
            "escreva uma variável (V0), uma saída (Q0.0) ou uma memória (M0.0)",
        );
        self.cursor.name(what, help)
    }

    /// `%IX1`, as the standard writes a point.
    pub(super) fn address(&mut self) -> Told {
        let span = self.cursor.token().span;
        let written = self.cursor.short(span);
        let help = points::help(&written, Maker::Simuplc, self.board);
        let words = [written.into(), help];
        self.cursor.tell(Code::LceNoPoint, span, words);
        Told
    }

    fn bit(&mut self, bit: Bit) -> Parsed<StatementKind> {
        self.cursor.advance();
        let name = self.variable()?;
        Ok(StatementKind::Bit(bit, name))
    }

    /// `V1 R:= e`
    fn assign(&mut self) -> Parsed<StatementKind> {
        let first = self.cursor.sign();
        if matches!(first, Sign::Foreign) {
            return Err(self.lacks());
        }
        if !matches!(
            first,
            Sign::Word | Sign::Number | Sign::Address | Sign::Minus
        ) {
            return Err(self.no_command());
        }
        let mut name = self.variable()?;
        if self.cursor.is(Sign::Foreign) {
            return Err(self.lacks());
        }
        let mut kind = None;
        let begin = self.cursor.token().span;
        let mut told = false;
        if let Some(letter) = self.sticks(&name) {
            kind = Some(letter);
            name.text.pop();
            name.span.end -= 1;
            told = true;
            self.told_space(name.span.end, self.cursor.token().span);
        } else if self.cursor.is(Sign::Word) && self.cursor.keyword() == Word::None {
            kind = self.letter()?;
        }
        let sign = self.cursor.token().span;
        if self.cursor.is(Sign::Equal) {
            let words = [name.text.as_str().into()];
            self.cursor.tell(Code::StEqualsForAssign, sign, words);
            self.cursor.advance();
        } else {
            let help = (
                "store a value like this: V0 := 1;",
                "guarde um valor assim: V0 := 1;",
            );
            self.cursor.expect(Sign::Assign, ":=", help)?;
        }
        let whole = begin.to(sign);
        let apart = name.span.end < whole.start && sign.end < self.cursor.token().span.start;
        if !apart && !told && !self.cursor.is(Sign::End) {
            self.told_space(whole.start, sign);
        }
        let value = self.expression()?;
        Ok(StatementKind::Assign(name, kind, whole, value))
    }

    /// The type at the end of `V0R`, where an operator follows at once.
    pub(super) fn sticks(&self, name: &Name) -> Option<Kind> {
        let letter = name.text.get(name.text.len().checked_sub(1)?..)?;
        let place = name.text.get(..name.text.len() - 1)?;
        let touches = name.span.end == self.cursor.token().span.start;
        let given = self.given.contains(name.text.as_str());
        let known = is_place(place) || self.given.contains(place);
        match touches && known && !given && !self.cursor.is(Sign::Close) {
            true => Kind::of(letter),
            false => None,
        }
    }

    /// Tells that a space is missing next to an operator.
    pub(super) fn told_space(&mut self, start: u32, sign: Span) {
        let span = Span {
            start,
            end: sign.end,
        };
        let words = [self.cursor.short(span).into()];
        self.cursor.tell(Code::LceSpace, span, words);
    }

    /// The type before an operator: a letter that touches it.
    pub(super) fn letter(&mut self) -> Parsed<Option<Kind>> {
        let span = self.cursor.token().span;
        let written = self.cursor.written();
        let sign = self.cursor.slice(self.cursor.ahead(1).span);
        let upper = written.to_uppercase();
        let kind = match Kind::of(written) {
            Some(kind) => {
                if !self.cursor.touches(0) {
                    let words = [written.into(), sign.into()];
                    self.cursor.tell(Code::LceTypeApart, span, words);
                }
                Some(kind)
            }
            None if self.cursor.ahead(1).sign == Sign::Assign || self.cursor.touches(0) => {
                let like = match Kind::of(&upper) {
                    Some(_) => format!("{upper}{sign}"),
                    None => format!("R{sign}"),
                };
                let words = [written.into(), like.into()];
                self.cursor.tell(Code::LceLetter, span, words);
                Kind::of(&upper)
            }
            None => return Ok(None),
        };
        self.cursor.advance();
        Ok(kind)
    }

    /// `se (e) { … } senao { … }`
    fn condition(&mut self) -> Parsed<StatementKind> {
        let word = self.cursor.written();
        self.cursor.advance();
        let help = ("write the condition in ( )", "escreva a condição entre ( )");
        self.cursor.expect(Sign::Open, "(", help)?;
        let condition = self.expression()?;
        let help = ("write ) to match the (", "escreva o ) que corresponde ao (");
        self.cursor.expect(Sign::Close, ")", help)?;
        let then = self.body(word)?;
        let mut otherwise = Vec::new();
        if self.cursor.keyword() == Word::Else {
            let word = self.cursor.written();
            self.cursor.advance();
            if self.cursor.keyword() == Word::If {
                otherwise.push(self.command()?);
            } else {
                otherwise = self.body(word)?;
            }
        }
        Ok(StatementKind::If(condition, then, otherwise))
    }

    /// What is between `{` and `}`.
    fn body(&mut self, word: &str) -> Parsed<Vec<Statement>> {
        let open = self.cursor.token().span;
        if !self.cursor.accept(Sign::OpenBrace) {
            if self.cursor.is(Sign::End) {
                let help = ("write { … }", "escreva { … }");
                return Err(self.cursor.missing("`{`", help));
            }
            let words = [word.into(), "{ }".into(), "{".into(), "}".into()];
            self.cursor.tell(Code::LceBraces, open, words);
            let then = ["then", "entao", "então"];
            if then
                .iter()
                .any(|then| self.cursor.written().to_lowercase() == *then)
            {
                self.cursor.advance();
            }
            self.cursor.accept(Sign::Semicolon);
            let command = self.command()?;
            self.cursor.accept(Sign::Semicolon);
            return Ok(vec![command]);
        }
        self.braces += 1;
        let body = self.list();
        self.braces -= 1;
        if !self.cursor.accept(Sign::CloseBrace) {
            self.cursor
                .tell(Code::StNotClosed, open, ["{".into(), "}".into()]);
            // One is missing, wherever it is.
            self.cursor.end_here();
        }
        Ok(body)
    }

    /// A sign of other languages.
    pub(super) fn lacks(&mut self) -> Told {
        let token = self.cursor.token();
        let written = self.cursor.written();
        let help = match written {
            "%" => (
                "compute the remainder: V0 - V0 / V1 * V1",
                "calcule o resto: V0 - V0 / V1 * V1",
            ),
            "**" => ("multiply: V0 * V0", "multiplique: V0 * V0"),
            "[" | "]" => (
                "give each value a variable of its own",
                "dê a cada valor uma variável própria",
            ),
            _ => (
                "write it out: V0 := V0 + 1;",
                "escreva por extenso: V0 := V0 + 1;",
            ),
        };
        self.cursor
            .tell(Code::LceLacks, token.span, [written.into(), help.into()]);
        Told
    }
}
