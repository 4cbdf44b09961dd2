//! What stands where in a text: units, their variables, bodies and charts, as they are written.
//!
//! Owns places alone: what a drawing or an exchange format takes over as it stands. Must not know what a name means.

use super::ast::{self, File, UnitDecl};
use super::lexer::tokens;
use super::parser::parse;
use super::token::{Dialect, Kind, Token};
use super::words::Keyword;
use std::collections::HashMap;
use unoclp_chart::{Action, Chart, Does, Name, Step, Transition};
use unoclp_text::diagnostics::{Found, Span};
use unoclp_tree::UnitKind;
use unoclp_tree::build::Section;

/// A text by its parts.
#[derive(Clone, Debug, Default)]
pub struct Parts {
    /// The types that it declares: the name, the type, the first value.
    pub types: Vec<(Name, Span, Option<Span>)>,
    /// Its sections of global variables.
    pub globals: Vec<Variables>,
    /// Programs, functions and blocks, in the order of the text.
    pub units: Vec<Unit>,
}

/// A program, a function or a block.
#[derive(Clone, Debug)]
pub struct Unit {
    /// Which of them.
    pub kind: UnitKind,
    /// Its name; the place is empty where the text has none.
    pub name: Name,
    /// The type of the result of a function.
    pub result: Option<Span>,
    /// Its sections of variables.
    pub variables: Vec<Variables>,
    /// What stands after its variables, as far as its end.
    pub body: Span,
    /// Its chart, where the body is one.
    pub chart: Option<Written>,
}

/// A section of variables.
#[derive(Clone, Debug)]
pub struct Variables {
    /// Which section it is.
    pub section: Section,
    /// Whether nothing changes them.
    pub constant: bool,
    /// Whether they outlast a power cut.
    pub retain: bool,
    /// Its declarations.
    pub all: Vec<Declaration>,
}

/// Variables of one declaration.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Their names.
    pub names: Vec<Name>,
    /// Where they are.
    pub address: Option<String>,
    /// Their type.
    pub of: Span,
    /// What they begin with.
    pub initial: Option<Span>,
}

/// A chart as it is written: where its conditions, times and bodies stand, and where each of its parts does.
#[derive(Clone, Debug)]
pub struct Written {
    /// The chart.
    pub chart: Chart<Span, Span>,
    /// From INITIAL_STEP or STEP to END_STEP.
    pub steps: Vec<Span>,
    /// From TRANSITION to END_TRANSITION.
    pub transitions: Vec<Span>,
    /// From ACTION to END_ACTION.
    pub actions: Vec<Span>,
}

/// The parts of a text in Structured Text, as far as they can be told.
pub fn parts(text: &str) -> Parts {
    let mut found = Found::default();
    let (file, _) = parse(text, Dialect::Iec, &mut found);
    let words = Words::of(text);
    Parts {
        types: file.types.iter().map(|ty| words.type_of(ty)).collect(),
        globals: file.globals.iter().map(|of| words.section(of)).collect(),
        units: units(&file, &words),
    }
}

/// Whether a text may hold a chart: only such a text is worth its parts.
pub fn may_hold_chart(text: &str) -> bool {
    let word = "INITIAL_STEP";
    let mut windows = text.as_bytes().windows(word.len());
    windows.any(|window| window.eq_ignore_ascii_case(word.as_bytes()))
}

fn units(file: &File, words: &Words<'_>) -> Vec<Unit> {
    file.units.iter().map(|unit| words.unit(unit)).collect()
}

/// The words of a text, and which of them begins where.
struct Words<'t> {
    text: &'t str,
    tokens: Vec<Token>,
    at: HashMap<u32, usize>,
}

