//! What was copied, to be inserted again under names of its own.

use super::document::{Document, Id, Node, Rung, Series, visit, visit_mut};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What was copied.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Clip {
    pub(crate) what: Copied,
    /// The timers of the document as it was, in the order of their numbers.
    pub(crate) timers: Vec<Id>,
}

/// Nodes of one series, or rungs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Copied {
    Nodes(Series),
    Rungs(Vec<Arc<Rung>>),
}

/// Which timer of a copy a number means: those in the copy are known by other names now.
pub(crate) struct Renamed {
    timers: Vec<Id>,
    ids: BTreeMap<Id, Id>,
}

impl Renamed {
    /// The timer that a number of the copy means.
    pub(crate) fn timer(&self, number: u8) -> Option<Id> {
        let timer = self.timers.get(usize::from(number).checked_sub(1)?)?;
        Some(self.ids.get(timer).copied().unwrap_or(*timer))
    }
}

impl Clip {
    /// A copy of this, which stands in this document.
    pub(crate) fn of(document: &Document, what: Copied) -> Clip {
        let timers = document.timers();
        Clip { what, timers }
    }

    /// It under new names.
    pub(crate) fn renamed(&self, document: &mut Document) -> (Copied, Renamed) {
        let mut renamed = Renamed {
            timers: self.timers.clone(),
            ids: BTreeMap::new(),
        };
        let what = match &self.what {
            Copied::Nodes(nodes) => {
                let mut nodes = nodes.clone();
                rename(&mut nodes, document, &mut renamed.ids);
                loosen(&mut nodes);
                Copied::Nodes(nodes)
            }
            Copied::Rungs(rungs) => {
                let rungs = rungs.iter().map(|rung| {
                    let mut rung = Rung::clone(rung);
                    rung.id = document.fresh();
                    rename(&mut rung.series, document, &mut renamed.ids);
                    Arc::new(rung)
                });
                Copied::Rungs(rungs.collect())
            }
        };
        (what, renamed)
    }
}

fn rename(series: &mut Series, document: &mut Document, ids: &mut BTreeMap<Id, Id>) {
    visit_mut(series, &mut |node| {
        for path in node.paths_mut() {
            path.id = document.fresh();
        }
        let id = match node {
            Node::Element(element) => &mut element.id,
            Node::Store(store) => &mut store.id,
            Node::Parallel(parallel) => &mut parallel.id,
            Node::Block(block) => &mut block.id,
        };
        let fresh = document.fresh();
        ids.insert(*id, fresh);
        *id = fresh;
    });
}

/// Lets parallels find other branch points, since they come to stand among others; but for points that blocks among
/// them name.
pub(crate) fn loosen(series: &mut Series) {
    let mut named = Vec::new();
    visit(series, &mut |node| {
        if let Node::Block(block) = node {
            named.extend(block.recall);
        }
    });
    visit_mut(series, &mut |node| {
        if let Node::Parallel(parallel) = node {
            parallel.point = parallel.point.filter(|point| named.contains(point));
        }
    });
}
