//! The way from an element of a chart back to steps and transitions, through divergences and convergences.

use crate::xml::all;
use roxmltree::Node;
use std::collections::{HashMap, HashSet};

/// The lines of a chart.
pub(super) struct Branches {
    /// Of each element what its lines come from.
    before: Vec<Vec<usize>>,
    kinds: Vec<Kind>,
    /// How often an element has been looked at, all in all: a chart whose branches are in each other without end is read no
    /// further.
    work: usize,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Step,
    Transition,
    /// Lines part or meet there.
    Branch,
    Other,
}

/// No chart has so many lines.
const MOST_WORK: usize = 2_000_000;

impl Branches {
    pub(super) fn of(elements: &[Node<'_, '_>]) -> Branches {
        let mut by_id = HashMap::new();
        for (at, node) in elements.iter().enumerate() {
            if let Some(id) = node.attribute("localId") {
                by_id.entry(id).or_insert(at);
            }
        }
        let before = elements.iter().map(|node| {
            let lines = all(*node, "connectionPointIn").flat_map(|point| all(point, "connection"));
            let from = lines.filter_map(|line| line.attribute("refLocalId"));
            from.filter_map(|id| by_id.get(id).copied()).collect()
        });
        let kinds = elements.iter().map(|node| match node.tag_name().name() {
            "step" | "macroStep" => Kind::Step,
            "transition" => Kind::Transition,
            "selectionDivergence"
            | "selectionConvergence"
            | "simultaneousDivergence"
            | "simultaneousConvergence" => Kind::Branch,
            _ => Kind::Other,
        });
        Branches {
            before: before.collect(),
            kinds: kinds.collect(),
            work: 0,
        }
    }

    /// The steps, or the transitions, from which lines lead to an element, in the order of its lines.
    pub(super) fn before(&mut self, at: usize, kind: &str) -> Vec<usize> {
        let wanted = match kind {
            "step" => Kind::Step,
            _ => Kind::Transition,
        };
        let (mut found, mut seen) = (Vec::new(), HashSet::new());
        let mut open: Vec<usize> = self.before[at].iter().rev().copied().collect();
        while let Some(next) = open.pop() {
            self.work += 1;
            if self.work > MOST_WORK || !seen.insert(next) {
                continue;
            }
            match self.kinds[next] {
                kind if kind == wanted => found.push(next),
                Kind::Branch => open.extend(self.before[next].iter().rev()),
                _ => {}
            }
        }
        found
    }

    /// What the only line of an element comes from.
    pub(super) fn right_before(&self, at: usize) -> Option<usize> {
        match self.before.get(at)?[..] {
            [one] => Some(one),
            _ => None,
        }
    }
}
