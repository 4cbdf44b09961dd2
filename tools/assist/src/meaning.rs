//! What a word of a text stands for.

use crate::reader::Reader;
use unoclp_lang::outline::What;
use unoclp_lang::typed::{Base, Standard, functions, is_function};
use unoclp_lang::{Colour, Span};
use unoclp_point::{Address, Maker, read};

/// What a word stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Meaning {
    /// What the text declares, by its place in the outline.
    Declared(usize),
    /// An input or output of a block of the standard.
    Pin(Standard, &'static str),
    /// A parameter of a standard function.
    Parameter(&'static str, &'static str),
    /// A block of the standard.
    Standard(Standard),
    /// A standard function, by its name in capitals.
    Function(String),
    /// An elementary type.
    Base(Base),
    /// A point of the board.
    Point(Address),
    /// A word of the language.
    Word,
}

/// How many members may follow one another: no text has half as many.
const LONGEST_CHAIN: usize = 64;

impl Reader<'_> {
    /// What stands at a byte of the text; none where nothing known does.
    pub fn meant(&self, byte: u32) -> Option<Meaning> {
        let at = self.word_at(byte)?;
        let of_type = self.type_in(at).filter(|(span, _)| byte <= span.end);
        let of_type = of_type.map(|(_, ty)| Meaning::Declared(ty));
        of_type.or_else(|| self.meaning(at))
    }

    /// The type that a literal names, `Color#Red`, and where.
    pub fn type_in(&self, at: usize) -> Option<(Span, usize)> {
        let word = self.words.get(at)?;
        let (ty, _) = word.text.split_once('#')?;
        let is_literal = word.colour == Some(Colour::Number);
        let found = self.find(None, ty).filter(|_| is_literal)?;
        let start = word.span.start;
        let end = start + ty.len() as u32;
        Some((Span { start, end }, found))
    }

    /// What the word at this place stands for; none of what is not known.
    pub fn meaning(&self, at: usize) -> Option<Meaning> {
        let word = self.words.get(at)?;
        match word.colour {
            Some(Colour::Point) => return point(word.text).map(Meaning::Point),
            Some(Colour::Number) => return self.of_literal(word.text),
            Some(Colour::Word) => {
                let upper = word.text.to_ascii_uppercase();
                let standard = || Standard::named(&upper).map(Meaning::Standard);
                let base = || Base::named(&upper).map(Meaning::Base);
                return standard().or_else(base).or(Some(Meaning::Word));
            }
            _ if !word.is_name() => return None,
            _ => {}
        }
        if let Some(declared) = self.declared_at(word.span) {
            return Some(Meaning::Declared(declared));
        }
        if self.text_of(at.checked_sub(1)) == "." {
            let owner = self.owner(at)?;
            return self.member(&owner, word.text);
        }
        let pin = self.pin(at);
        pin.or_else(|| self.name(word.text, word.span.start))
    }

    /// What is declared there: its place tells it from others of its name.
    fn declared_at(&self, span: Span) -> Option<usize> {
        let all = &self.outline.named;
        let at = all.binary_search_by_key(&span.start, |named| named.name.start);
        let at = at.ok()?;
        let name = self.written(span);
        match all[at].what {
            What::Program => self.program(name),
            What::Member | What::Value => Some(at),
            _ => self.beyond(self.find(all[at].within, name)?),
        }
    }

    /// What a name means that begins at a byte of the text.
    pub fn name(&self, name: &str, byte: u32) -> Option<Meaning> {
        let program = || self.program(name).map(Meaning::Declared);
        if self.programs.contains(&byte)
            && let Some(program) = program()
        {
            return Some(program);
        }
        let unit = self.unit_at(byte);
        let unit = unit.filter(|_| !self.types.contains(&byte));
        let own = unit.and_then(|unit| self.find(Some(unit), name));
        let own = own.and_then(|own| self.beyond(own));
        let global = || self.find(None, name);
        let declared = own.or_else(global).or_else(|| self.value(name));
        if let Some(declared) = declared {
            return Some(Meaning::Declared(declared));
        }
        let upper = name.to_ascii_uppercase();
        let standard = Standard::named(&upper).or_else(|| Standard::overloaded(&upper));
        if let Some(standard) = standard {
            return Some(Meaning::Standard(standard));
        }
        let function = is_function(&upper).then_some(Meaning::Function(upper));
        function.or_else(program)
    }

    /// What VAR_EXTERNAL names, where it is declared; any other is itself.
    fn beyond(&self, own: usize) -> Option<usize> {
        let named = self.named(own)?;
        let section = named.section.map(|section| self.written(section));
        let is_external = section.is_some_and(|word| word.eq_ignore_ascii_case("VAR_EXTERNAL"));
        match is_external {
            true => self.find(None, self.written(named.name)).or(Some(own)),
            false => Some(own),
        }
    }

    /// What the name before a point stands for: of `a.b[1].c` at `c` that is `b`.
    pub fn owner(&self, member: usize) -> Option<Meaning> {
        let mut chain = Vec::new();
        let mut at = member;
        while self.text_of(at.checked_sub(1)) == "." {
            let mut before = at.checked_sub(2)?;
            while matches!(self.words[before].text, "]" | ")") {
                before = self.opened_by(before)?.checked_sub(1)?;
            }
            chain.push(before);
            at = before;
            if chain.len() > LONGEST_CHAIN {
                return None;
            }
        }
        let first = *chain.last()?;
        let word = self.words.get(first)?;
        let mut meaning = self.name(word.text, word.span.start)?;
        for &next in chain.iter().rev().skip(1) {
            meaning = self.member(&meaning, self.words[next].text)?;
        }
        Some(meaning)
    }

    /// What a bracket closes.
    fn opened_by(&self, closer: usize) -> Option<usize> {
        let opener = *self.openers.get(closer)?;
        let pair = (self.text_of(Some(opener)), self.text_of(Some(closer)));
        matches!(pair, ("(", ")") | ("[", "]")).then_some(opener)
    }

    /// A member of what this stands for.
    pub fn member(&self, of: &Meaning, name: &str) -> Option<Meaning> {
        match self.type_of(of)? {
            Meaning::Standard(standard) => {
                let (_, part) = standard.part(&name.to_ascii_uppercase())?;
                Some(Meaning::Pin(standard, part.0))
            }
            Meaning::Declared(owner) => {
                let found = self.find(Some(owner), name)?;
                Some(Meaning::Declared(found))
            }
            _ => None,
        }
    }

    /// The type of what has one: a block of the standard, one of the text, a type of the text, an elementary type.
    pub fn type_of(&self, of: &Meaning) -> Option<Meaning> {
        let named = match of {
            Meaning::Standard(_) | Meaning::Base(_) => return Some(of.clone()),
            Meaning::Declared(at) => self.named(*at)?,
            Meaning::Pin(standard, pin) => {
                return standard.part(pin).map(|(_, part)| Meaning::Base(part.1));
            }
            _ => return None,
        };
        match named.what {
            What::Block | What::Type => match (named.what, named.ty) {
                // Another name of a type.
                (What::Type, Some(ty)) if self.parts_of(of).is_none() => self.type_named(ty),
                _ => Some(of.clone()),
            },
            What::Step => None,
            _ => self.type_named(named.ty?),
        }
    }

    fn parts_of(&self, of: &Meaning) -> Option<usize> {
        let Meaning::Declared(at) = of else {
            return None;
        };
        self.parts(*at).next()
    }

    /// The last word of a type: `ARRAY[1..3] OF Motor` is one of Motor.
    fn type_named(&self, ty: unoclp_lang::Span) -> Option<Meaning> {
        let written = self.written(ty);
        let last = written.rsplit(|c: char| !c.is_alphanumeric() && c != '_');
        let last = last.into_iter().find(|word| !word.is_empty())?;
        // `STRING[10]`, `INT(0..5)`: its type stands first.
        let begins = |c: char| c.is_alphabetic() || c == '_';
        let name = match last.starts_with(begins) {
            true => last,
            false => written
                .split(|c: char| !c.is_alphanumeric() && c != '_')
                .next()?,
        };
        let upper = name.to_ascii_uppercase();
        let declared = || self.find(None, name).map(Meaning::Declared);
        let standard = || Standard::named(&upper).or_else(|| Standard::overloaded(&upper));
        let base = || Base::named(&upper).map(Meaning::Base);
        declared()
            .or_else(|| standard().map(Meaning::Standard))
            .or_else(base)
    }

    /// What is called by the parentheses in which a word stands.
    pub fn called(&self, at: usize) -> Option<Meaning> {
        let opener = self.opener(at)?;
        if self.words[opener].text != "(" {
            return None;
        }
        let mut callee = opener.checked_sub(1)?;
        if self.words[callee].text == "]" {
            callee = self.opened_by(callee)?.checked_sub(1)?;
        }
        let word = self.words[callee];
        match word.colour {
            None if word.is_name() && self.text_of(callee.checked_sub(1)) == "." => {
                self.meaning(callee)
            }
            None if word.is_name() => self.name(word.text, word.span.start),
            Some(Colour::Word) => {
                let upper = word.text.to_ascii_uppercase();
                is_function(&upper).then_some(Meaning::Function(upper))
            }
            _ => None,
        }
    }

    /// A parameter of a call, or a member of a first value, by its name.
    fn pin(&self, at: usize) -> Option<Meaning> {
        let before = self.text_of(at.checked_sub(1));
        if !matches!(self.text_of(Some(at + 1)), ":=" | "=>") || !matches!(before, "(" | ",") {
            return None;
        }
        let name = self.words[at].text;
        match self.called(at) {
            Some(Meaning::Function(function)) => parameter(&function, name),
            Some(Meaning::Declared(unit)) if self.named(unit)?.what == What::Function => {
                self.find(Some(unit), name).map(Meaning::Declared)
            }
            Some(callee) => self.member(&callee, name),
            None => {
                let byte = self.words[at].span.start;
                let holds = |span: unoclp_lang::Span| span.start <= byte && byte < span.end;
                let mut all = self.outline.named.iter();
                let begun = all.find(|named| named.first.is_some_and(holds))?;
                let ty = self.type_named(begun.ty?)?;
                self.member(&ty, name)
            }
        }
    }

    /// `Color#Red`; a number stands for itself.
    fn of_literal(&self, text: &str) -> Option<Meaning> {
        let (ty, value) = text.split_once('#')?;
        let ty = self.find(None, ty)?;
        self.find(Some(ty), value).map(Meaning::Declared)
    }
}

fn parameter(function: &str, name: &str) -> Option<Meaning> {
    let (function, parameters) = functions().find(|own| own.0 == function)?;
    let mut parameters = parameters.iter();
    let parameter = parameters.find(|own| own.eq_ignore_ascii_case(name))?;
    Some(Meaning::Parameter(function, parameter))
}

/// A point as a text of the standard writes it.
pub(crate) fn point(written: &str) -> Option<Address> {
    let plain: String = written.chars().filter(|c| !c.is_whitespace()).collect();
    read(&plain.to_ascii_uppercase(), Maker::Iec)?.address
}
