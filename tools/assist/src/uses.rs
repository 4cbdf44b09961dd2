//! Where a name comes from, and where it is used.

use crate::meaning::{Meaning, point};
use crate::reader::Reader;
use crate::reading::Reading;
use unoclp_lang::{Colour, Span};
use unoclp_program::Written;

/// A place at which a name is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Use {
    /// The name there.
    pub span: Span,
    /// Whether it is declared there.
    pub declares: bool,
    /// Whether something is stored there.
    pub writes: bool,
}

/// Where the text declares what stands at a byte of it.
pub fn declaration(written: &Written, byte: u32) -> Option<Span> {
    let reading = Reading::of(written)?;
    let reader = reading.reader();
    let span = match reader.meant(reading.byte(byte)?)? {
        Meaning::Declared(at) => reader.named(at).map(|named| named.name),
        Meaning::Point(address) => {
            let named = reader.outline.named.iter();
            let is_at = |span: Span| point(reader.written(span)) == Some(address);
            let mut named = named.filter(|named| named.point.is_some_and(is_at));
            named.next().map(|named| named.name)
        }
        _ => None,
    };
    reading.span(span?)
}

/// Where a name is declared that is known by what it belongs to, as a tree of units shows it: a variable `of` a unit (or a
/// member of a type) by both names; of none, a global variable, a unit or a type. In capitals or not, as the language has it.
///
/// It is the first byte of the name in the file. So whoever has a row of such a tree asks [`uses`] and
/// [`rename`](crate::rename()) by it.
pub fn declared(written: &Written, of: Option<&str>, name: &str) -> Option<u32> {
    let reading = Reading::of(written)?;
    let reader = reading.reader();
    let found = match of {
        Some(of) => {
            let owners = [reader.find(None, of), reader.program(of)];
            let mut owners = owners.into_iter().flatten();
            owners.find_map(|of| reader.find(Some(of), name))
        }
        None => reader.find(None, name).or_else(|| reader.program(name)),
    };
    let named = reader.named(found?)?;
    Some(reading.span(named.name)?.start)
}

/// All places at which what stands at a byte is used, its declaration among them: a name, a member, a point, a block.
pub fn uses(written: &Written, byte: u32) -> Vec<Use> {
    let Some(reading) = Reading::of(written) else {
        return Vec::new();
    };
    let reader = reading.reader();
    let meaning = reading.byte(byte).and_then(|byte| reader.meant(byte));
    let mut uses = meaning.map_or_else(Vec::new, |meaning| reading.uses(&reader, &meaning));
    uses.sort_by_key(|own| own.span.start);
    uses
}

impl Reading {
    /// All places in the file of what has this meaning.
    pub fn uses(&self, reader: &Reader<'_>, meaning: &Meaning) -> Vec<Use> {
        let uses = reader.uses(meaning).into_iter();
        let placed = |own: Use| {
            Some(Use {
                span: self.span(own.span)?,
                ..own
            })
        };
        uses.filter_map(placed).collect()
    }
}

impl Reader<'_> {
    /// All places of what has this meaning, in their order.
    pub fn uses(&self, meaning: &Meaning) -> Vec<Use> {
        if *meaning == Meaning::Word {
            return Vec::new();
        }
        let name = match meaning {
            Meaning::Declared(at) => self
                .named(*at)
                .map(|named| self.fold(self.written(named.name))),
            _ => None,
        };
        let mut all = Vec::new();
        for (at, word) in self.words.iter().enumerate() {
            // Only a word of that name can mean it; the others need not be looked up.
            if let Some(name) = &name
                && !self.may_be(word.text, name)
            {
                continue;
            }
            if let Some((span, ty)) = self.type_in(at)
                && *meaning == Meaning::Declared(ty)
            {
                all.push(Use {
                    span,
                    declares: false,
                    writes: false,
                });
                continue;
            }
            if self.meaning(at).as_ref() != Some(meaning) {
                continue;
            }
            let span = match (word.colour, word.text.rfind('#')) {
                (Some(Colour::Number), Some(sign)) => Span {
                    start: word.span.start + sign as u32 + 1,
                    ..word.span
                },
                _ => word.span,
            };
            all.push(Use {
                span,
                declares: self.declares(meaning, span),
                writes: self.writes(at),
            });
        }
        all
    }

    fn may_be(&self, word: &str, name: &str) -> bool {
        let is =
            |part: &str| (part.len() == name.len() || !name.is_ascii()) && self.fold(part) == name;
        word.split('#').any(is)
    }

    fn declares(&self, meaning: &Meaning, span: Span) -> bool {
        let Meaning::Declared(at) = meaning else {
            return false;
        };
        self.named(*at).is_some_and(|named| named.name == span)
    }

    /// Whether the word at this place is stored in: `:=` follows it outside of parentheses, or it follows a store.
    fn writes(&self, at: usize) -> bool {
        let mut next = at + 1;
        while self.text_of(Some(next)) == "[" {
            let closes = |(end, word): (usize, &crate::reader::Word<'_>)| {
                (word.text == "]" && self.openers[end] == next).then_some(end)
            };
            let rest = self.words.iter().enumerate().skip(next);
            match rest.take(256).find_map(closes) {
                Some(end) => next = end + 1,
                None => return false,
            }
        }
        let before = self.text_of(at.checked_sub(1)).to_ascii_uppercase();
        let is_stored = matches!(
            before.as_str(),
            "ST" | "STN"
                | "S"
                | "R"
                | "OUT"
                | "SET"
                | "RST"
                | "ACIONA"
                | "LIGA"
                | "DESLIGA"
                | "OPERATE"
                | "TURN_ON"
                | "TURN_OFF"
        );
        let is_given = self.openers.get(at) == Some(&crate::reader::NO_OPENER);
        self.text_of(Some(next)) == ":=" && is_given || is_stored
    }
}
