//! What is selected: a run of nodes of one series, a path, or whole rungs.

use super::document::{Document, Id, Node, Rung, Series, visit};
use super::refusal::Refusal;
use std::ops::RangeInclusive;

/// What is selected, from one thing to another: both nodes of one series, or both rungs. A path alone is its beginning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Cursor {
    /// The first, or the last.
    pub from: Id,
    /// The other, or the same.
    pub to: Id,
}

impl Cursor {
    /// One thing.
    pub fn at(id: Id) -> Cursor {
        Cursor { from: id, to: id }
    }
}

/// What a cursor selects.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Selected {
    /// These rungs.
    Rungs(RangeInclusive<usize>),
    /// The path with this name, in this rung.
    Path { rung: usize, path: Id },
    /// These nodes of a series.
    Run(Run),
}

/// Nodes of a series.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    /// The place of their rung.
    pub(crate) rung: usize,
    /// What their series is known by: a path or the rung.
    pub(crate) series: Id,
    pub(crate) nodes: RangeInclusive<usize>,
}

impl Document {
    /// All that this cursor selects, and what that holds; nothing where it is not in the document.
    pub fn within(&self, cursor: Cursor) -> Vec<Id> {
        match self.selected(cursor) {
            Err(_) => Vec::new(),
            Ok(Selected::Path { path, .. }) => vec![path],
            Ok(Selected::Rungs(rungs)) => self.rungs[rungs].iter().map(|rung| rung.id).collect(),
            Ok(Selected::Run(run)) => {
                let series = self.rungs[run.rung].series(run.series);
                let nodes = series.and_then(|series| series.get(run.nodes));
                let mut all = Vec::new();
                visit(nodes.unwrap_or_default(), &mut |node| {
                    all.push(node.id());
                    all.extend(node.paths().iter().map(|path| path.id));
                });
                all
            }
        }
    }

    /// What stands around a node or a path: the branch or block, or the rung; none around a rung.
    pub fn around(&self, id: Id) -> Option<Id> {
        let rung = &self.rungs[self.rung_of(id)?];
        let series = match rung.place(id) {
            Some((series, _)) => series,
            None => id,
        };
        match rung.id {
            own if own == id => None,
            own if own == series => Some(own),
            _ => rung.owner(series),
        }
    }

    /// What this cursor selects.
    pub(crate) fn selected(&self, cursor: Cursor) -> Result<Selected, Refusal> {
        let rung = self.rung_of(cursor.from).ok_or(Refusal::NotThere)?;
        if self.rungs[rung].id == cursor.from {
            let to = self.position(cursor.to).ok_or(Refusal::NotOneSeries)?;
            return Ok(Selected::Rungs(rung.min(to)..=rung.max(to)));
        }
        let Some((series, from)) = self.rungs[rung].place(cursor.from) else {
            let path = cursor.from;
            return match cursor.to == path {
                true => Ok(Selected::Path { rung, path }),
                false => Err(Refusal::NotOneSeries),
            };
        };
        let to = self.rungs[rung].place(cursor.to);
        let (other, to) = to.ok_or(Refusal::NotOneSeries)?;
        if other != series {
            return Err(Refusal::NotOneSeries);
        }
        let nodes = from.min(to)..=from.max(to);
        Ok(Selected::Run(Run {
            rung,
            series,
            nodes,
        }))
    }

    /// The nodes that this cursor selects.
    pub(crate) fn run(&self, cursor: Cursor) -> Result<Run, Refusal> {
        match self.selected(cursor)? {
            Selected::Run(run) => Ok(run),
            Selected::Path { .. } | Selected::Rungs(_) => Err(Refusal::SelectElements),
        }
    }

    /// The rungs that this cursor selects, or stands in.
    pub(crate) fn selected_rungs(&self, cursor: Cursor) -> Result<RangeInclusive<usize>, Refusal> {
        Ok(match self.selected(cursor)? {
            Selected::Rungs(rungs) => rungs,
            Selected::Path { rung, .. } | Selected::Run(Run { rung, .. }) => rung..=rung,
        })
    }

    /// The series that is known by this, in the rung at this place.
    pub(crate) fn series_mut(&mut self, rung: usize, id: Id) -> Result<&mut Series, Refusal> {
        let rung = self.rung_mut(rung).ok_or(Refusal::NotThere)?;
        match rung.id == id {
            true => Some(&mut rung.series),
            false => path_mut(&mut rung.series, id),
        }
        .ok_or(Refusal::NotThere)
    }
}

impl Rung {
    /// The series that a node stands in, by what that is known by, and its place there.
    pub(crate) fn place(&self, node: Id) -> Option<(Id, usize)> {
        place(self.id, &self.series, node)
    }

    /// The series that is known by this.
    pub(crate) fn series(&self, id: Id) -> Option<&Series> {
        match self.id == id {
            true => Some(&self.series),
            false => path(&self.series, id),
        }
    }

    /// The node that a path belongs to.
    pub(crate) fn owner(&self, path: Id) -> Option<Id> {
        owner(&self.series, path)
    }
}

fn place(of: Id, series: &Series, node: Id) -> Option<(Id, usize)> {
    if let Some(index) = series.iter().position(|other| other.id() == node) {
        return Some((of, index));
    }
    let mut paths = series.iter().flat_map(Node::paths);
    paths.find_map(|path| place(path.id, &path.series, node))
}

fn path(series: &Series, id: Id) -> Option<&Series> {
    let mut paths = series.iter().flat_map(Node::paths);
    paths.find_map(|inner| match inner.id == id {
        true => Some(&inner.series),
        false => path(&inner.series, id),
    })
}

fn path_mut(series: &mut Series, id: Id) -> Option<&mut Series> {
    let mut paths = series.iter_mut().flat_map(Node::paths_mut);
    paths.find_map(|inner| match inner.id == id {
        true => Some(&mut inner.series),
        false => path_mut(&mut inner.series, id),
    })
}

fn owner(series: &Series, path: Id) -> Option<Id> {
    series.iter().find_map(|node| {
        let own = node.paths().iter().any(|inner| inner.id == path);
        let deeper = || {
            node.paths()
                .iter()
                .find_map(|inner| owner(&inner.series, path))
        };
        own.then(|| node.id()).or_else(deeper)
    })
}
