//! A rung as a tree of elements in series and paths in parallel.

use crate::power::{Net, Nets};

/// What stands in series, from left to right.
pub(crate) type Series = Vec<Node>;

/// A piece of a series.
#[derive(Clone, Debug)]
pub(crate) enum Node {
    /// A symbol: the index of an [`Element`](crate::Element).
    Element(usize),
    /// A point of the wire that paths may begin at.
    Store(Store),
    /// An AND block, which is its contents in series; and the steps that open and close it.
    Block(Series, Vec<usize>),
    /// Paths that come together again.
    Join(Join),
    /// Branches that each end on their own; always the last of a series.
    Fork(Vec<Series>),
    /// The end of a line: the wire goes on wherever this name is.
    Goto(String),
}

/// A stored result: `4041XX` that stores.
#[derive(Clone, Debug)]
pub(crate) struct Store {
    /// Its step.
    pub(crate) step: usize,
    /// What it is called where it must be named: XX, and a count where the rung stores XX again.
    pub(crate) name: String,
    /// Whether the name is shown, because a path begins there by name, or none begins there at all.
    pub(crate) named: bool,
}

/// How paths come together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Gate {
    /// By wire.
    Or,
    /// In a box, because the second path has a result of its own.
    And,
    /// In a box.
    Xor,
}

/// Paths that come together: of a box two, else two or more.
#[derive(Clone, Debug)]
pub(crate) struct Join {
    pub(crate) gate: Gate,
    pub(crate) paths: Vec<Path>,
    /// The last step of it: acc after it is what a box gives.
    pub(crate) close: usize,
    /// The box.
    pub(crate) element: Option<usize>,
    /// The net after it.
    pub(crate) net: Net,
}

/// One of the paths.
#[derive(Clone, Debug)]
pub(crate) struct Path {
    pub(crate) start: Start,
    pub(crate) series: Series,
    /// The steps that open and close it, and that are drawn as its joints.
    pub(crate) steps: Vec<usize>,
    /// The net at its beginning.
    pub(crate) net: Net,
}

/// Where a path begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Start {
    /// Where the other paths begin too.
    Here,
    /// Somewhere else; the step after which acc tells its power.
    At(Origin, usize),
    /// Where this name is; what is shown of it.
    Named(String),
}

/// Where the power of a path comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// The left rail.
    Rail,
    /// The result that this step has stored.
    Store(usize),
}

impl Path {
    /// A path from where the others begin.
    pub(crate) fn here(series: Series) -> Path {
        Path {
            start: Start::Here,
            series,
            steps: Vec::new(),
            net: Nets::RAIL,
        }
    }
}

impl Join {
    /// A join as a piece of a series.
    pub(crate) fn node(gate: Gate, paths: Vec<Path>, close: usize, element: Option<usize>) -> Node {
        Node::Join(Join {
            gate,
            paths,
            close,
            element,
            net: Nets::RAIL,
        })
    }
}

impl Node {
    /// Whether this is a join by wire.
    pub(crate) fn as_or(&mut self) -> Option<&mut Join> {
        match self {
            Node::Join(join) if join.gate == Gate::Or => Some(join),
            _ => None,
        }
    }

    /// Whether it is drawn at all.
    pub(crate) fn is_visible(&self) -> bool {
        match self {
            Node::Store(store) => store.named,
            Node::Block(series, _) => series.iter().any(Node::is_visible),
            _ => true,
        }
    }

    /// Calls back for each node, itself first.
    pub(crate) fn visit(&self, to: &mut impl FnMut(&Node)) {
        to(self);
        let mut all = |series: &Series| series.iter().for_each(|node| node.visit(to));
        match self {
            Node::Block(series, _) => all(series),
            Node::Join(join) => join.paths.iter().for_each(|path| all(&path.series)),
            Node::Fork(branches) => branches.iter().for_each(all),
            _ => {}
        }
    }
}
