//! From words to the syntax tree. It never gives up: what it cannot read is told and passed over.

mod declare;
mod foreign;
mod operand;
mod points;
mod statement;
mod types;

use types::TYPES;

use crate::ast::{Unit, UnitKind, Word};
use crate::lexer::{Kind, Token, Words, words};
use std::collections::HashSet;
use unoclp_st::pieces::Pieces;
use unoclp_text::diagnostics::{Code, Found, Lines, Severity, Span, Word as Said};
use unoclp_text::dialect::Signs;
use unoclp_tree::build::is_function;

/// A declaration has no more words before its type than this.
const MOST_WORDS: usize = 64;

/// What the parser has read.
pub(crate) struct Parsed {
    /// The program first, then functions and function blocks.
    pub units: Vec<Unit>,
    /// What is written as in Structured Text.
    pub pieces: Pieces,
    pub signs: Signs,
    /// Where comments stand.
    pub comments: Vec<Span>,
    /// Something is wrong with the declarations or the units, so that what is said of names would mislead.
    pub wrong_declarations: bool,
}

pub(crate) fn parse(text: &str, found: &mut Found) -> Parsed {
    let Words {
        tokens,
        comments,
        remarks,
    } = words(text, found);
    let lines = Lines::new(text);
    let stray_lines: HashSet<u32> = found.errors().map(|span| lines.line(span.start)).collect();
    let mut parser = Parser {
        text,
        functions: HashSet::new(),
        pieces: Pieces::default(),
        type_names: HashSet::new(),
        own: HashSet::new(),
        in_call: false,
        declares_n: false,
        tokens,
        at: 0,
        signs: Signs::default(),
        wrong_lines: stray_lines.clone(),
        stray_lines,
        lines,
        declaring: false,
        wrong_declarations: false,
        headless: false,
        open_here: 0,
        errors: 0,
        found,
    };
    parser.find_names();
    let units = parser.units();
    remarks.iter().for_each(|&remark| parser.remark(remark));
    Parsed {
        units,
        pieces: parser.pieces,
        signs: parser.signs,
        comments,
        wrong_declarations: parser.wrong_declarations,
    }
}

struct Parser<'t, 'f> {
    text: &'t str,
    /// The names of the file's functions, which are operators too.
    functions: HashSet<String>,
    pieces: Pieces,
    /// The names of the types that TYPE declares, and what stands before a colon anywhere.
    type_names: HashSet<String>,
    own: HashSet<String>,
    /// Between the parentheses of a call, which may go over lines.
    in_call: bool,
    /// A variable is called N, as the modifier is.
    declares_n: bool,
    tokens: Vec<Token>,
    at: usize,
    signs: Signs,
    lines: Lines,
    /// Lines in which the lexer has told something, and all in which something has been told.
    stray_lines: HashSet<u32>,
    wrong_lines: HashSet<u32>,
    /// Between VAR and END_VAR.
    declaring: bool,
    wrong_declarations: bool,
    /// A declaration or the head of a unit has been told, so its END_… stands alone.
    headless: bool,
    /// Parentheses that were opened in this line, and are open.
    open_here: u32,
    /// Errors so far, also those that were not told.
    errors: u32,
    found: &'f mut Found,
}

impl Parser<'_, '_> {
    fn peek(&self) -> Token {
        self.ahead(0)
    }

    /// The token so many after the next one; the last token is the end.
    fn ahead(&self, more: usize) -> Token {
        self.ahead_of(self.at + more)
    }

    fn ahead_of(&self, at: usize) -> Token {
        let last = self.tokens.len() - 1;
        self.tokens[at.min(last)]
    }

    fn advance(&mut self) -> Token {
        let token = self.peek();
        self.at += 1;
        token
    }

    /// Takes the next token where it is of this kind.
    fn take(&mut self, kind: Kind) -> Option<Token> {
        (self.peek().kind == kind).then(|| self.advance())
    }

    fn text_of(&self, span: Span) -> &str {
        self.text.get(span.range()).unwrap_or_default()
    }

    /// The name that a token says, in upper case and without blanks.
    fn word(&self, token: Token) -> Word {
        let text = self.text_of(token.span);
        Word {
            text: text
                .chars()
                .filter(|c| !c.is_ascii_whitespace())
                .flat_map(char::to_uppercase)
                .collect(),
            span: token.span,
        }
    }

    /// Whether the token is this word, in any letter case.
    fn is(&self, token: Token, word: &str) -> bool {
        token.kind == Kind::Name && self.text_of(token.span).eq_ignore_ascii_case(word)
    }

