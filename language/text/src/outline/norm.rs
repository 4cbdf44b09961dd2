//! What a text in the words of the standard declares: Structured Text, SCL, Instruction List.

use super::{Named, Outline, What, begins_name};
use crate::colour::Colour;
use crate::diagnostics::Span;

/// Whether a name with a colon after it is a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Labels {
    /// In Instruction List.
    Are,
    /// In Structured Text it is a value of a CASE.
    AreNot,
}

/// What these words of a text declare. It takes a time in proportion to their number.
pub fn norm(text: &str, words: &[(Span, Option<Colour>)], labels: Labels) -> Outline {
    let written = |span: Span| text.get(span.range()).unwrap_or_default();
    let says = |&(span, colour): &(Span, Option<Colour>)| Word {
        span,
        text: written(span),
        colour,
    };
    let words = words.iter().map(says);
    let mut walk = Walk {
        words: words.filter(|word| !word.text.trim().is_empty()).collect(),
        at: 0,
        unit: None,
        configures: false,
        named: Vec::new(),
    };
    while walk.at < walk.words.len() {
        walk.part(labels);
    }
    let end = text.len() as u32;
    if let Some(open) = walk.unit {
        walk.named[open].whole.end = end;
    }
    Outline {
        named: walk.named,
        letters_apart: false,
    }
}

#[derive(Clone, Copy)]
struct Word<'t> {
    span: Span,
    text: &'t str,
    colour: Option<Colour>,
}

impl Word<'_> {
    fn is(self, word: &str) -> bool {
        self.text.eq_ignore_ascii_case(word)
    }

    /// Whether it can be a name.
    fn is_name(self) -> bool {
        self.colour.is_none() && begins_name(self.text)
    }

    /// Whether it begins or ends a section of variables, or a unit.
    fn is_border(self) -> bool {
        const WORDS: [&str; 9] = [
            "PROGRAM",
            "FUNCTION",
            "FUNCTION_BLOCK",
            "TYPE",
            "BEGIN",
            "CONFIGURATION",
            "ORGANIZATION_BLOCK",
            "DATA_BLOCK",
            "RESOURCE",
        ];
        let starts = |with: &str| {
            let head = self.text.get(..with.len());
            head.is_some_and(|head| head.eq_ignore_ascii_case(with))
        };
        let is_section = self.is("VAR") || starts("VAR_");
        let is_word = self.colour == Some(Colour::Word);
        is_word && (is_section || starts("END_") || WORDS.iter().any(|word| self.is(word)))
    }
}

/// Where one is in the words.
struct Walk<'t> {
    words: Vec<Word<'t>>,
    at: usize,
    unit: Option<usize>,
    /// Between CONFIGURATION and its end, where PROGRAM names an instance.
    configures: bool,
    named: Vec<Named>,
}

