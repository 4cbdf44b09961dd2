//! Files in TOML that people write: each key taken as what it shall be, and what is none of that noted with its line.
//!
//! - [`keyed`]: from the text of a file to what somebody reads of it, or to all its [`Mistake`]s
//! - [`Keys`]: a table; [`At`]: a value of it with its place; [`Notes`]: what is wrong so far
//! - [`Amiss`]: what can be wrong with any such file, beside what is wrong with a certain one
//!
//! Owns where a value stands, and of what kind it is. Must not know which keys there are, nor what a file is for.

#![forbid(unsafe_code)]

mod keys;
mod mistake;
mod notes;
mod words;

pub use keys::{At, Keys, whole};
pub use mistake::{Amiss, Mistake, Reason};
pub use notes::Notes;
pub use toml::Spanned;
pub use toml::de::DeValue;

use toml::de::DeTable;

/// What `read` makes of the table of a whole file.
///
/// # Errors
/// All that is wrong with it, in the order of the lines.
pub fn keyed<W: From<Amiss>, T>(
    text: &str,
    read: impl FnOnce(&Keys<'_, W>) -> T,
) -> Result<T, Vec<Mistake<W>>> {
    let notes = Notes::new(text);
    let (table, errors) = DeTable::parse_recoverable(text);
    if let Some(error) = errors.first() {
        // What is no TOML at all would be told in each of its lines, in the same words.
        notes.wrong(&error.span().unwrap_or_default(), Amiss::NoToml);
        return Err(notes.mistakes());
    }
    let made = read(&Keys::new(table.get_ref(), 0..0, &notes));
    let mistakes = notes.mistakes();
    match mistakes.is_empty() {
        true => Ok(made),
        false => Err(mistakes),
    }
}
