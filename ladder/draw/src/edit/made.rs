//! Documents that others have made, rung by rung, and their codes with what each came from.

use super::check::{Mistake, Wrong};
use super::document::{Document, Id, Rung, visit};
use super::emit::Emitted;
use super::table::Table;
use crate::Names;
use std::sync::Arc;

impl Document {
    /// A document of these rungs; each of their ids stands in it once.
    pub fn of_rungs(rungs: Vec<Rung>, title: Vec<String>, names: Names) -> Document {
        let mut next = 0;
        for rung in &rungs {
            next = next.max(rung.id.0);
            visit(&rung.series, &mut |node| {
                let paths = node.paths().iter().map(|path| path.id.0);
                next = paths.fold(next.max(node.id().0), u32::max);
            });
        }
        Document {
            rungs: Arc::new(rungs.into_iter().map(Arc::new).collect()),
            table: Arc::new(Table::of(names)),
            title: title.into(),
            next,
        }
    }

    /// Its instructions in their order, without program start: the lines of a program file that say each, and what it
    /// came from: an element, a path, a block, or the rung.
    ///
    /// # Errors
    /// As of [`Document::codes`].
    pub fn instructions(&self) -> Result<Vec<(Id, Vec<i32>)>, Vec<Mistake>> {
        let emitted = Emitted::of(self);
        emitted.codes()?;
        let missing = |at| {
            vec![Mistake {
                at: Some(at),
                what: Wrong::Missing,
            }]
        };
        let codes = emitted.codes.iter();
        codes
            .map(|code| Ok((code.of, code.what.codes().ok_or_else(|| missing(code.of))?)))
            .collect()
    }
}
