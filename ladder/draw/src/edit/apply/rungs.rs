//! Rungs as a whole.

use crate::edit::cursor::{Cursor, Run, Selected};
use crate::edit::document::{Begin, Document, Node, Rung, holds};
use crate::edit::operation::{Along, Place};
use crate::edit::refusal::Refusal;
use std::sync::Arc;

impl Document {
    /// Inserts an empty rung at this place.
    pub(in crate::edit) fn insert_empty(&mut self, at: usize) -> Cursor {
        let rung = Rung::new(self.fresh());
        let cursor = Cursor::at(rung.id);
        self.rungs_mut().insert(at, Arc::new(rung));
        cursor
    }
}

/// Inserts an empty rung above or below the cursor.
pub(super) fn empty(
    document: &mut Document,
    cursor: Cursor,
    along: Along,
) -> Result<Cursor, Refusal> {
    let rungs = document.selected_rungs(cursor)?;
    let at = match along {
        Along::Back => *rungs.start(),
        Along::Forth => rungs.end() + 1,
    };
    Ok(document.insert_empty(at))
}

/// Inserts rungs above or below the cursor.
pub(super) fn insert(
    document: &mut Document,
    cursor: Cursor,
    rungs: Vec<Arc<Rung>>,
    place: Place,
) -> Result<Cursor, Refusal> {
    let (Some(first), Some(last)) = (rungs.first(), rungs.last()) else {
        return Ok(cursor);
    };
    let inserted = Cursor {
        from: first.id,
        to: last.id,
    };
    let around = document.selected_rungs(cursor)?;
    let at = match place {
        Place::Before => *around.start(),
        Place::Behind | Place::Beside => around.end() + 1,
    };
    document.rungs_mut().splice(at..at, rungs);
    Ok(inserted)
}

/// Moves the rungs at the cursor one place up or down.
pub(super) fn shift(document: &mut Document, cursor: Cursor, along: Along) -> Result<(), Refusal> {
    let rungs = document.selected_rungs(cursor)?;
    let (from, to) = (*rungs.start(), *rungs.end());
    let all = document.rungs_mut();
    match along {
        Along::Back if from > 0 => all[from - 1..=to].rotate_left(1),
        Along::Forth if to + 1 < all.len() => all[from..=to + 1].rotate_right(1),
        Along::Back | Along::Forth => return Err(Refusal::NoFurther),
    }
    Ok(())
}

/// Makes what follows the cursor a rung of its own.
pub(super) fn split(document: &mut Document, cursor: Cursor) -> Result<Cursor, Refusal> {
    let rung = match document.selected(cursor)? {
        Selected::Rungs(_) => return Err(Refusal::SelectElements),
        Selected::Path { rung, .. } | Selected::Run(Run { rung, .. }) => rung,
    };
    // The last node of the rung's own series that is selected, or holds what is.
    let holds = |node: &Node| {
        let node = std::slice::from_ref(node);
        holds(node, cursor.from) || holds(node, cursor.to)
    };
    let series = &document.rungs[rung].series;
    let at = series.iter().rposition(holds).ok_or(Refusal::NotThere)?;
    let id = document.fresh();
    let of = document.rung_mut(rung).ok_or(Refusal::NotThere)?;
    let series = of.series.split_off(at + 1);
    let behind = Rung {
        series,
        ..Rung::new(id)
    };
    document.rungs_mut().insert(rung + 1, Arc::new(behind));
    Ok(Cursor::at(id))
}

/// Lets the last rung at the cursor go on with the one below it.
pub(super) fn join(document: &mut Document, cursor: Cursor) -> Result<(), Refusal> {
    let at = *document.selected_rungs(cursor)?.end();
    let below = document.rungs.get(at + 1).ok_or(Refusal::CannotJoin)?;
    let begins = matches!(below.begin, Begin::Rung | Begin::NewRung) && below.labels.is_empty();
    if !begins || document.rungs[at].ends_in_if() {
        return Err(Refusal::CannotJoin);
    }
    let below = Rung::clone(&document.rungs_mut().remove(at + 1));
    let rung = document.rung_mut(at).ok_or(Refusal::NotThere)?;
    rung.comment.extend(below.comment);
    rung.series.extend(below.series);
    Ok(())
}

/// Changes the head of the rung at the cursor.
pub(super) fn head(
    document: &mut Document,
    cursor: Cursor,
    change: impl FnOnce(&mut Rung),
) -> Result<(), Refusal> {
    let at = *document.selected_rungs(cursor)?.start();
    document.rung_mut(at).map(change).ok_or(Refusal::NotThere)
}
