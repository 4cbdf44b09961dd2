//! `VAR … END_VAR`.

use super::Parser;
use super::types::TYPES;
use crate::ast::{Init, Section, Unit, Var, Word};
use crate::lexer::{Kind, SECTIONS, Token};
use crate::operators;
use unoclp_st::pieces::Declared;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::Base;
use unoclp_tree::build::Edge;

/// What a section says of its variables.
struct Of {
    section: Section,
    retain: bool,
    constant: bool,
}

impl Parser<'_, '_> {
    /// The section that this word opens.
    pub(super) fn section(&self, token: Token) -> Option<Section> {
        let words = [
            ("VAR", Section::Local),
            ("VAR_TEMP", Section::Temp),
            ("VAR_GLOBAL", Section::Global),
            ("VAR_EXTERNAL", Section::External),
            ("VAR_IN_OUT", Section::InOut),
            ("VAR_INPUT", Section::Input),
            ("VAR_OUTPUT", Section::Output),
        ];
        let mut words = words.into_iter();
        words
            .find(|(word, _)| self.is(token, word))
            .map(|(_, section)| section)
    }

    /// A section that this compiler does not have is told, and its declarations are read all the same.
    pub(super) fn unknown_section(&mut self, token: Token, unit: &mut Unit) -> bool {
        let word = self.text_of(token.span).to_owned();
        let known = |section: &str| self.is(token, section);
        let unknown = SECTIONS.iter().any(|section| known(section));
        if unknown {
            let help = (
                "declarations begin with VAR, VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT, VAR_TEMP, VAR_GLOBAL or VAR_EXTERNAL",
                "as declarações começam com VAR, VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT, VAR_TEMP, VAR_GLOBAL ou VAR_EXTERNAL",
            );
            self.tell(
                Code::UnknownOperator,
                token.span,
                [word.into(), help.into()],
            );
            self.at += 1;
            self.declarations(token, Section::Local, unit);
        }
        unknown
    }

    /// From after the word that opens a section to END_VAR.
    pub(super) fn declarations(&mut self, opening: Token, section: Section, unit: &mut Unit) {
        self.declaring = true;
        self.declare_all(opening, section, unit);
        self.declaring = false;
    }

    fn declare_all(&mut self, opening: Token, section: Section, unit: &mut Unit) {
        let (mut retain, mut constant) = (false, false);
        loop {
            if self.is(self.peek(), "RETAIN") {
                retain = true;
            } else if self.is(self.peek(), "CONSTANT") {
                constant = true;
            } else {
                break;
            }
            self.advance();
        }
        loop {
            let token = self.peek();
            match token.kind {
                Kind::NewLine | Kind::Semicolon => self.at += 1,
                Kind::Name if self.is(token, "END_VAR") => {
                    self.at += 1;
                    return;
                }
                Kind::Name if !self.is_instruction() => {
                    self.wrong_declarations |= self.is_stray();
                    let of = Of {
                        section,
                        retain,
                        constant,
                    };
                    self.declaration(&of, unit);
                }
                Kind::Name | Kind::End => {
                    let why = (
                        "write END_VAR after the declarations",
                        "escreva END_VAR depois das declarações",
                    );
                    let word = self.text_of(opening.span).to_owned();
                    self.headless = true;
                    return self.tell(Code::Structure, opening.span, [word.into(), why.into()]);
                }
                _ => self.unexpected_declaration(),
            }
        }
    }

    /// Tells that the next token was not expected, and passes over the rest of the declaration.
    fn unexpected_declaration(&mut self) {
        let token = self.peek();
        // Where a line ends too early, it is its last word that was not expected.
        let at = match token.kind {
            Kind::NewLine | Kind::End => self.at.saturating_sub(1),
            _ => self.at,
        };
        let span = self.tokens.get(at).map_or(token.span, |token| token.span);
        let text = self.text_of(span).to_owned();
        self.tell(Code::Unexpected, span, [text.into()]);
        loop {
            let next = self.peek();
            let ends = matches!(next.kind, Kind::NewLine | Kind::Semicolon | Kind::End);
            if ends || self.is(next, "END_VAR") {
                return;
            }
            self.at += 1;
        }
    }

    /// Whether an instruction comes, and not a declaration.
    fn is_instruction(&self) -> bool {
        let next = self.ahead(1);
        let word = self.peek();
        if SECTIONS.iter().any(|section| self.is(word, section)) {
            return true;
        }
        let declares = matches!(next.kind, Kind::Colon | Kind::Comma)
            || self.is(next, "AT")
            || TYPES.iter().any(|ty| self.is(next, ty));
        !declares && operators::find(&self.word(self.peek()).text).is_some()
    }

