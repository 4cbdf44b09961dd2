//! What an element is, and what points are called.

use crate::edit::cursor::Cursor;
use crate::edit::document::{Document, Element, Node};
use crate::edit::draft::Draft;
use crate::edit::refusal::Refusal;
use crate::edit::step::Step;
use crate::edit::table::Row;
use crate::edit::which::{self, Coil};
use std::sync::Arc;
use unoclp_core::isa::BRANCH_POINTS;
use unoclp_point::Address;

pub(super) fn toggle(document: &mut Document, cursor: Cursor) -> Result<(), Refusal> {
    step(document, cursor, which::opposite)
}

pub(super) fn coil(document: &mut Document, cursor: Cursor, coil: Coil) -> Result<(), Refusal> {
    step(document, cursor, |step| which::with_coil(step, coil))
}

pub(super) fn address(
    document: &mut Document,
    cursor: Cursor,
    address: Option<Address>,
) -> Result<(), Refusal> {
    step(document, cursor, |step| which::with_address(step, address))
}

pub(super) fn line(
    document: &mut Document,
    cursor: Cursor,
    index: usize,
    value: Option<i32>,
) -> Result<(), Refusal> {
    step(document, cursor, |step| {
        let mut lines = step.lines().to_vec();
        *lines.get_mut(index).ok_or(Refusal::OutOfRange)? = value;
        Ok(step.clone().with_lines(lines))
    })
}

pub(super) fn replace(
    document: &mut Document,
    cursor: Cursor,
    draft: Draft,
) -> Result<(), Refusal> {
    let draft = draft.checked()?;
    let element = element(document, cursor)?;
    *element = draft.element(element.id);
    Ok(())
}

/// Gives a branch point another number.
pub(super) fn point(
    document: &mut Document,
    cursor: Cursor,
    point: Option<u8>,
) -> Result<(), Refusal> {
    if point.is_some_and(|point| !(1..=BRANCH_POINTS).contains(&point)) {
        return Err(Refusal::OutOfRange);
    }
    match (node(document, cursor)?, point) {
        (Node::Store(store), Some(point)) => store.point = point,
        (Node::Block(block), point) => block.recall = point,
        (Node::Parallel(parallel), point) => parallel.point = point,
        (Node::Store(_), None) => return Err(Refusal::OutOfRange),
        (Node::Element(_), _) => return Err(Refusal::NotThatAddress),
    }
    Ok(())
}

/// Says what a point is called, and what it is for.
pub(super) fn name(document: &mut Document, point: Address, row: Row) -> Result<(), Refusal> {
    let taken = document.table.point(&row.name);
    if !row.name.is_empty() && taken.is_some_and(|other| other != point) {
        return Err(Refusal::NameTaken);
    }
    Arc::make_mut(&mut document.table).set(point, row);
    Ok(())
}

fn step(
    document: &mut Document,
    cursor: Cursor,
    to: impl FnOnce(&Step) -> Result<Step, Refusal>,
) -> Result<(), Refusal> {
    let element = element(document, cursor)?;
    element.step = to(&element.step)?;
    Ok(())
}

/// The element that the cursor selects.
fn element(document: &mut Document, cursor: Cursor) -> Result<&mut Element, Refusal> {
    match node(document, cursor)? {
        Node::Element(element) => Ok(element),
        _ => Err(Refusal::SelectOne),
    }
}

fn node(document: &mut Document, cursor: Cursor) -> Result<&mut Node, Refusal> {
    if cursor.from != cursor.to {
        return Err(Refusal::SelectOne);
    }
    let run = document.run(cursor)?;
    let series = document.series_mut(run.rung, run.series)?;
    series.get_mut(*run.nodes.start()).ok_or(Refusal::NotThere)
}
