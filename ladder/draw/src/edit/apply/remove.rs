//! Deleting nodes, paths and rungs.

use crate::edit::cursor::{Cursor, Run, Selected};
use crate::edit::document::{Document, Id, Node, Series};
use crate::edit::refusal::Refusal;

/// Deletes what is selected; gives the cursor that is near it.
pub(super) fn selected(document: &mut Document, cursor: Cursor) -> Result<Cursor, Refusal> {
    match document.selected(cursor)? {
        Selected::Rungs(rungs) => {
            let first = *rungs.start();
            document.rungs_mut().drain(rungs);
            if document.rungs.is_empty() {
                document.insert_empty(0);
            }
            let near = first.min(document.rungs.len() - 1);
            Ok(Cursor::at(document.rungs[near].id))
        }
        Selected::Path { rung, path } => {
            let near = without_path(document, rung, path)?;
            Ok(Cursor::at(near))
        }
        Selected::Run(run) => {
            let rung = &document.rungs[run.rung];
            let series = rung.series(run.series).ok_or(Refusal::NotThere)?;
            let before = run.nodes.start().checked_sub(1);
            let near = before.and_then(|before| series.get(before));
            let near = near.or_else(|| series.get(run.nodes.end() + 1));
            let near = near.map_or(rung.id, Node::id);
            take(document, &run)?;
            // What was near may have been a branch that is a plain wire now.
            let rung = &document.rungs[run.rung];
            let is_there = document.rung_of(near).is_some();
            Ok(Cursor::at(if is_there { near } else { rung.id }))
        }
    }
}

/// Takes nodes out of their series. A path that it leaves empty goes too, and a parallel of one path is a plain wire.
pub(super) fn take(document: &mut Document, run: &Run) -> Result<Series, Refusal> {
    let series = document.series_mut(run.rung, run.series)?;
    let taken: Series = series.drain(run.nodes.clone()).collect();
    if series.is_empty() && document.rungs[run.rung].id != run.series {
        without_path(document, run.rung, run.series)?;
    }
    Ok(taken)
}

/// Deletes a path; gives what is near it.
fn without_path(document: &mut Document, rung: usize, path: Id) -> Result<Id, Refusal> {
    let owner = document.rungs[rung].owner(path).ok_or(Refusal::NotThere)?;
    let place = document.rungs[rung].place(owner);
    let (around, at) = place.ok_or(Refusal::NotThere)?;
    let series = document.series_mut(rung, around)?;
    let mut rest = match &mut series[at] {
        Node::Parallel(parallel) if parallel.paths.len() > 2 => {
            parallel.paths.retain(|other| other.id != path);
            return Ok(owner);
        }
        Node::Parallel(parallel) => {
            parallel.paths.retain(|other| other.id != path);
            parallel.paths.pop().map(|last| last.series)
        }
        _ => None,
    }
    .unwrap_or_default();
    let near = rest.first().map(Node::id);
    series.splice(at..=at, rest.drain(..));
    if let Some(near) = near {
        return Ok(near);
    }
    let near = at.checked_sub(1).and_then(|before| series.get(before));
    if let Some(near) = near.or_else(|| series.get(at)).map(Node::id) {
        return Ok(near);
    }
    match document.rungs[rung].id {
        id if id == around => Ok(id),
        _ => without_path(document, rung, around),
    }
}
