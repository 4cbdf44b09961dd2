//! What an editor is offered and told of a text, in every language that is compiled.
//!
//! - [`complete()`]: what may stand at a place: names, members, types, blocks with their pins, keywords
//! - [`hover()`]: what a word stands for, where it is on the board, what its line costs and does
//! - [`declaration`], [`uses()`]: where a name comes from, and where it is used, in all units of a project too
//! - [`rename()`]: the same program by another name; [`declared`]: the place of a name that is known by its unit
//! - [`format()`]: the same words, well placed
//! - [`remedies()`]: what a diagnostic says one could do, done
//! - [`symbols()`]: what a text declares
//!
//! The way of a text: `reading` (a project as one text), `reader` (its words and declarations), `meaning` (what a word
//! stands for), and then a file for each of the above. All of it holds for a text with mistakes too, and takes a time in proportion to it.
//!
//! Owns what an editor knows of a text. Must not know files, protocols, screens, nor what a word of one language does: the
//! registry's rows say it.

#![forbid(unsafe_code)]

mod complete;
mod format;
mod hover;
mod meaning;
mod reader;
mod reading;
mod remedies;
mod rename;
mod symbols;
mod uses;
mod words;

pub use complete::{Kind, Offer, complete};
pub use format::format;
pub use hover::{Hover, hover};
pub use remedies::{Remedy, remedies};
pub use rename::{NoRename, prepare, rename};
pub use symbols::{Symbol, symbols};
pub use uses::{Use, declaration, declared, uses};

use unoclp_lang::{Span, TextLanguage};
use unoclp_program::{Written, WrittenIn};

/// A change of a text: what stands there gives way to this.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// What goes; empty where something is put in.
    pub span: Span,
    /// What comes.
    pub text: String,
}

/// A text with these changes, which do not overlap.
pub fn edited(text: &str, edits: &[Edit]) -> String {
    let mut edits: Vec<&Edit> = edits.iter().collect();
    edits.sort_by_key(|edit| edit.span.start);
    let mut all = String::with_capacity(text.len());
    let mut at = 0;
    for edit in edits {
        let range = edit.span.range();
        all.push_str(text.get(at..range.start).unwrap_or_default());
        all.push_str(&edit.text);
        at = range.end.max(at);
    }
    all.push_str(text.get(at..).unwrap_or_default());
    all
}

/// The language of a text that is compiled by its words; none of numeric code and projects.
fn language(written: &Written) -> Option<TextLanguage> {
    match written.language.as_ref().ok()? {
        WrittenIn::Il => Some(TextLanguage::Il),
        WrittenIn::Typed(language) => Some(*language),
        WrittenIn::Numeric | WrittenIn::Xml => None,
    }
}
