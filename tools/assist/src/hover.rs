//! What a word stands for.

use crate::meaning::{Meaning, point};
use crate::reader::Reader;
use crate::{language, words};
use std::collections::BTreeSet;
use unoclp_lang::outline::{Named, What};
use unoclp_lang::typed::{Base, Role, Standard, functions};
use unoclp_lang::{Lang, Lines, Span};
use unoclp_program::{Source, list, point_names};
use unoclp_workspace::Analysis;

/// What there is to say of a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// The word.
    pub span: Span,
    /// What it stands for, as a text would declare it.
    pub head: String,
    /// What else there is to know, a sentence each.
    pub lines: Vec<String>,
    /// The variable or point that it names, as the live values call it.
    pub value: Option<String>,
}

/// What stands at a byte of a text; none where nothing is known of it.
pub fn hover(analysis: &Analysis, byte: u32, lang: Lang) -> Option<Hover> {
    let written = analysis.written();
    let text = written.text();
    let reader = Reader::new(&text, language(written)?);
    let at = reader.word_at(byte)?;
    let told = Told {
        reader: &reader,
        source: analysis.source(),
        lang,
    };
    told.of(at)
}

struct Told<'r, 't> {
    reader: &'r Reader<'t>,
    source: Option<&'r Source>,
    lang: Lang,
}

impl Told<'_, '_> {
    fn of(&self, at: usize) -> Option<Hover> {
        let word = self.reader.words[at];
        let meaning = self.reader.meaning(at)?;
        let lang = self.lang;
        let (head, mut lines, mut value) = match &meaning {
            Meaning::Declared(declared) => self.declared(*declared, &meaning)?,
            Meaning::Pin(block, pin) => self.pin(*block, pin)?,
            Meaning::Parameter(function, name) => (
                name.to_string(),
                vec![words::parameter_of(lang, function)],
                None,
            ),
            Meaning::Standard(block) => (shape(*block), vec![words::block(*block, lang)], None),
            Meaning::Function(name) => (signature(name), Vec::new(), None),
            Meaning::Base(base) => (base.name().to_owned(), range(*base, lang), None),
            Meaning::Point(address) => {
                let names = self.source.map(point_names).unwrap_or_default();
                let name = names.get(&address.to_string());
                let head = words::point_of_board(lang, address);
                (
                    head,
                    name.cloned().into_iter().collect(),
                    Some(address.to_string()),
                )
            }
            Meaning::Word => (String::new(), Vec::new(), None),
        };
        if meaning == Meaning::Word {
            (lines, value) = (self.line(word.span), None);
            if lines.is_empty() {
                return None;
            }
        }
        Some(Hover {
            span: word.span,
            head: if head.is_empty() {
                word.text.to_owned()
            } else {
                head
            },
            lines,
            value,
        })
    }

    fn declared(
        &self,
        at: usize,
        meaning: &Meaning,
    ) -> Option<(String, Vec<String>, Option<String>)> {
        let named = self.reader.named(at)?;
        let name = self.reader.written(named.name);
        let lang = self.lang;
        let written = |span: Option<Span>| span.map_or("", |span| self.reader.written(span));
        let what = match named.what {
            What::Program => words::program(lang),
            What::Block => words::function_block(lang),
            What::Function => words::function(lang),
            What::Type => words::a_type(lang),
            What::Value => words::value_of(lang),
            What::Step => words::step(lang),
            What::Transition => words::transition(lang),
            What::Action => words::action(lang),
            What::Label => words::label(lang),
            What::Variable | What::Member => String::new(),
        };
        let mut head = name.to_owned();
        if named.what.is_unit() {
            head = self.unit(at, named);
        } else {
            if let Some(point) = named.point {
                head = format!("{head} AT {}", self.reader.written(point));
            }
            if named.ty.is_some() {
                head = format!("{head} : {}", written(named.ty));
            }
            if named.first.is_some() {
                head = format!("{head} := {}", written(named.first));
            }
        }
        let mut lines = Vec::new();
        if !what.is_empty() {
            lines.push(what);
        }
        let section = written(named.section);
        if !section.is_empty() && !section.eq_ignore_ascii_case("VAR") {
            lines.push(section.to_ascii_uppercase());
        }
        let points = self.points(name, named);
        if !points.is_empty() {
            lines.push(words::place(lang, points.join(", ")));
        }
        let uses = self.reader.uses(meaning);
        let used = uses.iter().filter(|own| !own.declares).count();
        let writes = uses.iter().filter(|own| own.writes).count();
        if matches!(named.what, What::Variable) {
            lines.push(match (used, writes) {
                (0, _) => words::never_used(lang),
                (_, 0) => words::never_written(lang, used),
                _ => words::used(lang, used, writes),
            });
        }
        let is_shown = named.what == What::Variable;
        Some((head, lines, is_shown.then(|| name.to_owned())))
    }

