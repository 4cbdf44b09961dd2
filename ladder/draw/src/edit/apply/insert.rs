//! Inserting nodes in series or in parallel.

use super::remove;
use crate::edit::clip::loosen;
use crate::edit::cursor::{Cursor, Run, Selected};
use crate::edit::document::{Document, Id, Node, Parallel, Path, Series};
use crate::edit::operation::Place;
use crate::edit::refusal::Refusal;

/// Inserts nodes at the cursor; gives the cursor that selects them.
pub(super) fn nodes(
    document: &mut Document,
    cursor: Cursor,
    nodes: Series,
    place: Place,
) -> Result<Cursor, Refusal> {
    let (Some(first), Some(last)) = (nodes.first(), nodes.last()) else {
        return Ok(cursor);
    };
    let inserted = Cursor {
        from: first.id(),
        to: last.id(),
    };
    let selected = document.selected(cursor)?;
    if place == Place::Beside {
        beside(document, selected, nodes)?;
        return Ok(inserted);
    }
    let (rung, id, at) = match (selected, place) {
        (Selected::Path { rung, path }, _) => (rung, path, Some(0)),
        (Selected::Run(run), Place::Before) => (run.rung, run.series, Some(*run.nodes.start())),
        (Selected::Run(run), _) => (run.rung, run.series, Some(run.nodes.end() + 1)),
        (Selected::Rungs(rungs), _) => {
            let rung = *rungs.end();
            let at = (place == Place::Before).then_some(0);
            (rung, document.rungs[rung].id, at)
        }
    };
    let series = document.series_mut(rung, id)?;
    let at = at.unwrap_or(series.len()).min(series.len());
    series.splice(at..at, nodes);
    Ok(inserted)
}

/// Opens an empty path beside what is selected; gives the cursor that is on it.
pub(super) fn branch(document: &mut Document, cursor: Cursor) -> Result<Cursor, Refusal> {
    let selected = document.selected(cursor)?;
    beside(document, selected, Series::new()).map(Cursor::at)
}

/// Moves what is selected to this place at something else.
pub(super) fn carried(
    document: &mut Document,
    cursor: Cursor,
    to: Id,
    place: Place,
) -> Result<Cursor, Refusal> {
    let run = document.run(cursor)?;
    let mut moved = remove::take(document, &run)?;
    if document.rung_of(to).is_none() {
        return Err(Refusal::IntoItself);
    }
    loosen(&mut moved);
    let target = Cursor::at(to);
    nodes(document, target, moved, place)
}

/// Puts nodes on a path beside what is selected; gives what the path is known by.
fn beside(document: &mut Document, selected: Selected, nodes: Series) -> Result<Id, Refusal> {
    let new = Path {
        id: document.fresh(),
        series: nodes,
    };
    let id = new.id;
    match selected {
        Selected::Rungs(_) => return Err(Refusal::SelectElements),
        Selected::Path { rung, path } => behind_path(document, rung, path, new)?,
        Selected::Run(run) => beside_run(document, run, new)?,
    }
    Ok(id)
}

/// Puts a path below another.
fn behind_path(document: &mut Document, rung: usize, path: Id, new: Path) -> Result<(), Refusal> {
    let owner = document.rungs[rung].owner(path).ok_or(Refusal::NotThere)?;
    let place = document.rungs[rung].place(owner);
    let (series, at) = place.ok_or(Refusal::NotThere)?;
    match document.series_mut(rung, series)?.get_mut(at) {
        Some(Node::Parallel(parallel)) => {
            let at = parallel.paths.iter().position(|other| other.id == path);
            parallel.paths.insert(at.map_or(0, |at| at + 1), new);
            Ok(())
        }
        _ => Err(Refusal::SelectElements),
    }
}

fn beside_run(document: &mut Document, run: Run, new: Path) -> Result<(), Refusal> {
    let rung = &document.rungs[run.rung];
    let whole = rung.series(run.series).map(|series| series.len());
    let is_whole = whole == Some(run.nodes.end() - run.nodes.start() + 1);
    // All of a path: the new one goes beside it, with no wire of its own.
    if is_whole && run.series != rung.id {
        match behind_path(document, run.rung, run.series, new.clone()) {
            Err(Refusal::SelectElements) => {}
            done => return done,
        }
    }
    let (id, first) = (document.fresh(), document.fresh());
    let series = document.series_mut(run.rung, run.series)?;
    if run.nodes.start() == run.nodes.end()
        && let Some(Node::Parallel(parallel)) = series.get_mut(*run.nodes.start())
    {
        parallel.paths.push(new);
        return Ok(());
    }
    let at = *run.nodes.start();
    let first = Path {
        id: first,
        series: series.drain(run.nodes).collect(),
    };
    let paths = vec![first, new];
    let point = None;
    series.insert(at, Node::Parallel(Parallel { id, point, paths }));
    Ok(())
}
