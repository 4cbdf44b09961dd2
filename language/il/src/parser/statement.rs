//! Labels and instructions.

use super::Parser;
use crate::ast::{Instr, Open, Stmt, Unit};
use crate::lexer::{Kind, Token};
use crate::operators::{self, Op, Spelling};
use unoclp_text::Dialect;
use unoclp_text::diagnostics::{Code, Span};

impl Parser<'_, '_> {
    /// A line, or what is left of it, or a section of declarations.
    pub(super) fn part(&mut self, unit: &mut Unit) {
        let token = self.peek();
        if let Some(section) = self.section(token) {
            self.at += 1;
            return self.declarations(token, section, unit);
        }
        if self.unknown_section(token, unit) {
            return;
        }
        if self.begins_types() {
            return self.types();
        }
        if self.begins_line() {
            self.tell_signs();
        }
        match token.kind {
            Kind::NewLine | Kind::Semicolon => {
                self.at += 1;
                self.open_here = 0;
            }
            Kind::Close => {
                self.at += 1;
                self.open_here = self.open_here.saturating_sub(1);
                unit.body.push(Stmt::Close(token.span));
            }
            Kind::Number | Kind::Minus if self.begins_line() && self.is_numeric_code() => {
                let sign = usize::from(token.kind == Kind::Minus);
                let span = token.span.to(self.ahead(sign).span);
                let text = self.text_of(span).to_owned();
                self.tell(Code::NumericCode, span, [text.into()]);
                self.skip_line();
            }
            // The number of a line, as listings have it.
            Kind::Number if self.begins_line() && self.is_digits(token) => self.at += 1,
            Kind::Name if self.is(token, "NETWORK") => self.skip_line(),
            Kind::Name if self.is(token, "END_VAR") && self.headless => {
                self.headless = false;
                self.at += 1;
            }
            Kind::Name if self.is(token, "END_VAR") => {
                let why = (
                    "write VAR before the declarations",
                    "escreva VAR antes das declarações",
                );
                let word = self.text_of(token.span).to_owned();
                self.tell(Code::Structure, token.span, [word.into(), why.into()]);
                self.at += 1;
            }
            // A declaration that no VAR has announced.
            Kind::Name if self.declares_alone() => {
                if !self.headless {
                    let why = (
                        "write VAR before the declarations",
                        "escreva VAR antes das declarações",
                    );
                    let word = self.text_of(token.span).to_owned();
                    self.tell(Code::Structure, token.span, [word.into(), why.into()]);
                }
                self.headless = true;
                self.wrong_declarations = true;
                self.skip_line();
            }
            Kind::Name if self.ahead(1).kind == Kind::Colon => {
                self.at += 2;
                self.label(token, unit);
            }
            Kind::Name if self.ahead(1).kind == Kind::Assign => {
                let span = token.span.to(self.ahead(1).span);
                self.structured_text(span);
            }
            Kind::Name | Kind::And | Kind::Equals => self.instruction(unit),
            _ => {
                let first = self.at;
                self.unexpected();
                self.wrong(first, unit);
            }
        }
    }

    /// Tells of the signs of Structured Text in this line that stand in no piece of that.
    fn tell_signs(&mut self) {
        let mut open = 0_u32;
        let mut before = Kind::NewLine;
        let mut stray = Vec::new();
        for token in self.tokens.iter().skip(self.at) {
            let sign = self.text_of(token.span);
            match token.kind {
                Kind::NewLine | Kind::End => break,
                Kind::Open => open += 1,
                Kind::Close => open = open.saturating_sub(1),
                Kind::Sign if sign == "[" && before == Kind::Name => open += 1,
                Kind::Sign if sign == "]" && open > 0 => open -= 1,
                // `a[1].x`
                Kind::Sign if sign == "." && before == Kind::Sign => {}
                Kind::Sign if open == 0 => stray.push(token.span),
                _ => {}
            }
            before = token.kind;
        }
        for span in stray {
            let line = self.lines.line(span.start);
            let text = self.text_of(span).to_owned();
            self.found.tell(Code::StrayCharacter, span, [text.into()]);
            self.stray_lines.insert(line);
            self.wrong_lines.insert(line);
        }
    }

    /// Whether this line declares a variable: a name, and a type after its colon.
    fn declares_alone(&self) -> bool {
        let next = self.ahead(1);
        let named = matches!(next.kind, Kind::Colon | Kind::Comma) || self.is(next, "AT");
        let of_a_block = || {
            let ty = self.ahead(2);
            ty.kind == Kind::Name && operators::find(&self.word(ty).text).is_none()
        };
        named && (self.line_declares() || self.headless && of_a_block())
    }

