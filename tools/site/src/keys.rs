//! The keys of a site file: what only it has, addresses, times and numbers within a range.
//!
//! Owns what such a value is. Must not know which keys there are.

use crate::duration::duration;
use crate::mistake::Wrong;
use std::net::SocketAddr;
use std::ops::Range;
use std::time::Duration;
use unoclp_keyed::whole;

pub(crate) use unoclp_keyed::{Amiss, At};

/// A table of a site file.
pub(crate) type Keys<'a> = unoclp_keyed::Keys<'a, Wrong>;

/// The number of a key, if it is there.
pub(crate) fn number<N: TryFrom<i64>>(
    keys: &Keys<'_>,
    key: &'static str,
    example: &'static str,
    range: Range<i64>,
) -> Option<At<N>> {
    let At { value, place } = keys.take(key, example, whole)?;
    match N::try_from(value) {
        Ok(value_of) if range.contains(&value) => Some(At {
            value: value_of,
            place,
        }),
        _ => {
            let (from, to) = (range.start, range.end - 1);
            keys.notes.wrong(&place, Wrong::Range { key, from, to });
            None
        }
    }
}

/// The address and port of a key that must be there.
pub(crate) fn address(
    keys: &Keys<'_>,
    key: &'static str,
    example: &'static str,
) -> Option<At<SocketAddr>> {
    let At { value, place } = keys.needed(key, example)?;
    match value.parse() {
        Ok(value) => Some(At { value, place }),
        Err(_) => {
            keys.notes.wrong(&place, Wrong::NoAddress { given: value });
            None
        }
    }
}

/// The time of a key, if it is there.
pub(crate) fn time(
    keys: &Keys<'_>,
    key: &'static str,
    example: &'static str,
    [from, to]: [&'static str; 2],
) -> Option<At<Duration>> {
    let At { value, place } = keys.text(key, example)?;
    let within = |time: &Duration| duration(from) <= Some(*time) && Some(*time) <= duration(to);
    match duration(&value).filter(within) {
        Some(value) => Some(At { value, place }),
        None => {
            let wrong = Wrong::NoTime {
                given: value,
                from,
                to,
            };
            keys.notes.wrong(&place, wrong);
            None
        }
    }
}
