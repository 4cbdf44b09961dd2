//! What holds for every document, seen to in the rungs that have changed.
//!
//! - An IF is the last node of its rung.
//! - Branches stand in each other only as deep as can be drawn.
//! - A load right before a comparison belongs to it, as it does where codes are read.
//! - A parallel at the beginning of its series needs no branch point, and has none unless a block names it.

use crate::edit::cursor::Cursor;
use crate::edit::document::{Document, Id, Node, Rung, Series, depth, visit};
use crate::edit::refusal::Refusal;
use crate::edit::state::State;
use std::sync::Arc;
use unoclp_core::isa::{Class, Opcode};

/// The deepest that operations make branches stand in each other; codes that are read may have them deeper.
const DEEPEST: usize = 64;

/// Sees to what holds for every document.
pub(super) fn settle(before: &Document, state: &mut State) -> Result<(), Refusal> {
    let document = &mut state.document;
    let old = |rung: &Arc<Rung>| before.rungs.iter().any(|other| Arc::ptr_eq(rung, other));
    let deepest = before.rungs.iter().map(|rung| depth(&rung.series)).max();
    let most = DEEPEST.max(deepest.unwrap_or(0));
    for at in 0..document.rungs.len() {
        if old(&document.rungs[at]) {
            continue;
        }
        let Some(rung) = document.rung_mut(at) else {
            continue;
        };
        if depth(&rung.series) > most {
            return Err(Refusal::TooDeep);
        }
        if !ifs_are_last(rung) {
            return Err(Refusal::IfEndsRung);
        }
        merge_loads(&mut rung.series, &mut state.cursor);
        let named = named(&rung.series);
        free_first(&mut rung.series, &named);
    }
    if document.selected(state.cursor).is_err() {
        // Part of what was selected has gone, or stands elsewhere now.
        let still = [state.cursor.to, state.cursor.from]
            .into_iter()
            .find(|&id| document.rung_of(id).is_some());
        let first = document.rungs.first().map_or(Id(0), |rung| rung.id);
        state.cursor = Cursor::at(still.unwrap_or(first));
    }
    Ok(())
}

fn ifs_are_last(rung: &Rung) -> bool {
    let mut ifs = 0;
    visit(&rung.series, &mut |node| {
        ifs += usize::from(
            matches!(node, Node::Element(element) if element.step.opcode() == Opcode::If),
        );
    });
    ifs == usize::from(rung.ends_in_if())
}

fn merge_loads(series: &mut Series, cursor: &mut Cursor) {
    let mut index = 1;
    while index < series.len() {
        if let [Node::Element(one), Node::Element(two)] = &mut series[index - 1..=index]
            && one.step.class() == Class::Load
            && two.load.is_none()
            && matches!(two.step.class(), Class::Comparison | Class::ValueContact)
        {
            two.load = Some(one.step.clone());
            for end in [&mut cursor.from, &mut cursor.to] {
                if *end == one.id {
                    *end = two.id;
                }
            }
            series.remove(index - 1);
        } else {
            index += 1;
        }
    }
    for path in series.iter_mut().flat_map(Node::paths_mut) {
        merge_loads(&mut path.series, cursor);
    }
}

/// The branch points that blocks name.
fn named(series: &Series) -> Vec<u8> {
    let mut named = Vec::new();
    visit(series, &mut |node| {
        if let Node::Block(block) = node {
            named.extend(block.recall);
        }
    });
    named
}

fn free_first(series: &mut Series, named: &[u8]) {
    if let Some(Node::Parallel(first)) = series.first_mut() {
        first.point = first.point.filter(|point| named.contains(point));
    }
    for path in series.iter_mut().flat_map(Node::paths_mut) {
        free_first(&mut path.series, named);
    }
}