    /// The line from this token on comes to nothing.
    fn wrong(&self, first: usize, unit: &mut Unit) {
        let line = self.tokens.get(first..self.at).unwrap_or_default();
        let count = |kind| line.iter().filter(|token| token.kind == kind).count();
        let open = count(Kind::Open).saturating_sub(count(Kind::Close));
        unit.body.push(Stmt::Wrong { open });
    }

    pub(super) fn word_at(&self, span: Span) -> String {
        self.text_of(span).to_uppercase()
    }

    pub(super) fn begins_line(&self) -> bool {
        let before = self.at.checked_sub(1).and_then(|at| self.tokens.get(at));
        before.is_none_or(|before| before.kind == Kind::NewLine)
    }

    fn label(&mut self, token: Token, unit: &mut Unit) {
        let word = self.word(token);
        let mut letters = word.text.chars();
        let good = letters.next().is_some_and(char::is_alphabetic)
            && letters.all(|c| c.is_alphanumeric() || c == '_')
            && word.text.chars().count() <= 16;
        if !good {
            let text = self.text_of(token.span).to_owned();
            self.tell(Code::BadLabel, token.span, [text.into()]);
        }
        unit.body.push(Stmt::Label(word));
    }

    fn instruction(&mut self, unit: &mut Unit) {
        let first = self.at;
        let errors = self.errors;
        let stray = self.is_stray();
        let operator = if stray { None } else { self.operator(unit) };
        let Some((spelling, mut span)) = operator else {
            self.at = first;
            if self.line_declares() {
                self.headless = true;
                self.wrong_declarations = true;
            }
            self.skip_line();
            return self.wrong(first, unit);
        };
        let mut op = spelling.op;
        // `SHL (IN := w, N := 2)`
        let named = self.ahead(1).kind == Kind::Name && self.ahead(2).kind == Kind::Assign;
        if self.peek().kind == Kind::Open && named && self.is_norm(&self.word_at(span)) {
            op = Op::Function;
        }
        let mut open = None;
        if !matches!(op, Op::Function) && self.peek().kind == Kind::Open {
            let paren = self.advance();
            span = span.to(paren.span);
            if op.may_defer() {
                let n = self.peek();
                let behind = self.ahead(1).kind;
                let alone = matches!(behind, Kind::NewLine | Kind::End | Kind::Close);
                let negated = self.is(n, "N") && !(alone && self.declares_n);
                if negated {
                    self.at += 1;
                    span = span.to(n.span);
                }
                let span = paren.span;
                self.open_here += 1;
                open = Some(Open { span, negated });
            } else {
                let name = self.text_of(span).to_owned();
                self.tell(Code::BadModifier, span, [name.into(), "(".into()]);
            }
        }
        let mut operands = match op {
            Op::Not
            | Op::Edge(_)
            | Op::Unary(_)
            | Op::Push
            | Op::Part(_)
            | Op::End
            | Op::Keep
            | Op::Recall
            | Op::Release
            | Op::AndBlock
            | Op::OrBlock
            | Op::OutBlock
            | Op::EndBlock => Vec::new(),
            _ if open.is_some() && self.loads() => Vec::new(),
            op if op.is_real() => self
                .real()
                .map_or_else(|| self.operands(false), |real| vec![real]),
            Op::Store => self.stored(),
            Op::OmronTimer | Op::OmronCounter => self.omron_operands(op),
            op => self.operands(op.may_have_more()),
        };
        if op == Op::Preset {
            op = Op::Store;
            let member = self.word_at(span);
            operands
                .iter_mut()
                .take(1)
                .for_each(|block| block.add_member(&member));
        }
        let mut params = Vec::new();
        if matches!(op, Op::Call | Op::Function) && self.take(Kind::Open).is_some() {
            params = self.params();
        }
        let before = self.at.saturating_sub(1);
        let end = self.tokens.get(before).map_or(span, |token| token.span);
        unit.body.push(Stmt::Instr(Box::new(Instr {
            op,
            function: (op == Op::Function).then(|| self.word_at(span)),
            negated: spelling.negated,
            conditional: spelling.conditional,
            edge: spelling.edge,
            open,
            operands,
            params,
            span,
            whole: if end.start >= span.start {
                span.to(end)
            } else {
                span
            },
        })));
        match self.peek().kind {
            // It closes what was deferred, on the same line.
            Kind::Close | Kind::NewLine | Kind::End | Kind::Semicolon => {}
            // What is in parentheses may stand on one line.
            Kind::Name | Kind::And if self.open_here > 0 && self.acts() => {}
            _ => self.unexpected(),
        }
        if self.errors > errors {
            unit.body.pop();
            self.wrong(first, unit);
        }
    }

    /// Whether an operator comes next.
    fn acts(&self) -> bool {
        let next = self.peek();
        next.kind == Kind::And || operators::find(&self.word(next).text).is_some()
    }

