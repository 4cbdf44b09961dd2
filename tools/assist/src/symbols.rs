//! What a text declares, as an editor lists it.

use crate::language;
use crate::reader::Reader;
use unoclp_lang::Span;
use unoclp_lang::declarations::What;
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
    let Some(language) = language(written) else {
        return Vec::new();
    };
    let text = written.text();
    let reader = Reader::new(&text, language);
    let symbol = |named: &unoclp_lang::declarations::Named| {
        let ty = named.ty.map_or("", |ty| reader.written(ty));
        let point = named.point.map_or("", |point| reader.written(point));
        Symbol {
            name: reader.written(named.name).to_owned(),
            what: named.what,
            detail: format!("{ty} {point}").trim().to_owned(),
            at: named.name,
            whole: named.whole.to(named.name),
            within: named.within,
        }
    };
    reader.outline.named.iter().map(symbol).collect()
}