    /// Tells of at most one error in a line: what follows in it follows from that, most of the time. That a
    /// text is in another language is told in any case.
    fn tell<const N: usize>(&mut self, code: Code, span: Span, words: [Said; N]) {
        let whole = [Code::StructuredText, Code::NumericCode].contains(&code);
        if code.severity() == Severity::Error && !whole {
            let of_units = self.declaring || code == Code::Structure || self.line_declares();
            self.wrong_declarations |= of_units;
            self.errors += 1;
            if !self.wrong_lines.insert(self.lines.line(span.start)) {
                return;
            }
        }
        self.found.tell(code, span, words);
    }

    /// Whether the lexer has told something of the line that comes.
    fn is_stray(&self) -> bool {
        let line = self.lines.line(self.peek().span.start);
        self.stray_lines.contains(&line)
    }

    /// Whether the rest of this line declares a variable.
    fn line_declares(&self) -> bool {
        let rest = self.tokens.get(self.at..).unwrap_or_default();
        let line = rest.iter().take_while(|token| token.kind != Kind::NewLine);
        let mut line = line.take(MOST_WORDS).peekable();
        while let Some(token) = line.next() {
            let Some(&&ty) = line.peek().filter(|_| token.kind == Kind::Colon) else {
                continue;
            };
            let known = TYPES.iter().any(|known| self.is(ty, known));
            // After an operator with the name of a type, such as TON, stands its operand.
            let mut behind = line.clone().skip(1);
            if known && behind.next().is_none_or(|token| token.kind != Kind::Name) {
                return true;
            }
        }
        false
    }

    /// Tells that the next token was not expected, and passes over the rest of the line.
    fn unexpected(&mut self) {
        let token = self.peek();
        if !matches!(token.kind, Kind::NewLine | Kind::End) {
            let text = self.text_of(token.span).to_owned();
            let code = match token.kind {
                Kind::Sign | Kind::Text => Code::StrayCharacter,
                _ => Code::Unexpected,
            };
            self.tell(code, token.span, [text.into()]);
        }
        self.skip_line();
    }

    fn skip_line(&mut self) {
        while !matches!(self.peek().kind, Kind::NewLine | Kind::End) {
            self.at += 1;
        }
    }

    /// Reads a piece of the text in another way; what is wrong with it counts here too.
    fn within<T>(&mut self, read: impl FnOnce(&str, &mut Found) -> T) -> T {
        let mut told = Found::default();
        let made = read(self.text, &mut told);
        for span in told.errors() {
            self.errors += 1;
            self.wrong_lines.insert(self.lines.line(span.start));
        }
        self.found.join(told);
        made
    }

    /// Goes on with what stands after this byte.
    fn skip_to(&mut self, end: u32) {
        while self.peek().kind != Kind::End && self.peek().span.start < end {
            self.at += 1;
        }
    }

    /// TYPE … END_TYPE
    fn types(&mut self) {
        let start = self.peek().span.start;
        let rest = self.tokens.iter().skip(self.at);
        let end = rest.clone().find(|token| self.is(**token, "END_TYPE"));
        let end = end.map_or(self.text.len() as u32, |token| token.span.end);
        let mut types = std::mem::take(&mut self.pieces.types);
        let span = Span { start, end };
        let right = self.within(|text, found| types.read(text, span, found));
        self.pieces.types = types;
        self.wrong_declarations |= !right;
        self.skip_to(end);
        while self.take(Kind::Semicolon).is_some() {}
    }

    /// Whether TYPE … END_TYPE begins here.
    fn begins_types(&self) -> bool {
        self.is(self.peek(), "TYPE") && self.ahead(1).kind != Kind::Colon && self.begins_line()
    }

    /// Whether this word is a function of the standard here.
    fn is_norm(&self, word: &str) -> bool {
        !self.own.contains(word) && is_function(word)
    }

