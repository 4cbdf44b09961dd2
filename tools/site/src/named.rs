//! The name of an alarm or a user.

use crate::keys::{At, Keys};
use crate::mistake::Wrong;

/// The name of a table, which must be there: it stands in topics, in paths and in heads of HTTP.
pub(crate) fn named(table: &Keys<'_>, example: &'static str) -> Option<At<String>> {
    let name = table.needed("name", example)?;
    let of_name = |ch: char| ch.is_ascii_alphanumeric() || matches!(ch, '-' | '_');
    let is_name = name.value.len() <= 32
        && name.value.starts_with(|ch: char| ch.is_ascii_alphabetic())
        && name.value.chars().all(of_name);
    if is_name {
        return Some(name);
    }
    let given = format!("{:?}", name.value);
    table.notes.wrong(&name.place, Wrong::NoName { given });
    None
}
