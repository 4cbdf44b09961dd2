//! The keys of a table, each taken as what it shall be; what is none of that is noted with its line.
//!
//! Owns where a value stands, and of what kind it is. Must not know which keys there are.

use crate::duration::duration;
use crate::mistake::{Mistake, Wrong};
use std::cell::RefCell;
use std::net::SocketAddr;
use std::ops::Range;
use std::time::Duration;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The text of a file, and what is wrong with it so far.
pub(crate) struct Notes<'t> {
    text: &'t str,
    mistakes: RefCell<Vec<Mistake>>,
}

impl<'t> Notes<'t> {
    pub fn new(text: &'t str) -> Notes<'t> {
        Notes {
            text,
            mistakes: RefCell::default(),
        }
    }

    /// Something is wrong, at these bytes of the text.
    pub fn wrong(&self, place: &Range<usize>, wrong: Wrong) {
        let before = self.text.bytes().take(place.start);
        let line = before.filter(|&byte| byte == b'\n').count() + 1;
        self.mistakes.borrow_mut().push(Mistake { line, wrong });
    }

    /// All that is wrong, in the order of the lines.
    pub fn mistakes(self) -> Vec<Mistake> {
        let mut mistakes = self.mistakes.into_inner();
        mistakes.sort_by_key(|mistake| mistake.line);
        mistakes
    }
}

/// A value, and where it stands.
#[derive(Clone)]
pub(crate) struct At<T> {
    pub value: T,
    pub place: Range<usize>,
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
    /// A table whose keys are some of these.
    pub fn new(
        table: &'a DeTable<'a>,
        place: Range<usize>,
        notes: &'a Notes<'a>,
        known: &[&str],
    ) -> Keys<'a> {
        for key in table.keys() {
            if !known.contains(&&**key.get_ref()) {
                let known = known.iter().map(|key| format!("`{key}`"));
                let wrong = Wrong::NoKey {
                    key: key.get_ref().to_string(),
                    known: known.collect::<Vec<_>>().join(", "),
                };
                notes.wrong(&key.span(), wrong);
            }
        }
        Keys {
            table,
            place,
            notes,
        }
    }

    /// Whether there is such a key; where.
    pub fn has(&self, key: &str) -> Option<Range<usize>> {
        self.table.get(key).map(Spanned::span)
    }

    /// Whether a key is there and has a table.
    pub fn is_table(&self, key: &str) -> bool {
        let value = self.table.get(key);
        value.is_some_and(|value| value.get_ref().as_table().is_some())
    }

    /// The text of a key, if it is there.
    pub fn text(&self, key: &'static str, example: &'static str) -> Option<At<String>> {
        self.take(key, example, |value| value.as_str().map(str::to_owned))
    }

    /// The text of a key that must be there.
    pub fn needed(&self, key: &'static str, example: &'static str) -> Option<At<String>> {
        if self.has(key).is_none() {
            self.notes
                .wrong(&self.place, Wrong::Missing { key, example });
        }
        self.text(key, example)
    }

    /// Whether a key says so; none where it is missing.
    pub fn flag(&self, key: &'static str) -> Option<At<bool>> {
        self.take(key, "true", |value| value.as_bool())
    }

    /// The number of a key, if it is there.
    pub fn number<N: TryFrom<i64>>(
        &self,
        key: &'static str,
        example: &'static str,
        range: Range<i64>,
    ) -> Option<At<N>> {
        let number = |value: &DeValue<'_>| {
            let number = value.as_integer()?;
            // One that is too long for 64 bits is out of every range.
            Some(i64::from_str_radix(number.as_str(), number.radix()).unwrap_or(i64::MAX))
        };
        let At { value, place } = self.take(key, example, number)?;
        match N::try_from(value) {
            Ok(value_of) if range.contains(&value) => Some(At {
                value: value_of,
                place,
            }),
            _ => {
                let (from, to) = (range.start, range.end - 1);
                self.notes.wrong(&place, Wrong::Range { key, from, to });
                None
            }
        }
    }

    /// The address and port of a key that must be there.
    pub fn address(&self, key: &'static str, example: &'static str) -> Option<At<SocketAddr>> {
        let At { value, place } = self.needed(key, example)?;
        match value.parse() {
            Ok(value) => Some(At { value, place }),
            Err(_) => {
                self.notes.wrong(&place, Wrong::NoAddress { given: value });
                None
            }
        }
    }

    /// The time of a key, if it is there.
    pub fn time(
        &self,
        key: &'static str,
        example: &'static str,
        [from, to]: [&'static str; 2],
    ) -> Option<At<Duration>> {
        let At { value, place } = self.text(key, example)?;
        let within = |time: &Duration| duration(from) <= Some(*time) && Some(*time) <= duration(to);
        match duration(&value).filter(within) {
            Some(value) => Some(At { value, place }),
            None => {
                let wrong = Wrong::NoTime {
                    given: value,
                    from,
                    to,
                };
                self.notes.wrong(&place, wrong);
                None
            }
        }
    }

    /// The texts of a key, none where it is missing.
    pub fn texts(&self, key: &'static str, example: &'static str) -> Vec<At<String>> {
        let Some(value) = self.table.get(key) else {
            return Vec::new();
        };
        let Some(array) = value.get_ref().as_array() else {
            self.notes
                .wrong(&value.span(), Wrong::Kind { key, example });
            return Vec::new();
        };
        let texts = array.iter().filter_map(|value| {
            let place = value.span();
            match value.get_ref().as_str() {
                Some(text) => Some(At {
                    value: text.to_owned(),
                    place,
                }),
                None => {
                    self.notes.wrong(&place, Wrong::Kind { key, example });
                    None
                }
            }
        });
        texts.collect()
    }

    /// The table of a key, if it is there.
    pub fn table(
        &self,
        key: &'static str,
        example: &'static str,
        known: &[&str],
    ) -> Option<Keys<'a>> {
        let value = self.table.get(key)?;
        match value.get_ref().as_table() {
            Some(table) => Some(Keys::new(table, value.span(), self.notes, known)),
            None => {
                self.notes
                    .wrong(&value.span(), Wrong::Kind { key, example });
                None
            }
        }
    }

    /// The tables of a key, none where it is missing; nothing where it is something else, which is told.
    pub fn tables(
        &self,
        key: &'static str,
        example: &'static str,
        known: &[&str],
    ) -> Option<Vec<Keys<'a>>> {
        let Some(value) = self.table.get(key) else {
            return Some(Vec::new());
        };
        let array = value.get_ref().as_array();
        let tables = array.and_then(|array| {
            let table = |value: &'a Spanned<DeValue<'a>>| {
                let table = value.get_ref().as_table()?;
                Some(Keys::new(table, value.span(), self.notes, known))
            };
            array.iter().map(table).collect()
        });
        if tables.is_none() {
            self.notes
                .wrong(&value.span(), Wrong::Kind { key, example });
        }
        tables
    }

    fn take<T>(
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
