//! Which expressions read the number of a counter, which goes on beyond INT (NC-15).
//!
//! Owns that mark, by which the number is cut where it is stored as an INT. Must not know instructions.

use super::flat::{Does, Flat, Step, own_expressions_mut, parts_mut, within};
use super::ranges::COUNT;
use std::collections::HashSet;
use unoclp_tree::{Expr, ExprKind};

/// Marks the reads of counters' numbers.
pub(super) fn mark(flat: &mut Flat) {
    let mut counts = HashSet::new();
    collect(&flat.body, &mut counts);
    if !counts.is_empty() {
        steps(&mut flat.body, &counts);
    }
}

fn collect(steps: &[Step], counts: &mut HashSet<u32>) {
    for step in steps {
        if let Does::Standard(block, cell, _) | Does::Order(_, block, cell) = &step.does
            && let Some(part) = block.number()
        {
            counts.insert(cell + part);
        }
        for inner in within(&step.does) {
            collect(inner, counts);
        }
    }
}

fn steps(all: &mut [Step], counts: &HashSet<u32>) {
    for step in all {
        for expr in own_expressions_mut(&mut step.does) {
            expression(expr, counts);
        }
        match &mut step.does {
            Does::If(_, then, otherwise) => {
                steps(then, counts);
                steps(otherwise, counts);
            }
            Does::Case(_, arms, otherwise) => {
                arms.iter_mut().for_each(|(_, body)| steps(body, counts));
                steps(otherwise, counts);
            }
            _ => {}
        }
    }
}

fn expression(expr: &mut Expr, counts: &HashSet<u32>) {
    if let ExprKind::Read(place) = &expr.kind
        && counts.contains(&place.offset)
    {
        expr.ty = COUNT;
    }
    for part in parts_mut(expr) {
        expression(part, counts);
    }
}
