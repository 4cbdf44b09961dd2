//! What a text declares, as an editor lists it.

use crate::reading::Reading;
use unoclp_lang::Span;
use unoclp_lang::outline::{Named, What};
use unoclp_program::Written;

/// A declaration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// As it is written.
    pub name: String,
    /// What it is.
    pub what: What,
    /// Its type, and its point.
    pub detail: String,
    /// Its name in the text.
    pub at: Span,
    /// All that belongs to it.
    pub whole: Span,
    /// What it belongs to, by its place in the list.
    pub within: Option<usize>,
}

/// All declarations of a text in the order of their places.
pub fn symbols(written: &Written) -> Vec<Symbol> {
    let Some(reading) = Reading::of(written) else {
        return Vec::new();
    };
    let reader = reading.reader();
    let name = |named: &Named| reading.span(named.name).unwrap_or_default();
    let symbol = |named: &Named| {
        let ty = named.ty.map_or("", |ty| reader.written(ty));
        let point = named.point.map_or("", |point| reader.written(point));
        Symbol {
            name: reader.written(named.name).to_owned(),
            what: named.what,
            detail: format!("{ty} {point}").trim().to_owned(),
            at: name(named),
            // A declaration of a project is spelled otherwise there.
            whole: reading
                .span(named.whole.to(named.name))
                .unwrap_or(name(named)),
            within: named.within,
        }
    };
    reader.outline.named.iter().map(symbol).collect()
}
