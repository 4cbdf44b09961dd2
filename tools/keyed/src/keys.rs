//! The keys of a table.

use crate::mistake::Amiss;
use crate::notes::Notes;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value, and where it stands.
#[derive(Clone, Debug)]
pub struct At<T> {
    /// The value.
    pub value: T,
    /// Its bytes in the text.
    pub place: Range<usize>,
}

/// A table of the file, whose mistakes are of the type `W`.
#[derive(Debug)]
pub struct Keys<'a, W> {
    table: &'a DeTable<'a>,
    /// Where it begins.
    pub place: Range<usize>,
    /// What is wrong with the file.
    pub notes: &'a Notes<'a, W>,
}

impl<W> Clone for Keys<'_, W> {
    fn clone(&self) -> Self {
        Keys {
            place: self.place.clone(),
            ..*self
        }
    }
}

impl<'a, W: From<Amiss>> Keys<'a, W> {
    pub(crate) fn new(
        table: &'a DeTable<'a>,
        place: Range<usize>,
        notes: &'a Notes<'a, W>,
    ) -> Keys<'a, W> {
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
                let amiss = Amiss::NoKey {
                    key: key.get_ref().to_string(),
                    known: known.collect::<Vec<_>>().join(", "),
                };
                self.notes.wrong(&key.span(), amiss);
            }
        }
    }

    /// Each key with its value.
    pub fn each(
        &self,
    ) -> impl Iterator<Item = (At<String>, &'a Spanned<DeValue<'a>>)> + use<'a, W> {
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

    /// Where the value of a key stands, if it is there.
    pub fn at(&self, key: &str) -> Option<Range<usize>> {
        self.table.get(key).map(Spanned::span)
    }

    /// The value of a key.
    pub fn value(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.table.get(key)
    }

    /// Whether a key is there and has a table.
    pub fn is_table(&self, key: &str) -> bool {
        let value = self.table.get(key);
        value.is_some_and(|value| value.get_ref().as_table().is_some())
    }

    /// A key that must be there is not.
    pub fn missing(&self, key: &'static str, example: &'static str) {
        self.notes
            .wrong(&self.place, Amiss::Missing { key, example });
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

    /// Whether a key says so; none where it is missing.
    pub fn flag(&self, key: &'static str) -> Option<At<bool>> {
        self.take(key, "true", |value| value.as_bool())
    }

    /// The texts of a key, none where it is missing.
    pub fn texts(&self, key: &'static str, example: &'static str) -> Vec<At<String>> {
        let Some(value) = self.table.get(key) else {
            return Vec::new();
        };
        let Some(array) = value.get_ref().as_array() else {
            self.other_kind(&value.span(), key, example);
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
                    self.other_kind(&place, key, example);
                    None
                }
            }
        });
        texts.collect()
    }

    /// The table of a key, if it is there.
    pub fn table(&self, key: &'static str, example: &'static str) -> Option<Keys<'a, W>> {
        let value = self.table.get(key)?;
        let table = self.below(value);
        if table.is_none() {
            self.other_kind(&value.span(), key, example);
        }
        table
    }

    /// The tables of a key, none where it is missing; nothing where it is something else, which is told.
    pub fn tables(&self, key: &'static str, example: &'static str) -> Option<Vec<Keys<'a, W>>> {
        let Some(value) = self.table.get(key) else {
            return Some(Vec::new());
        };
        let array = value.get_ref().as_array();
        let tables = array.and_then(|array| array.iter().map(|value| self.below(value)).collect());
        if tables.is_none() {
            self.other_kind(&value.span(), key, example);
        }
        tables
    }

    /// What `take` makes of the value of a key; nothing where it makes nothing of it, which is told.
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
                self.other_kind(&place, key, example);
                None
            }
        }
    }

    fn below(&self, value: &'a Spanned<DeValue<'a>>) -> Option<Keys<'a, W>> {
        let table = value.get_ref().as_table()?;
        Some(Keys::new(table, value.span(), self.notes))
    }

    fn other_kind(&self, place: &Range<usize>, key: &'static str, example: &'static str) {
        self.notes.wrong(place, Amiss::Kind { key, example });
    }
}

/// A whole number; one that is too long for 64 bits is out of every range.
pub fn whole(value: &DeValue<'_>) -> Option<i64> {
    let number = value.as_integer()?;
    Some(i64::from_str_radix(number.as_str(), number.radix()).unwrap_or(i64::MAX))
}
