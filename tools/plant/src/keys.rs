//! The keys of a table, each taken as what it shall be; what is none of that is noted with its line.
//!
//! Owns where a value stands, and of what kind it is. Must not know which keys there are.

use crate::mistake::{Mistake, Wrong};
use crate::text::Text;
use crate::unit::Unit;
use std::cell::RefCell;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value, and where it stands.
#[derive(Clone, Debug)]
pub(crate) struct At<T> {
    pub value: T,
    pub place: Range<usize>,
}

/// The text of a file, and what is wrong with it so far.
pub(crate) struct Notes<'t> {
    /// The byte at which each line begins.
    lines: Vec<usize>,
    pub text: &'t str,
    mistakes: RefCell<Vec<Mistake>>,
}

/// More mistakes than these are not told.
const MOST: usize = 100;

impl<'t> Notes<'t> {
    pub fn new(text: &'t str) -> Notes<'t> {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Notes {
            lines: std::iter::once(0)
                .chain(ends.map(|(at, _)| at + 1))
                .collect(),
            text,
            mistakes: RefCell::default(),
        }
    }

    /// Something is wrong, at these bytes of the text.
    pub fn wrong(&self, place: &Range<usize>, wrong: Wrong) {
        let line = self
            .lines
            .partition_point(|start| *start <= place.start)
            .max(1);
        let mut mistakes = self.mistakes.borrow_mut();
        if mistakes.len() < MOST {
            mistakes.push(Mistake { line, wrong });
        }
    }

    pub fn is_right(&self) -> bool {
        self.mistakes.borrow().is_empty()
    }

    /// All that is wrong, in the order of the lines.
    pub fn mistakes(self) -> Vec<Mistake> {
        let mut mistakes = self.mistakes.into_inner();
        mistakes.sort_by_key(|mistake| mistake.line);
        mistakes
    }
}

/// A table of the file.
#[derive(Clone)]
pub(crate) struct Keys<'a> {
    table: &'a DeTable<'a>,
    /// Where it begins.
    pub place: Range<usize>,
    pub notes: &'a Notes<'a>,
}

impl<'a> Keys<'a> {
    pub fn new(table: &'a DeTable<'a>, place: Range<usize>, notes: &'a Notes<'a>) -> Keys<'a> {
        Keys {
            table,
            place,
            notes,
        }
    }

    /// Its keys are some of these; others are told.
    pub fn known(&self, known: &[&str]) {
        for key in self.table.keys() {
            if !known.contains(&&**key.get_ref()) {
                let known = known.iter().map(|key| format!("`{key}`"));
                let wrong = Wrong::NoKey {
                    key: key.get_ref().to_string(),
                    known: known.collect::<Vec<_>>().join(", "),
                };
                self.notes.wrong(&key.span(), wrong);
            }
        }
    }

    /// Each key with its value.
    pub fn each(&self) -> impl Iterator<Item = (At<String>, &'a Spanned<DeValue<'a>>)> + use<'a> {
        self.table.iter().map(|(key, value)| {
            let at = At {
                value: key.get_ref().to_string(),
                place: key.span(),
            };
            (at, value)
        })
    }

    /// Whether there is such a key.
    pub fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// The value of a key.
    pub fn value(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.table.get(key)
    }

    /// A key that must be there is not.
    pub fn missing(&self, key: &'static str, example: &'static str) {
        self.notes
            .wrong(&self.place, Wrong::Missing { key, example });
    }

    /// The text of a key, if it is there.
    pub fn text(&self, key: &'static str, example: &'static str) -> Option<At<String>> {
        self.take(key, example, |value| value.as_str().map(str::to_owned))
    }

    /// The text of a key that must be there.
    pub fn needed(&self, key: &'static str, example: &'static str) -> Option<At<String>> {
        if !self.has(key) {
            self.missing(key, example);
        }
        self.text(key, example)
    }

    /// A text in one or both languages, if it is there.
    pub fn both(&self, key: &'static str) -> Option<At<Text>> {
        let example = "{ en = \"Pump\", pt = \"Bomba\" }";
        self.take(key, example, |value| {
            if let Some(text) = value.as_str() {
                return Some(Text::same(text));
            }
            let table = value.as_table()?;
            let of = |key| match table.get(key) {
                Some(text) => text.get_ref().as_str().map(|text| Some(text.to_owned())),
                None => Some(None),
            };
            let (en, pt) = (of("en")?, of("pt")?);
            let count = usize::from(en.is_some()) + usize::from(pt.is_some());
            let either = en.clone().or(pt.clone())?;
            (table.len() == count).then(|| Text {
                en: en.unwrap_or_else(|| either.clone()),
                pt: pt.unwrap_or(either),
            })
        })
    }

    /// A whole number of a key, if it is there.
    pub fn whole(&self, key: &'static str, from: i64, to: i64) -> Option<At<i64>> {
        let at = self.take(key, "1", whole)?;
        match (from..=to).contains(&at.value) {
            true => Some(at),
            false => {
                let (from, to) = (from.to_string(), to.to_string());
                let key = key.to_owned();
                self.notes.wrong(&at.place, Wrong::Range { key, from, to });
                None
            }
        }
    }

    /// A time of a key in ms, if it is there.
    pub fn time(&self, key: &'static str, from: i64, to: i64) -> Option<At<u64>> {
        let value = self.value(key)?;
        let number = quantity(self.notes, key, value, Unit::Ms, from, to)?;
        Some(At {
            value: u64::try_from(number).unwrap_or(0),
            place: value.span(),
        })
    }

    /// Two whole numbers, if the key is there.
    pub fn place_of(&self, key: &'static str) -> Option<At<[i32; 2]>> {
        self.take(key, "[40, 20]", pair)
    }

    /// The tables of a key, none where it is missing.
    pub fn tables(&self, key: &'static str, example: &'static str) -> Vec<Keys<'a>> {
        let Some(value) = self.table.get(key) else {
            return Vec::new();
        };
        let array = value.get_ref().as_array();
        let tables = array.and_then(|array| {
            let table = |value: &'a Spanned<DeValue<'a>>| {
                let table = value.get_ref().as_table()?;
                Some(Keys::new(table, value.span(), self.notes))
            };
            array.iter().map(table).collect()
        });
        tables.unwrap_or_else(|| {
            self.notes
                .wrong(&value.span(), Wrong::Kind { key, example });
            Vec::new()
        })
    }

    /// The table of a key, if it is there.
    pub fn table(&self, key: &'static str, example: &'static str) -> Option<Keys<'a>> {
        let value = self.table.get(key)?;
        match value.get_ref().as_table() {
            Some(table) => Some(Keys::new(table, value.span(), self.notes)),
            None => {
                self.notes
                    .wrong(&value.span(), Wrong::Kind { key, example });
                None
            }
        }
    }

    pub fn take<T>(
        &self,
        key: &'static str,
        example: &'static str,
        take: impl FnOnce(&DeValue<'_>) -> Option<T>,
    ) -> Option<At<T>> {
        let value = self.table.get(key)?;
        let place = value.span();
        match take(value.get_ref()) {
            Some(value) => Some(At { value, place }),
            None => {
                self.notes.wrong(&place, Wrong::Kind { key, example });
                None
            }
        }
    }
}

