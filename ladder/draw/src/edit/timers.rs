//! Timers are known by their place in the program. When one comes or goes, those after it get other numbers, and
//! whatever names them has to follow.

use super::clip::Renamed;
use super::document::{Document, Id, Node, visit, visit_mut};
use super::step::Step;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use unoclp_core::isa::Kind;
use unoclp_point::Address;

/// Lets what names a timer of `before` name the same in `after`; a timer that is gone leaves its address missing.
/// `pasted` tells what was copied into it, and what numbers mean there.
pub(crate) fn renumber(before: &Document, after: &mut Document, pasted: Option<&Renamed>) {
    let (old, new) = (before.timers(), after.timers());
    if old == new && pasted.is_none() {
        return;
    }
    let place = |id: &Id| new.iter().position(|timer| timer == id);
    let number = |id: &Id| u8::try_from(place(id)? + 1).ok();
    let numbers: BTreeMap<u8, Option<u8>> = (1..).zip(old.iter().map(number)).collect();
    // A number that no timer has had means none.
    let followed = |xx: u8| numbers.get(&xx).copied().unwrap_or(Some(xx));
    let fresh: BTreeSet<Id> = match pasted {
        Some(_) => fresh_elements(before, after),
        None => BTreeSet::new(),
    };
    let next = |of: Id, xx: u8| match pasted {
        Some(renamed) if fresh.contains(&of) => match renamed.timer(xx) {
            Some(timer) => number(&timer),
            None => Some(xx),
        },
        _ => followed(xx),
    };
    for rung in after.rungs_mut() {
        if !names_timers(&rung.series) {
            continue;
        }
        visit_mut(&mut Arc::make_mut(rung).series, &mut |node| {
            if let Node::Element(element) = node {
                let id = element.id;
                let steps = element.load.iter_mut().chain([&mut element.step]);
                for step in steps.filter(|step| step.opcode().row().kind == Kind::TimerQ) {
                    if let Some(xx) = step.number() {
                        *step = Step::clone(step).with_number(next(id, xx));
                    }
                }
            }
        });
    }
    let renamed = |point| match point {
        Address::Timer(xx) => followed(xx).map(Address::Timer),
        other => Some(other),
    };
    if after
        .table
        .rows()
        .any(|(point, _)| renamed(point) != Some(point))
    {
        after.table = Arc::new(after.table.renamed(renamed));
    }
}

/// The elements that a document did not have before.
fn fresh_elements(before: &Document, after: &Document) -> BTreeSet<Id> {
    let mut fresh = BTreeSet::new();
    for rung in after.rungs() {
        visit(&rung.series, &mut |node| {
            if node.id() > Id(before.next) {
                fresh.insert(node.id());
            }
        });
    }
    fresh
}

fn names_timers(series: &[Node]) -> bool {
    let mut names = false;
    visit(series, &mut |node| {
        if let Node::Element(element) = node {
            let mut steps = element.load.iter().chain([&element.step]);
            names |= steps.any(|step| step.opcode().row().kind == Kind::TimerQ);
        }
    });
    names
}
