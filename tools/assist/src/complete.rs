//! What may stand at a place of a text.

use crate::meaning::Meaning;
use crate::reader::Reader;
use crate::{language, words};
use std::collections::HashSet;
use unoclp_lang::outline::{Named, What};
use unoclp_lang::typed::{Base, Role, Standard, functions};
use unoclp_lang::{Colour, Lang, Span};
use unoclp_program::Written;

/// What an offer is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A variable.
    Variable,
    /// A member of a structure, an input or an output.
    Member,
    /// A function or a function block.
    Function,
    /// A type.
    Type,
    /// A value of an enumeration.
    Value,
    /// A step, a transition or an action of a chart; a label.
    Place,
    /// A word of the language.
    Word,
}

/// Something that may stand there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Offer {
    /// What stands in the list.
    pub label: String,
    /// What it is.
    pub kind: Kind,
    /// Its type, or what it takes.
    pub detail: String,
    /// What is written, where that is more than the label.
    pub insert: Option<String>,
}

/// What may stand at a byte of a text, and what of the text it replaces: the beginning of a word, or nothing. The offers
/// that begin with that word are all there; whoever shows them may choose among them.
pub fn complete(written: &Written, byte: u32, lang: Lang) -> (Span, Vec<Offer>) {
    let nothing = Span {
        start: byte,
        end: byte,
    };
    let Some(language) = language(written) else {
        return (nothing, Vec::new());
    };
    let text = written.text();
    let reader = Reader::new(&text, language);
    let Some(place) = Place::at(&reader, byte) else {
        return (nothing, Vec::new());
    };
    let all = Offers {
        reader: &reader,
        byte,
        lang,
        all: Vec::new(),
        seen: HashSet::new(),
    };
    let begun = reader.text.get(place.span.range()).unwrap_or_default();
    let begun = begun.to_uppercase();
    let mut offers = all.of(&place);
    offers.retain(|offer| offer.label.to_uppercase().starts_with(&begun));
    (place.span, offers)
}

/// Where one writes.
struct Place {
    /// What has been written of the word.
    span: Span,
    /// The word before which, or in whose place, one writes.
    at: usize,
}

impl Place {
    /// None within a comment, a text or a number.
    fn at(reader: &Reader<'_>, byte: u32) -> Option<Place> {
        let after = reader.words.partition_point(|word| word.span.start < byte);
        let touched = after.checked_sub(1).map(|at| (at, reader.words[at]));
        if let Some((at, word)) = touched.filter(|(_, word)| byte <= word.span.end) {
            let is_word = word.is_name() || word.colour == Some(Colour::Word);
            match word.colour {
                _ if is_word => {
                    let span = Span {
                        start: word.span.start,
                        end: byte,
                    };
                    return Some(Place { span, at });
                }
                Some(Colour::Number | Colour::Text | Colour::Comment | Colour::Point) => {
                    return None;
                }
                _ => {}
            }
        }
        let begins = after
            .checked_sub(1)
            .map_or(0, |at| reader.words[at].span.end);
        let gap = reader.text.get(begins as usize..byte as usize)?;
        let line = gap.rsplit('\n').next().unwrap_or_default();
        // What lies between two words is a comment, or blank.
        let is_open = gap.rfind("(*") > gap.rfind("*)") || gap.rfind("/*") > gap.rfind("*/");
        if is_open || line.contains("//") {
            return None;
        }
        let span = Span {
            start: byte,
            end: byte,
        };
        Some(Place { span, at: after })
    }
}

struct Offers<'r, 't> {
    reader: &'r Reader<'t>,
    byte: u32,
    lang: Lang,
    all: Vec<Offer>,
    seen: HashSet<String>,
}

impl Offers<'_, '_> {
    fn of(mut self, place: &Place) -> Vec<Offer> {
        let before = self.reader.text_of(place.at.checked_sub(1));
        if before == "." {
            self.members(place.at);
            return self.all;
        }
        if before == ":" && self.declares(place) || before.eq_ignore_ascii_case("OF") {
            self.types();
            return self.all;
        }
        if matches!(before, "(" | ",") {
            self.pins(place.at);
        }
        self.names();
        self.standard();
        self.words();
        self.all
    }

    /// Whether what is written there is a type: a colon in a section of variables or types.
    fn declares(&self, place: &Place) -> bool {
        let words = &self.reader.words[..place.at.min(self.reader.words.len())];
        let border = words.iter().rev().find(|word| {
            let upper = word.text.to_ascii_uppercase();
            word.colour == Some(Colour::Word)
                && (upper.starts_with("VAR")
                    || upper.starts_with("END_")
                    || upper == "TYPE"
                    || upper == "STRUCT")
        });
        border.is_some_and(|word| !word.text.to_ascii_uppercase().starts_with("END_"))
    }

    fn offer(&mut self, label: &str, kind: Kind, detail: String) {
        if self.seen.insert(self.reader.fold(label)) {
            self.all.push(Offer {
                label: label.to_owned(),
                kind,
                detail,
                insert: None,
            });
        }
    }