    /// `start, stop AT %IX1 : BOOL := TRUE;`
    fn declaration(&mut self, of: &Of, unit: &mut Unit) {
        let first = self.at;
        let mut names = Vec::new();
        while let Some(name) = self.take(Kind::Name) {
            names.push(self.word(name));
            if self.take(Kind::Comma).is_none() {
                break;
            }
        }
        let mut at = None;
        if self.is(self.peek(), "AT") {
            self.advance();
            at = self.operand();
        }
        if self.take(Kind::Colon).is_none() {
            let next = self.peek();
            if next.kind != Kind::Name || self.is(next, "END_VAR") {
                return self.unexpected_declaration();
            }
            self.colon_missing(
                next,
                (
                    "a declaration is a name, a colon and a type: start AT %IX1 : BOOL;",
                    "uma declaração é um nome, dois-pontos e um tipo: start AT %IX1 : BOOL;",
                ),
            );
        }
        if self.is_typed() {
            self.at = first;
            return self.typed_declaration(of, unit);
        }
        let Some(ty) = self.take(Kind::Name) else {
            return self.unexpected_declaration();
        };
        let ty = self.word(ty);
        let span = self.peek().span;
        let edge = Edge::named(self.text_of(span), span);
        if edge.is_some() {
            self.at += 1;
        }
        if self.peek().kind == Kind::Equals {
            self.equals_for_assign();
            self.at += 1;
            self.init();
        }
        let init = match self.take(Kind::Assign) {
            Some(_) => self.init(),
            None => Vec::new(),
        };
        for name in names {
            unit.vars.push(Var {
                section: of.section,
                retain: of.retain,
                constant: of.constant,
                name,
                at: at.clone(),
                ty: Word { ..ty.clone() },
                edge,
                init: init.clone(),
                typed: None,
            });
        }
        let next = self.peek();
        let ends = matches!(next.kind, Kind::Semicolon | Kind::NewLine | Kind::End);
        if !ends && !self.is(next, "END_VAR") {
            self.unexpected_declaration();
        }
    }

    /// Whether the type that comes is none of bits, whole numbers of the board, or blocks.
    fn is_typed(&self) -> bool {
        let token = self.peek();
        let word = self.word(token).text;
        match token.kind {
            Kind::Open => true,
            Kind::Name if TYPES.contains(&word.as_str()) => {
                // `INT (0..100)`
                let range = (2..6).any(|at| self.text_of(self.ahead(at).span) == "..");
                self.ahead(1).kind == Kind::Open && range
            }
            Kind::Name => {
                Base::named(&word).is_some_and(|base| !base.is_plain())
                    || matches!(word.as_str(), "ARRAY" | "STRUCT")
                    || self.type_names.contains(&word)
            }
            _ => false,
        }
    }

    /// A declaration as Structured Text has it.
    fn typed_declaration(&mut self, of: &Of, unit: &mut Unit) {
        let span = Span {
            start: self.peek().span.start,
            end: self.end_of_declaration(),
        };
        let declared = self.within(|text, found| Declared::read(text, span, found));
        let Some((declared, end)) = declared else {
            self.wrong_declarations = true;
            return self.skip_to(span.end);
        };
        self.skip_to(end);
        let ty = Word {
            text: self.word_at(declared.spec()),
            span: declared.spec(),
        };
        let names = declared.names().map(|(name, span)| Word {
            text: name.to_uppercase(),
            span,
        });
        let names: Vec<Word> = names.collect();
        let edge = declared.edge();
        let number = self.pieces.declare(declared);
        for name in names {
            unit.vars.push(Var {
                section: of.section,
                retain: of.retain,
                constant: of.constant,
                name,
                at: None,
                ty: ty.clone(),
                edge,
                init: Vec::new(),
                typed: Some(number),
            });
        }
    }

    /// Where a declaration ends at the latest: after its semicolon, or at END_VAR.
    fn end_of_declaration(&self) -> u32 {
        let mut open = 0_u32;
        for (at, token) in self.tokens.iter().enumerate().skip(self.at) {
            match token.kind {
                Kind::NewLine if open == 0 && self.ahead_of(at + 2).kind == Kind::Colon => {
                    return token.span.start;
                }
                Kind::Name if self.is(*token, "STRUCT") => open += 1,
                Kind::Name if self.is(*token, "END_STRUCT") => open = open.saturating_sub(1),
                Kind::Name if self.is(*token, "END_VAR") => return token.span.start,
                Kind::Semicolon if open == 0 => return token.span.end,
                _ => {}
            }
        }
        self.text.len() as u32
    }

    pub(super) fn colon_missing(&mut self, before: Token, help: (&str, &str)) {
        let text = self.text_of(before.span).to_owned();
        self.tell(Code::ColonMissing, before.span, [text.into(), help.into()]);
    }

    /// `=` where `:=` is meant.
    pub(super) fn equals_for_assign(&mut self) {
        let help = (
            "to give an input a value, write :=, as in IN := I1",
            "para dar um valor a uma entrada, escreva :=, como em IN := I1",
        );
        self.colon_missing(self.peek(), help);
    }

    /// `T#5s`, or `(PT := T#5s)`.
    fn init(&mut self) -> Vec<Init> {
        let mut inits = Vec::new();
        let listed = self.take(Kind::Open).is_some();
        loop {
            let mut name = None;
            if listed && self.ahead(1).kind == Kind::Assign {
                name = self.take(Kind::Name).map(|name| self.word(name));
                self.at += 1;
            }
            let Some(value) = self.operand() else {
                self.unexpected_declaration();
                return inits;
            };
            inits.push(Init { name, value });
            if !listed || self.take(Kind::Comma).is_none() {
                break;
            }
        }
        if listed && self.take(Kind::Close).is_none() {
            self.unexpected_declaration();
        }
        inits
    }
}
