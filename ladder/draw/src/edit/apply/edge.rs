//! Contacts that wait for a change.
//!
//! An edge looks at all that stands before it in its rung or block. So a contact that is the first of its rung has its
//! edge right after it; any other one is in an AND block with it.

use super::block;
use crate::edit::cursor::{Cursor, Run};
use crate::edit::document::{Block, Document, Element, Gate, Id, Node, Rung};
use crate::edit::operation::Edge;
use crate::edit::refusal::Refusal;
use crate::edit::step::Step;
use unoclp_core::isa::{Class, Opcode};

/// Lets a contact wait for a change, or no longer; gives the cursor that selects it with its edge.
pub(super) fn edge(
    document: &mut Document,
    cursor: Cursor,
    edge: Option<Edge>,
) -> Result<Cursor, Refusal> {
    let contact = contact(document, cursor)?;
    let alone = Cursor::at(contact);
    let Run {
        rung,
        series,
        nodes,
    } = document.run(alone)?;
    let at = *nodes.start();
    let is_rung = document.rungs[rung].id == series;
    let block = block_of_two(&document.rungs[rung], series);
    let id = document.fresh();
    let nodes = document.series_mut(rung, series)?;
    let has_edge = at == 0 && nodes.get(1).is_some_and(is_edge);
    let step = match edge {
        Some(Edge::Rising) => Step::new(Opcode::RisingEdge),
        Some(Edge::Falling) => Step::new(Opcode::FallingEdge),
        None if !has_edge => return Ok(alone),
        None => {
            nodes.remove(1);
            if let Some(block) = block {
                block::unwrap(document, rung, block)?;
            }
            return Ok(alone);
        }
    };
    if has_edge && let Some(Node::Element(element)) = nodes.get_mut(1) {
        element.step = step;
        let both = Cursor {
            from: contact,
            to: element.id,
        };
        return Ok(block.map_or(both, Cursor::at));
    }
    let load = None;
    let element = Node::Element(Element { id, load, step });
    nodes.insert(at + 1, element);
    let both = Cursor {
        from: contact,
        to: id,
    };
    match at == 0 && is_rung {
        true => Ok(both),
        false => block::enclose(document, both, Gate::And),
    }
}

/// The AND block of two nodes whose series this is.
fn block_of_two(rung: &Rung, series: Id) -> Option<Id> {
    let (around, at) = rung.place(rung.owner(series)?)?;
    match rung.series(around)?.get(at)? {
        Node::Block(block) if is_and(block) && block.path.series.len() == 2 => Some(block.id),
        _ => None,
    }
}

fn is_and(block: &Block) -> bool {
    block.gate == Gate::And && block.recall.is_none()
}

/// The contact that is selected: alone, with its edge, or as the block of both.
fn contact(document: &Document, cursor: Cursor) -> Result<Id, Refusal> {
    let run = document.run(cursor)?;
    let series = document.rungs[run.rung].series(run.series);
    let nodes = series
        .and_then(|series| series.get(run.nodes))
        .unwrap_or_default();
    let nodes = match nodes {
        [Node::Block(block)] if is_and(block) => &block.path.series,
        nodes => nodes,
    };
    match nodes {
        [Node::Element(contact)] if contact.step.class() == Class::Contact => Ok(contact.id),
        [Node::Element(contact), edge]
            if contact.step.class() == Class::Contact && is_edge(edge) =>
        {
            Ok(contact.id)
        }
        _ => Err(Refusal::ContactsOnly),
    }
}

fn is_edge(node: &Node) -> bool {
    let edges = [Opcode::RisingEdge, Opcode::FallingEdge];
    matches!(node, Node::Element(element) if edges.contains(&element.step.opcode()))
}
