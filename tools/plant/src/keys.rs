//! The keys of a plant's file: what only it has, texts in two languages, times, places and quantities with units.
//!
//! Owns what such a value is. Must not know which keys there are.

use crate::mistake::Wrong;
use crate::text::Text;
use crate::unit::Unit;
use unoclp_keyed::{DeValue, Spanned};

pub(crate) use unoclp_keyed::{Amiss, At};

/// A table of a plant's file.
pub(crate) type Keys<'a> = unoclp_keyed::Keys<'a, Wrong>;
/// What is wrong with the file so far.
pub(crate) type Notes<'t> = unoclp_keyed::Notes<'t, Wrong>;

/// A text in one or both languages, if it is there.
pub(crate) fn both(keys: &Keys<'_>, key: &'static str) -> Option<At<Text>> {
    let example = "{ en = \"Pump\", pt = \"Bomba\" }";
    keys.take(key, example, |value| {
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
pub(crate) fn number(keys: &Keys<'_>, key: &'static str, from: i64, to: i64) -> Option<At<i64>> {
    let at = keys.take(key, "1", whole)?;
    match (from..=to).contains(&at.value) {
        true => Some(at),
        false => {
            let (from, to) = (from.to_string(), to.to_string());
            let key = key.to_owned();
            keys.notes.wrong(&at.place, Wrong::Range { key, from, to });
            None
        }
    }
}

/// A time of a key in ms, if it is there.
pub(crate) fn time(keys: &Keys<'_>, key: &'static str, from: i64, to: i64) -> Option<At<u64>> {
    let value = keys.value(key)?;
    let number = quantity(keys.notes, key, value, Unit::Ms, from, to)?;
    Some(At {
        value: u64::try_from(number).unwrap_or(0),
        place: value.span(),
    })
}

/// Two whole numbers, if the key is there.
pub(crate) fn place_of(keys: &Keys<'_>, key: &'static str) -> Option<At<[i32; 2]>> {
    keys.take(key, "[40, 20]", pair)
}

/// A whole number, or 0 and 1 as false and true.
pub(crate) fn whole(value: &DeValue<'_>) -> Option<i64> {
    if let Some(truth) = value.as_bool() {
        return Some(truth.into());
    }
    unoclp_keyed::whole(value)
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