impl<'t> Walk<'t> {
    fn word(&self, ahead: usize) -> Option<Word<'t>> {
        self.words.get(self.at + ahead).copied()
    }

    fn says(&self, ahead: usize, word: &str) -> bool {
        self.word(ahead).is_some_and(|own| own.is(word))
    }

    /// A word at which nothing else is, or a whole section.
    fn part(&mut self, labels: Labels) {
        let Some(word) = self.word(0) else { return };
        let span = word.span;
        if word.is_name() {
            let is_label = labels == Labels::Are && self.says(1, ":");
            if is_label {
                self.named.push(Named::new(What::Label, span, self.unit));
            }
            self.at += 1;
            return;
        }
        if word.colour != Some(Colour::Word) {
            self.at += 1;
            return;
        }
        let upper = word.text.to_ascii_uppercase();
        self.at += 1;
        match upper.as_str() {
            "PROGRAM" | "ORGANIZATION_BLOCK" if !self.configures => self.unit(What::Program, span),
            "FUNCTION_BLOCK" => self.unit(What::Block, span),
            "FUNCTION" => self.unit(What::Function, span),
            "END_PROGRAM" | "END_FUNCTION_BLOCK" | "END_FUNCTION" | "END_ORGANIZATION_BLOCK" => {
                if let Some(unit) = self.unit.take() {
                    self.named[unit].whole.end = span.end;
                }
            }
            "CONFIGURATION" => self.configures = true,
            "END_CONFIGURATION" => self.configures = false,
            "TYPE" => self.types(),
            "STEP" | "INITIAL_STEP" => self.part_of_chart(What::Step, span),
            "ACTION" => self.part_of_chart(What::Action, span),
            "TRANSITION" if !self.says(0, "FROM") => self.part_of_chart(What::Transition, span),
            "VAR" => self.variables(span),
            section if section.starts_with("VAR_") => self.variables(span),
            _ => {}
        }
    }

    fn unit(&mut self, what: What, keyword: Span) {
        if let Some(open) = self.unit.take() {
            self.named[open].whole.end = keyword.start;
        }
        let Some(name) = self.word(0) else { return };
        if name.is_border() {
            return;
        }
        let mut unit = Named::new(what, name.span, None);
        unit.whole = keyword.to(name.span);
        self.at += 1;
        if self.says(0, ":") {
            unit.ty = self.word(1).map(|word| word.span);
            self.at += 2;
        }
        self.unit = Some(self.named.len());
        self.named.push(unit);
    }

    fn part_of_chart(&mut self, what: What, keyword: Span) {
        let Some(name) = self.word(0).filter(|word| word.is_name()) else {
            return;
        };
        let mut part = Named::new(what, name.span, self.unit);
        part.whole = keyword.to(name.span);
        self.named.push(part);
        self.at += 1;
    }

    /// A section of variables, up to its end or what cannot be in one.
    fn variables(&mut self, section: Span) {
        while let Some(word) = self.word(0) {
            if word.is_border() {
                self.at += usize::from(word.is("END_VAR"));
                return;
            }
            match word.is_name() {
                true => self.declaration(What::Variable, self.unit, Some(section)),
                false => self.at += 1,
            }
        }
    }

    fn types(&mut self) {
        while let Some(word) = self.word(0) {
            if word.is_border() && !word.is("TYPE") {
                self.at += usize::from(word.is("END_TYPE"));
                return;
            }
            match word.is_name() && self.says(1, ":") {
                true => self.declaration(What::Type, None, None),
                false => self.at += 1,
            }
        }
    }

    /// Names, and what they are.
    fn declaration(&mut self, what: What, within: Option<usize>, section: Option<Span>) {
        let from = self.named.len();
        let begins = self.word(0).map(|word| word.span).unwrap_or_default();
        while let Some(name) = self.word(0).filter(|word| word.is_name()) {
            let mut named = Named::new(what, name.span, within);
            named.section = section;
            named.whole = begins.to(name.span);
            self.named.push(named);
            self.at += 1;
            if !self.says(0, ",") {
                break;
            }
            self.at += 1;
        }
        let to = self.named.len();
        let mut point = None;
        if self.says(0, "AT") {
            point = self.word(1).map(|word| word.span);
            self.at += 2;
        }
        let (mut ty, mut first) = (None, None);
        if self.says(0, ":") {
            self.at += 1;
            ty = self.type_of(from, what);
        }
        if self.says(0, ":=") {
            self.at += 1;
            first = self.until(|word| word.is(";"));
        }
        let end = self.words.get(self.at.saturating_sub(1));
        let end = end.map(|word| word.span).unwrap_or(begins);
        for named in &mut self.named[from..to] {
            (named.ty, named.point, named.first) = (ty, point, first);
            named.whole = named.whole.to(end);
        }
        self.at += usize::from(self.says(0, ";"));
    }

    /// A type as it is written, with what it declares itself.
    fn type_of(&mut self, owner: usize, what: What) -> Option<Span> {
        let begins = self.word(0)?;
        let within = (what == What::Type).then_some(owner);
        if begins.is("STRUCT") {
            self.at += 1;
            while let Some(word) = self.word(0) {
                if word.is_border() {
                    self.at += usize::from(word.is("END_STRUCT"));
                    break;
                }
                match word.is_name() {
                    true => self.declaration(What::Member, Some(owner), None),
                    false => self.at += 1,
                }
            }
            return Some(begins.span);
        }
        if begins.is("(") {
            self.at += 1;
            while let Some(word) = self.word(0) {
                if word.is_border() || word.is(";") {
                    break;
                }
                self.at += 1;
                if word.is(")") {
                    break;
                }
                if word.is_name() {
                    let value = Named::new(What::Value, word.span, within);
                    self.named.push(value);
                }
            }
            let end = self.words.get(self.at.saturating_sub(1))?.span;
            return Some(begins.span.to(end));
        }
        self.until(|word| word.is(";") || word.is(":="))
    }

    /// From here to the word before which this holds, or before which the next declaration begins.
    fn until(&mut self, ends: impl Fn(Word<'_>) -> bool) -> Option<Span> {
        let mut all: Option<Span> = None;
        while let Some(word) = self.word(0) {
            let is_next = word.is_name() && (self.says(1, ":") || self.says(1, "AT"));
            if ends(word) || word.is_border() || all.is_some() && is_next {
                break;
            }
            all = Some(all.map_or(word.span, |all| all.to(word.span)));
            self.at += 1;
        }
        all
    }
}
