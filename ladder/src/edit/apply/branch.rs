//! The ends of branches, and contacts that wait for a change.

use crate::edit::cursor::{Cursor, Run};
use crate::edit::document::{Block, Document, Element, Gate, Id, Node, Path, Series};
use crate::edit::operation::{Along, Edge, Way};
use crate::edit::refusal::Refusal;
use crate::edit::step::Step;
use unoclp_core::isa::{Class, Opcode};

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

/// Lets a contact wait for a change, or no longer. At the beginning of its series the edge stands behind it; anywhere
/// else both are a block, so that the edge looks at the contact alone.
pub(super) fn edge(
    document: &mut Document,
    cursor: Cursor,
    edge: Option<Edge>,
) -> Result<Cursor, Refusal> {
    let Run {
        rung,
        series,
        nodes,
    } = document.run(cursor)?;
    let at = *nodes.start();
    if nodes.end() != nodes.start() {
        return Err(Refusal::SelectOne);
    }
    let owner = document.rungs[rung].owner(series);
    let (ids, rail) = (
        [document.fresh(), document.fresh(), document.fresh()],
        document.rungs[rung].id == series,
    );
    let series = document.series_mut(rung, series)?;
    let is_contact =
        |node: &Node| matches!(node, Node::Element(e) if e.step.class() == Class::Contact);
    if !series.get(at).is_some_and(is_contact) {
        return Err(Refusal::ContactsOnly);
    }
    let is_edge = series.get(at + 1).is_some_and(is_edge);
    let step = edge.map(|edge| match edge {
        Edge::Rising => Step::new(Opcode::RisingEdge),
        Edge::Falling => Step::new(Opcode::FallingEdge),
    });
    match step {
        Some(step) if is_edge && at == 0 => {
            if let Some(Node::Element(element)) = series.get_mut(at + 1) {
                element.step = step;
            }
        }
        Some(step) => {
            let id = ids[0];
            let load = None;
            let edge = Node::Element(Element { id, load, step });
            if at == 0 && rail {
                series.insert(1, edge);
            } else {
                let contact = series.remove(at);
                series.insert(at, block([ids[1], ids[2]], vec![contact, edge]));
            }
        }
        None if is_edge && at == 0 => {
            series.remove(at + 1);
            let alone = series.len() == 1;
            if let (Some(owner), true) = (owner, alone) {
                unwrap(document, rung, owner)?;
            }
        }
        None => {}
    }
    Ok(cursor)
}

fn is_edge(node: &Node) -> bool {
    let edges = [Opcode::RisingEdge, Opcode::FallingEdge];
    matches!(node, Node::Element(element) if edges.contains(&element.step.opcode()))
}

fn block([id, path]: [Id; 2], series: Series) -> Node {
    Node::Block(Block {
        id,
        gate: Gate::And,
        recall: None,
        path: Path { id: path, series },
    })
}

/// Puts what an AND block holds in its place.
fn unwrap(document: &mut Document, rung: usize, owner: Id) -> Result<(), Refusal> {
    let place = document.rungs[rung].place(owner);
    let (series, at) = place.ok_or(Refusal::NotThere)?;
    let series = document.series_mut(rung, series)?;
    if let Some(Node::Block(block)) = series.get_mut(at)
        && block.gate == Gate::And
        && block.recall.is_none()
    {
        let inner = std::mem::take(&mut block.path.series);
        series.splice(at..=at, inner);
    }
    Ok(())
}