    /// Where a variable of the program stands on the board.
    fn points(&self, name: &str, named: &Named) -> Vec<String> {
        let unit = named.within.and_then(|unit| self.reader.named(unit));
        let is_own = unit.is_none_or(|unit| unit.what == What::Program);
        let Some(source) = self
            .source
            .filter(|_| named.what == What::Variable && is_own)
        else {
            return Vec::new();
        };
        let folded = self.reader.fold(name);
        let is_of = |variable: &str| {
            let begins = variable.split(['.', '[']).next().unwrap_or_default();
            self.reader.fold(begins) == folded
        };
        let own = source.variables.iter().filter(|own| is_of(&own.name));
        let points: BTreeSet<String> = own
            .filter_map(|own| own.point(|_| Some(0)))
            .map(|point| point.to_string())
            .collect();
        let at = named
            .point
            .and_then(|span| point(self.reader.written(span)));
        match points.is_empty() {
            true => at.map(|point| point.to_string()).into_iter().collect(),
            false => points.into_iter().take(8).collect(),
        }
    }

    /// A unit with what it takes and gives.
    fn unit(&self, at: usize, named: &Named) -> String {
        let sections = ["VAR_INPUT", "VAR_IN_OUT", "VAR_OUTPUT"];
        let mut parts = Vec::new();
        for section in sections {
            for part in self
                .reader
                .parts(at)
                .filter_map(|part| self.reader.named(part))
            {
                let own = part.section.map_or("", |own| self.reader.written(own));
                if own.eq_ignore_ascii_case(section) {
                    let ty = part.ty.map_or("", |ty| self.reader.written(ty));
                    let sign = if section == "VAR_OUTPUT" { " =>" } else { "" };
                    parts.push(format!("{}{sign} : {ty}", self.reader.written(part.name)));
                }
            }
        }
        let result = named.ty.map(|ty| format!(" : {}", self.reader.written(ty)));
        let name = self.reader.written(named.name);
        format!("{name}({}){}", parts.join("; "), result.unwrap_or_default())
    }

    fn pin(&self, block: Standard, pin: &str) -> Option<(String, Vec<String>, Option<String>)> {
        let (_, (name, base, role)) = block.part(pin)?;
        let said = match role {
            Role::Input => words::input_of(self.lang, block.name()),
            _ => words::output_of(self.lang, block.name()),
        };
        let about = words::block(block, self.lang);
        Some((format!("{name} : {}", base.name()), vec![said, about], None))
    }

    /// What the line of an operator does on the board, and what it costs.
    fn line(&self, span: Span) -> Vec<String> {
        let Some(source) = self.source else {
            return Vec::new();
        };
        let line = Lines::new(self.reader.text).line(span.start) as usize;
        let (effects, bytes) = list::of_line(source, line, self.lang);
        let mut lines = effects;
        if bytes > 0 {
            lines.push(words::costs(self.lang, bytes));
        }
        lines
    }
}

/// A block of the standard with its pins.
fn shape(block: Standard) -> String {
    let part = |wanted: Role| {
        let parts = block.parts().iter().filter(|part| part.2 == wanted);
        let parts = parts.map(|(name, base, _)| format!("{name} : {}", base.name()));
        parts.collect::<Vec<_>>().join("; ")
    };
    format!(
        "{}({}) => {}",
        block.name(),
        part(Role::Input),
        part(Role::Output)
    )
}

fn signature(name: &str) -> String {
    let own = functions().find(|own| own.0 == name);
    match own {
        Some((_, parameters)) => format!("{name}({})", parameters.join(", ")),
        None => format!("{name}(IN)"),
    }
}

/// The values that a type has.
fn range(base: Base, lang: Lang) -> Vec<String> {
    match base.range().filter(|_| base.is_int()) {
        Some((low, high)) => vec![words::from_to(lang, low, high)],
        None => Vec::new(),
    }
}