/// A whole number, or 0 and 1 as false and true.
pub(crate) fn whole(value: &DeValue<'_>) -> Option<i64> {
    if let Some(truth) = value.as_bool() {
        return Some(truth.into());
    }
    let number = value.as_integer()?;
    // One that is too long for 64 bits is out of every range.
    Some(i64::from_str_radix(number.as_str(), number.radix()).unwrap_or(i64::MAX))
}

/// Where something stands on the drawing.
pub(crate) fn pair(value: &DeValue<'_>) -> Option<[i32; 2]> {
    let array = value.as_array()?;
    let number = |at: usize| {
        let number = whole(array.get(at)?.get_ref())?;
        i32::try_from(number)
            .ok()
            .filter(|number| (0..=4000).contains(number))
    };
    (array.len() == 2).then_some([number(0)?, number(1)?])
}

/// A quantity from one number to another; what is wrong is told.
pub(crate) fn quantity(
    notes: &Notes<'_>,
    key: &str,
    value: &Spanned<DeValue<'_>>,
    unit: Unit,
    from: i64,
    to: i64,
) -> Option<i32> {
    let number = match (unit, value.get_ref()) {
        (Unit::Count, value) => whole(value),
        (_, value) => value.as_str().and_then(|text| unit.read(text)),
    };
    let (from_shown, to_shown) = (unit.shown(from), unit.shown(to));
    let Some(number) = number else {
        let given = notes.text.get(value.span()).unwrap_or_default();
        let given: String = given.chars().take(40).collect();
        let (key, known) = (key.to_owned(), unit.known());
        let wrong = match unit {
            Unit::Count => Wrong::NoNumber { key, given },
            _ => Wrong::NoUnit {
                key,
                given,
                known,
                example: to_shown,
            },
        };
        notes.wrong(&value.span(), wrong);
        return None;
    };
    if !(from..=to).contains(&number) {
        let wrong = Wrong::Range {
            key: key.to_owned(),
            from: from_shown,
            to: to_shown,
        };
        notes.wrong(&value.span(), wrong);
        return None;
    }
    i32::try_from(number).ok()
}
