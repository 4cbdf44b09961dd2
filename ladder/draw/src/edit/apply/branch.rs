//! The ends of branches.

use crate::edit::cursor::Cursor;
use crate::edit::document::{Document, Id, Node};
use crate::edit::operation::{Along, Way};
use crate::edit::refusal::Refusal;

/// Moves an end of the branch at the cursor, or else of the one around it.
pub(super) fn stretch(
    document: &mut Document,
    cursor: Cursor,
    end: Along,
    way: Way,
) -> Result<(), Refusal> {
    let (rung, id) = parallel(document, cursor)?;
    let place = document.rungs[rung].place(id);
    let (series, at) = place.ok_or(Refusal::NotThere)?;
    let series = document.series_mut(rung, series)?;
    let beside = match end {
        Along::Back => at.checked_sub(1),
        Along::Forth => Some(at + 1).filter(|&at| at < series.len()),
    };
    let taken = match (way, beside) {
        (Way::Out, beside) => Some(series.remove(beside.ok_or(Refusal::NoFurther)?)),
        (Way::In, _) => None,
    };
    // What stood before it is taken in: it stands one place further left now.
    let at = at - usize::from(taken.is_some() && end == Along::Back);
    let Some(Node::Parallel(parallel)) = series.get_mut(at) else {
        return Err(Refusal::NotThere);
    };
    let inner = &mut parallel.paths[0].series;
    match (taken, end) {
        (Some(node), Along::Back) => inner.insert(0, node),
        (Some(node), Along::Forth) => inner.push(node),
        (None, _) if inner.len() < 2 => return Err(Refusal::NoFurther),
        (None, Along::Back) => {
            let node = inner.remove(0);
            series.insert(at, node);
        }
        (None, Along::Forth) => {
            let node = inner.pop().ok_or(Refusal::NoFurther)?;
            series.insert(at + 1, node);
        }
    }
    Ok(())
}

/// The parallel at the cursor, or the innermost around it.
fn parallel(document: &Document, cursor: Cursor) -> Result<(usize, Id), Refusal> {
    let rung = document.rung_of(cursor.from).ok_or(Refusal::NotThere)?;
    let of = &document.rungs[rung];
    let is_parallel = |id: Id| {
        let (series, at) = of.place(id)?;
        matches!(of.series(series)?.get(at)?, Node::Parallel(_)).then_some(())
    };
    let mut id = cursor.from;
    loop {
        if is_parallel(id).is_some() {
            return Ok((rung, id));
        }
        // A path is owned by a node, and a node stands on a path.
        let around = of.owner(id).or_else(|| Some(of.place(id)?.0));
        match around {
            Some(around) if around != of.id => id = around,
            _ => return Err(Refusal::SelectElements),
        }
    }
}
