//! Blocks: what is selected gets a result of its own.

use crate::edit::cursor::Cursor;
use crate::edit::document::{Block, Document, Gate, Id, Node, Path};
use crate::edit::refusal::Refusal;

/// Makes what is selected a block; gives the cursor that selects it.
pub(super) fn enclose(
    document: &mut Document,
    cursor: Cursor,
    gate: Gate,
) -> Result<Cursor, Refusal> {
    let run = document.run(cursor)?;
    let (id, path) = (document.fresh(), document.fresh());
    let series = document.series_mut(run.rung, run.series)?;
    let at = *run.nodes.start();
    let path = Path {
        id: path,
        series: series.drain(run.nodes).collect(),
    };
    let block = Block {
        id,
        gate,
        recall: None,
        path,
    };
    series.insert(at, Node::Block(block));
    Ok(Cursor::at(id))
}

/// Puts what the selected block holds in its place; gives the cursor that selects that.
pub(super) fn dissolve(document: &mut Document, cursor: Cursor) -> Result<Cursor, Refusal> {
    let run = document.run(cursor)?;
    if run.nodes.start() != run.nodes.end() {
        return Err(Refusal::SelectOne);
    }
    let series = document.rungs[run.rung].series(run.series);
    let node = series.and_then(|series| series.get(*run.nodes.start()));
    let Some(Node::Block(block)) = node else {
        return Err(Refusal::SelectBlock);
    };
    let inner = &block.path.series;
    let cursor = match (inner.first(), inner.last()) {
        (Some(first), Some(last)) => Cursor {
            from: first.id(),
            to: last.id(),
        },
        _ => Cursor::at(document.rungs[run.rung].id),
    };
    let id = block.id;
    unwrap(document, run.rung, id)?;
    Ok(cursor)
}

/// Puts what a block holds in its place, if that is what this is.
pub(super) fn unwrap(document: &mut Document, rung: usize, block: Id) -> Result<(), Refusal> {
    let place = document.rungs[rung].place(block);
    let (series, at) = place.ok_or(Refusal::NotThere)?;
    let series = document.series_mut(rung, series)?;
    if let Some(Node::Block(block)) = series.get_mut(at) {
        let inner = std::mem::take(&mut block.path.series);
        series.splice(at..=at, inner);
    }
    Ok(())
}