    fn find_names(&mut self) {
        let mut in_types = false;
        for at in 0..self.tokens.len() {
            let name = self.tokens[at];
            let next = self.ahead_of(at + 1);
            let begins = at == 0 || self.tokens[at - 1].kind == Kind::NewLine;
            if begins && self.is(name, "TYPE") && next.kind != Kind::Colon {
                in_types = true;
            } else if self.is(name, "END_TYPE") {
                in_types = false;
            } else if name.kind == Kind::Name && next.kind == Kind::Colon {
                let word = self.word(name).text;
                if in_types {
                    self.type_names.insert(word);
                } else {
                    self.own.insert(word);
                }
            }
        }
        for at in 1..self.tokens.len() {
            let (before, name) = (self.tokens[at - 1], self.tokens[at]);
            if self.is(before, "FUNCTION") && name.kind == Kind::Name {
                let name = self.word(name).text;
                self.own.insert(name.clone());
                self.functions.insert(name);
            }
            if self.is(before, "FUNCTION_BLOCK") && name.kind == Kind::Name {
                let name = self.word(name).text;
                self.own.insert(name);
            }
            let declares = matches!(name.kind, Kind::Colon | Kind::Comma) || self.is(name, "AT");
            self.declares_n |= declares && self.is(before, "N");
        }
        self.find_points();
    }

    /// What stands outside of any unit is the program's.
    fn units(&mut self) -> Vec<Unit> {
        let mut program = self.unit(UnitKind::Program, self.peek().span);
        let mut others: Vec<Unit> = Vec::new();
        let mut inside: Option<Unit> = None;
        while self.peek().kind != Kind::End {
            let token = self.peek();
            let begins = [
                ("PROGRAM", UnitKind::Program),
                ("FUNCTION", UnitKind::Function),
                ("FUNCTION_BLOCK", UnitKind::FunctionBlock),
            ];
            let begun = begins.into_iter().find(|(word, _)| self.is(token, word));
            let ends = ["END_PROGRAM", "END_FUNCTION", "END_FUNCTION_BLOCK"];
            if let Some((_, kind)) = begun {
                others.extend(self.end_unit(inside.take(), None));
                self.advance();
                let mut unit = self.unit(kind, token.span);
                unit.name = self.take(Kind::Name).map(|name| self.word(name));
                if self.take(Kind::Colon).is_some() {
                    unit.result = self.take(Kind::Name).map(|name| self.word(name));
                }
                if kind == UnitKind::Program {
                    // Its name says nothing; what stands in it is the program's.
                    unit.vars.append(&mut program.vars);
                    unit.body.append(&mut program.body);
                }
                inside = Some(unit);
                self.end_of_statement();
            } else if ends.into_iter().any(|word| self.is(token, word)) {
                self.advance();
                match self.end_unit(inside.take(), Some(token.span)) {
                    Some(unit) if unit.kind == UnitKind::Program => program = unit,
                    unit => others.extend(unit),
                }
                self.end_of_statement();
            } else if self.is(token, "CONFIGURATION") {
                self.configuration(inside.as_mut().unwrap_or(&mut program));
            } else {
                let mut unit = inside.take();
                self.part(unit.as_mut().unwrap_or(&mut program));
                inside = unit;
            }
        }
        match self.end_unit(inside, None) {
            Some(unit) if unit.kind == UnitKind::Program => program = unit,
            unit => others.extend(unit),
        }
        others.insert(0, program);
        others
    }

    /// Where a unit ends; `end` is its own END_…, none where another unit or the text's end came first.
    fn end_unit(&mut self, mut unit: Option<Unit>, end: Option<Span>) -> Option<Unit> {
        if let Some(unit) = &mut unit {
            unit.end = end.unwrap_or(self.peek().span).start;
        }
        match (&unit, end) {
            (None, Some(_)) if std::mem::take(&mut self.headless) => {}
            (None, Some(end)) => {
                let text = self.text_of(end).to_owned();
                let why = ("delete it", "apague-o");
                self.tell(Code::Structure, end, [text.into(), why.into()]);
            }
            (Some(unit), None) if unit.kind != UnitKind::Program => {
                let text = self.text_of(unit.span).to_owned();
                let why = (
                    "write END_FUNCTION or END_FUNCTION_BLOCK after its last line",
                    "escreva END_FUNCTION ou END_FUNCTION_BLOCK depois da última linha",
                );
                let span = unit.span;
                self.tell(Code::Structure, span, [text.into(), why.into()]);
            }
            _ => {}
        }
        unit
    }

    fn unit(&self, kind: UnitKind, span: Span) -> Unit {
        Unit {
            kind,
            name: None,
            result: None,
            vars: Vec::new(),
            body: Vec::new(),
            span,
            end: u32::MAX,
        }
    }

    /// A line's end, or a fault and all up to it.
    fn end_of_statement(&mut self) {
        while self.take(Kind::Semicolon).is_some() {}
        if !matches!(self.peek().kind, Kind::NewLine | Kind::End) {
            self.unexpected();
        }
    }
}