    fn members(&mut self, at: usize) {
        let Some(owner) = self.reader.owner(at) else {
            return;
        };
        if let Meaning::Declared(of) = owner
            && self
                .reader
                .named(of)
                .is_some_and(|named| named.what == What::Step)
        {
            self.offer("X", Kind::Member, "BOOL".to_owned());
            self.offer("T", Kind::Member, "TIME".to_owned());
            return;
        }
        match self.reader.type_of(&owner) {
            Some(Meaning::Standard(standard)) => {
                for (name, base, role) in standard.parts() {
                    if *role != Role::Hidden {
                        self.offer(name, Kind::Member, base.name().to_owned());
                    }
                }
            }
            Some(Meaning::Declared(of)) => {
                self.parts(of, &["VAR_INPUT", "VAR_OUTPUT", "VAR_IN_OUT", ""])
            }
            _ => {}
        }
    }

    /// The parts of a unit or type that stand in one of these sections.
    fn parts(&mut self, of: usize, sections: &[&str]) {
        let reader = self.reader;
        for at in reader.parts(of) {
            let Some(named) = reader.named(at) else {
                continue;
            };
            let section = named.section.map_or("", |section| reader.written(section));
            if sections.iter().any(|own| own.eq_ignore_ascii_case(section)) {
                let ty = named.ty.map_or("", |ty| reader.written(ty));
                self.offer(reader.written(named.name), Kind::Member, ty.to_owned());
            }
        }
    }

    /// What the call takes in whose parentheses one writes.
    fn pins(&mut self, at: usize) {
        let Some(callee) = self.reader.called(at) else {
            return;
        };
        let from = self.all.len();
        match (&callee, self.reader.type_of(&callee)) {
            (Meaning::Function(function), _) => {
                let own = functions().find(|own| own.0 == function);
                for name in own.map_or(&[][..], |own| own.1) {
                    self.offer(name, Kind::Member, String::new());
                }
            }
            (Meaning::Declared(of), None) => self.parts(*of, &["VAR_INPUT", "VAR_IN_OUT"]),
            (_, Some(Meaning::Standard(standard))) => {
                for (name, base, role) in standard.parts() {
                    if *role == Role::Input {
                        self.offer(name, Kind::Member, base.name().to_owned());
                    }
                }
            }
            (_, Some(Meaning::Declared(of))) => self.parts(of, &["VAR_INPUT", "VAR_IN_OUT"]),
            _ => {}
        }
        for offer in &mut self.all[from..] {
            offer.insert = Some(format!("{} := ", offer.label));
        }
    }

    fn types(&mut self) {
        let reader = self.reader;
        for named in &reader.outline.named {
            if matches!(named.what, What::Type | What::Block) {
                self.offer(reader.written(named.name), Kind::Type, String::new());
            }
        }
        for base in Base::ALL {
            // Those of numbers in a text are none that one can write.
            if !base.name().starts_with("ANY") {
                self.offer(base.name(), Kind::Type, String::new());
            }
        }
        for standard in Standard::ALL {
            let about = words::block(standard, self.lang);
            self.offer(standard.name(), Kind::Type, about);
        }
        for word in ["ARRAY", "STRUCT"] {
            if reader.language.vocabulary().contains(&word) {
                self.offer(word, Kind::Word, String::new());
            }
        }
    }

    fn names(&mut self) {
        let reader = self.reader;
        let unit = reader.unit_at(self.byte);
        let is_seen = |named: &&Named| {
            named.within.is_none() || named.within == unit || named.what == What::Value
        };
        let named: Vec<Named> = reader
            .outline
            .named
            .iter()
            .filter(is_seen)
            .copied()
            .collect();
        for named in named {
            let kind = match named.what {
                What::Program => continue,
                What::Variable => Kind::Variable,
                What::Block => continue,
                What::Function => Kind::Function,
                What::Type => Kind::Type,
                What::Member => continue,
                What::Value => Kind::Value,
                What::Step | What::Transition | What::Action | What::Label => Kind::Place,
            };
            let mut detail = named.ty.map_or("", |ty| reader.written(ty)).to_owned();
            if let Some(point) = named.point {
                detail = format!("{detail} {}", reader.written(point))
                    .trim()
                    .to_owned();
            }
            self.offer(reader.written(named.name), kind, detail);
        }
    }

    fn standard(&mut self) {
        // Only Structured Text calls functions of the standard by their names; other languages that have some say so themselves.
        if !self.reader.language.vocabulary().contains(&"FUNCTION") {
            return;
        }
        for (name, parameters) in functions() {
            self.offer(name, Kind::Function, format!("({})", parameters.join(", ")));
        }
    }

    fn words(&mut self) {
        for word in self.reader.language.vocabulary() {
            if !word.is_empty() {
                self.offer(word, Kind::Word, String::new());
            }
        }
    }
}