    /// Whether `LD I2` comes next, and not the name of an operand.
    fn loads(&self) -> bool {
        let word = operators::find(&self.word(self.peek()).text);
        let load = word.is_some_and(|word| word.op == Op::Load);
        load && matches!(
            self.ahead(1).kind,
            Kind::Name | Kind::Number | Kind::Literal
        )
    }

    /// Whether a block is called by its name alone, `T1 (IN := I1)`: its parenthesis comes next.
    fn calls_by_name(&self) -> bool {
        let behind = self.tokens.get(self.at + 1..).unwrap_or_default();
        let mut behind = behind.iter().filter(|token| token.kind != Kind::NewLine);
        let named = behind.next().is_some_and(|token| token.kind == Kind::Name);
        let given = behind.next().map(|token| token.kind);
        let assigns = matches!(given, Some(Kind::Assign | Kind::Arrow));
        self.peek().kind == Kind::Open && named && assigns
    }

    /// The operator that comes next, its modifiers but the parenthesis, and its place.
    fn operator(&mut self, unit: &mut Unit) -> Option<(Spelling, Span)> {
        let token = self.advance();
        let made = |op, negated| Spelling {
            op,
            negated,
            conditional: false,
            edge: None,
            dialect: None,
        };
        if token.kind == Kind::Equals {
            self.signs.see(Dialect::S7200);
            return Some((made(Op::Store, false), token.span));
        }
        let next = self.peek();
        if token.kind == Kind::And {
            let negated = self.is(next, "N") && next.span.start == token.span.end;
            if negated {
                self.at += 1;
            }
            let span = if negated {
                token.span.to(next.span)
            } else {
                token.span
            };
            return Some((made(Op::And, negated), span));
        }
        let word = self.word(token).text;
        if self.functions.contains(&word) {
            return Some((made(Op::Function, false), token.span));
        }
        // Instruction List has these alone on their lines.
        let alone = matches!(next.kind, Kind::NewLine | Kind::Semicolon | Kind::End);
        let structured = operators::is_structured_text(&word) && !alone;
        let Some(mut spelling) = operators::find(&word).filter(|_| !structured) else {
            if self.is_norm(&word) {
                return Some((made(Op::Function, false), token.span));
            }
            if operators::is_structured_text(&word) {
                self.structured_text(token.span);
                return None;
            }
            if self.calls_by_name() {
                // The name is the operand.
                self.at -= 1;
                return operators::find("CAL").map(|call| (call, token.span));
            }
            if let Some(meant) = operators::of_other_language(&word) {
                let text = self.text_of(token.span).to_owned();
                self.tell(Code::OtherWord, token.span, [text.into(), meant.into()]);
                return None;
            }
            let word_follows = next.kind == Kind::Name
                && operators::find(&self.word(next).text).is_some()
                && !word.contains(['.', '%']);
            if word_follows && operators::nearest(&word).is_none() {
                let text = self.text_of(token.span).to_owned();
                self.tell(Code::LabelColon, token.span, [text.into()]);
                self.label(token, unit);
                return self.operator(unit);
            }
            self.no_operator(&word, token);
            return None;
        };
        if let Some(dialect) = spelling.dialect {
            self.signs.see(dialect);
        }
        if word == "OUT" {
            self.signs.see_out();
        }
        let mut span = token.span;
        let end_behind = matches!(self.ahead(1).kind, Kind::NewLine | Kind::End);
        if spelling.op.may_negate() && self.is(next, "NOT") {
            // LD NOT, as OMRON writes it.
            self.at += 1;
            self.signs.see(Dialect::Omron);
            spelling.negated = !spelling.negated;
            span = span.to(next.span);
        } else if matches!(spelling.op, Op::And | Op::Or) && self.is(next, "LD") && end_behind {
            self.at += 1;
            self.signs.see(Dialect::Omron);
            spelling.op = match spelling.op {
                Op::And => Op::AndBlock,
                _ => Op::OrBlock,
            };
            span = span.to(next.span);
        }
        Some((spelling, span))
    }

    /// Tells what may have been meant by a word that is no operator.
    fn no_operator(&mut self, word: &str, token: Token) {
        let written = self.text_of(token.span).to_owned();
        for modifier in ["CN", "C", "N"] {
            let base = word.strip_suffix(modifier);
            if let Some(base) = base.filter(|base| operators::find(base).is_some()) {
                return self.tell(
                    Code::BadModifier,
                    token.span,
                    [base.into(), modifier.into()],
                );
            }
        }
        let help = match operators::nearest(word) {
            Some(near) => (
                format!("did you mean {near}?"),
                format!("você quis dizer {near}?"),
            ),
            None => (
                "each line begins with an operator, like LD, AND, OR or ST".to_owned(),
                "cada linha começa com um operador, como LD, AND, OR ou ST".to_owned(),
            ),
        };
        self.tell(
            Code::UnknownOperator,
            token.span,
            [written.into(), help.into()],
        );
    }
}