impl<'t> Words<'t> {
    fn of(text: &'t str) -> Words<'t> {
        let tokens = tokens(text, 0, Dialect::Iec, &mut Found::default());
        let starts = tokens.iter().enumerate();
        let at = starts.map(|(number, token)| (token.span.start, number));
        let at = at.collect();
        Words { text, tokens, at }
    }

    fn keyword(&self, number: usize) -> Keyword {
        let token = self.tokens.get(number);
        let word = token.filter(|token| token.kind == Kind::Word);
        word.map_or(Keyword::None, |token| {
            Keyword::of(self.text.get(token.span.range()).unwrap_or_default())
        })
    }

    /// The number of the word that begins here.
    fn number(&self, at: Span) -> usize {
        let last = self.tokens.len().saturating_sub(1);
        self.at.get(&at.start).copied().unwrap_or(last)
    }

    fn span(&self, number: usize) -> Span {
        let last = self.tokens.last();
        let token = self.tokens.get(number).or(last);
        token.map_or(Span::default(), |token| token.span)
    }

    /// From this word on the first that is such a keyword, or the end.
    fn until(&self, from: usize, is: impl Fn(Keyword) -> bool) -> usize {
        let last = self.tokens.len().saturating_sub(1);
        let mut rest = from..last;
        rest.find(|number| is(self.keyword(*number)))
            .unwrap_or(last)
    }

    /// What stands from this word to before that one.
    fn between(&self, from: usize, to: usize) -> Span {
        match to.checked_sub(1).filter(|last| *last >= from) {
            Some(last) => self.span(from).to(self.span(last)),
            None => self.span(from).empty(),
        }
    }

    fn type_of(&self, ty: &ast::TypeDecl) -> (Name, Span, Option<Span>) {
        let initial = ty.initial.as_ref().map(|_| self.initial(ty.spec.span));
        (name(&ty.name), ty.spec.span, initial)
    }

    /// What stands after `:=`, as far as the semicolon.
    fn initial(&self, spec: Span) -> Span {
        let mut from = self.number(spec);
        while self.span(from).start < spec.end && from + 1 < self.tokens.len() {
            from += 1;
        }
        let is_end =
            |number: &usize| matches!(self.tokens[*number].kind, Kind::Semicolon | Kind::End);
        let first =
            (from..self.tokens.len()).find(|number| self.tokens[*number].kind == Kind::Assign);
        let first = first.map_or(from, |assign| assign + 1);
        let end = (first..self.tokens.len()).find(is_end);
        self.between(first, end.unwrap_or(first))
    }

    fn section(&self, of: &ast::Vars) -> Variables {
        let declared = of.decls.iter().map(|decl| Declaration {
            names: decl.names.iter().map(name).collect(),
            address: decl.at.as_ref().map(|at| at.text.clone()),
            of: decl.spec.span,
            initial: decl.initial.as_ref().map(|_| self.initial(decl.spec.span)),
        });
        Variables {
            section: Section::from(of.section),
            constant: of.constant,
            retain: of.retain,
            all: declared.collect(),
        }
    }

    fn unit(&self, unit: &UnitDecl) -> Unit {
        let is_named = unit.name.span.start < unit.name.span.end;
        let first = match is_named {
            true => self.number(unit.name.span) + 1,
            false => self.number(unit.name.span),
        };
        let end = self.until(first, |word| word.ends_unit() || word.begins_unit());
        // After the last section, or after the head.
        let mut begin = match unit.result.as_ref() {
            Some(result) => self.after(first, result.span.end),
            None => first,
        };
        for number in (first..end).rev() {
            if self.keyword(number) == Keyword::EndVar {
                begin = number + 1;
                break;
            }
        }
        while begin < end && self.tokens[begin].kind == Kind::Semicolon {
            begin += 1;
        }
        let body = match unit.chart.as_ref() {
            Some(chart) => self.number(chart.at)..end,
            None => begin..end,
        };
        Unit {
            kind: unit.kind,
            name: name(&unit.name),
            result: unit.result.as_ref().map(|result| result.span),
            variables: unit.vars.iter().map(|of| self.section(of)).collect(),
            body: self.between(body.start, body.end),
            chart: unit.chart.as_ref().map(|chart| self.chart(chart)),
        }
    }

    /// The first word from this on that begins at this byte or after.
    fn after(&self, from: usize, byte: u32) -> usize {
        let last = self.tokens.len().saturating_sub(1);
        let mut rest = from..last;
        rest.find(|number| self.span(*number).start >= byte)
            .unwrap_or(last)
    }

    fn chart(&self, chart: &ast::Chart) -> Written {
        let mut written = Written {
            chart: Chart {
                steps: Vec::with_capacity(chart.steps.len()),
                transitions: Vec::with_capacity(chart.transitions.len()),
                actions: Vec::with_capacity(chart.actions.len()),
                at: chart.at,
            },
            steps: Vec::new(),
            transitions: Vec::new(),
            actions: Vec::new(),
        };
        for step in &chart.steps {
            let named = self.number(step.name.at);
            let end = self.until(named, Keyword::ends_part_of_chart);
            written
                .steps
                .push(self.between(named.saturating_sub(1), end + 1));
            let does = step.does.iter().map(|does| Does {
                action: does.action.clone(),
                qualifier: does.qualifier,
                time: does.time.as_ref().map(|time| time.span),
            });
            written.chart.steps.push(Step {
                name: step.name.clone(),
                initial: step.initial,
                does: does.collect(),
            });
        }
        for transition in &chart.transitions {
            let begin = self.number(transition.at);
            let end = self.until(begin, Keyword::ends_part_of_chart);
            written.transitions.push(self.between(begin, end + 1));
            let mut from = self.after(begin, transition.at.end);
            from += usize::from(self.tokens[from].kind == Kind::Assign);
            let mut to = end.max(from);
            while to > from && self.tokens[to - 1].kind == Kind::Semicolon {
                to -= 1;
            }
            written.chart.transitions.push(Transition {
                name: transition.name.clone(),
                priority: transition.priority,
                from: transition.from.clone(),
                to: transition.to.clone(),
                condition: self.between(from, to),
                at: transition.at,
            });
        }
        for action in &chart.actions {
            let named = self.number(action.name.at);
            let end = self.until(named, Keyword::ends_part_of_chart);
            written
                .actions
                .push(self.between(named.saturating_sub(1), end + 1));
            let colon = self.tokens.get(named + 1).map(|token| token.kind) == Some(Kind::Colon);
            // Comments before the first statement and after the last belong to it.
            let start = self.span(if colon { named + 1 } else { named }).end;
            let body = Span {
                start,
                end: self.span(end).start.max(start),
            };
            written.chart.actions.push(Action {
                name: action.name.clone(),
                body,
            });
        }
        written
    }
}

fn name(of: &ast::Name) -> Name {
    Name {
        text: of.text.clone(),
        at: of.span,
    }
}
