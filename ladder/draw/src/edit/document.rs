//! A program as a person edits it: rungs of elements in series and in parallel.

use super::step::Step;
use super::table::Table;
use std::sync::Arc;
use unoclp_core::isa::Opcode;

pub use crate::tree::Gate;

/// What everything in a document is known by: a rung, an element, a path. It stays the same as long as the thing is
/// there, and no other thing of the document ever gets it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Id(pub u32);

/// A program as a person edits it. Copies share what they have in common.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Document {
    pub(crate) rungs: Arc<Vec<Arc<Rung>>>,
    pub(crate) table: Arc<Table>,
    pub(crate) title: Arc<[String]>,
    pub(crate) next: u32,
}

/// A rung.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rung {
    /// What it is known by.
    pub id: Id,
    /// What it is about, line by line.
    pub comment: Vec<String>,
    /// The code that it begins with.
    pub begin: Begin,
    /// The labels at its head.
    pub labels: Vec<u8>,
    /// What stands between its rails.
    pub series: Series,
}

/// The code that a rung begins with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Begin {
    /// `NL`, but not where a rung begins by itself: after program start and after an IF.
    #[default]
    Rung,
    /// `NL` even there.
    NewRung,
    /// `ELS`.
    Else,
    /// `END`.
    EndIf,
}

/// What stands in series, from left to right.
pub type Series = Vec<Node>;

/// A piece of a series.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Node {
    /// A contact, a coil, a box.
    Element(Element),
    /// A named point of the wire.
    Store(Store),
    /// Paths beside each other, all from where it begins.
    Parallel(Parallel),
    /// A result of its own that meets the one before it.
    Block(Block),
}

/// A contact, a coil, a box: whatever is no wire.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element {
    /// What it is known by.
    pub id: Id,
    /// The load of what a comparison looks at, drawn as one with it.
    pub load: Option<Step>,
    /// What it does.
    pub step: Step,
}

/// A branch point that something else than a parallel of wires asks for by its number: `4041XX`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Store {
    /// What it is known by.
    pub id: Id,
    /// Its number.
    pub point: u8,
}

/// Paths that begin and end together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parallel {
    /// What it is known by.
    pub id: Id,
    /// The branch point where they begin, if it was given a number; else it gets one where it needs one.
    pub point: Option<u8>,
    /// At least two.
    pub paths: Vec<Path>,
}

/// A series with a name of its own, so that it can be pointed at where it is empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Path {
    /// What it is known by.
    pub id: Id,
    /// What is on it.
    pub series: Series,
}

/// `40`, `6540` or `8840` to `41`: its result meets all that stands before it in its rung, path or block. Of OR those
/// that are no [`Parallel`], because they begin elsewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// What it is known by.
    pub id: Id,
    /// How the two results meet.
    pub gate: Gate,
    /// The number of the branch point that it begins at; else it begins at the left rail.
    pub recall: Option<u8>,
    /// What it holds.
    pub path: Path,
}

impl Document {
    /// A document of one empty rung.
    pub fn new() -> Document {
        let mut document = Document::empty();
        let rung = Rung::new(document.fresh());
        document.rungs = Arc::new(vec![Arc::new(rung)]);
        document
    }

    /// A document without rungs.
    pub(crate) fn empty() -> Document {
        Document {
            rungs: Arc::default(),
            table: Arc::default(),
            title: Arc::new([]),
            next: 0,
        }
    }

    /// Its rungs, from top to bottom.
    pub fn rungs(&self) -> impl ExactSizeIterator<Item = &Rung> + DoubleEndedIterator {
        self.rungs.iter().map(|rung| &**rung)
    }

    /// What the points are called.
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// What the program is about, line by line.
    pub fn title(&self) -> &[String] {
        &self.title
    }

    /// Its timers, in the order of their numbers.
    pub fn timers(&self) -> Vec<Id> {
        let mut timers = Vec::new();
        for rung in self.rungs() {
            visit(&rung.series, &mut |node| match node {
                Node::Element(element) if element.step.is_own_timer() => {
                    timers.push(element.id);
                }
                _ => {}
            });
        }
        timers
    }

    /// The place of a rung among the others.
    pub fn position(&self, rung: Id) -> Option<usize> {
        self.rungs.iter().position(|other| other.id == rung)
    }

    /// The rung that this names, or that holds what it names.
    pub fn rung_of(&self, id: Id) -> Option<usize> {
        let names = |rung: &Arc<Rung>| rung.id == id || holds(&rung.series, id);
        self.rungs.iter().position(names)
    }

    /// The element that is known by this.
    pub fn element(&self, id: Id) -> Option<&Element> {
        self.rungs.iter().find_map(|rung| {
            let mut found = None;
            visit(&rung.series, &mut |node| match node {
                Node::Element(element) if element.id == id => found = Some(element),
                _ => {}
            });
            found
        })
    }

    /// Whether another document has the same rungs, names and title.
    pub(crate) fn says_the_same(&self, other: &Document) -> bool {
        self.rungs == other.rungs && self.table == other.table && self.title == other.title
    }

    /// What nothing else is known by.
    pub(crate) fn fresh(&mut self) -> Id {
        self.next += 1;
        Id(self.next)
    }

    /// The rung at this place, to be changed; copies of the document keep theirs.
    pub(crate) fn rung_mut(&mut self, at: usize) -> Option<&mut Rung> {
        Arc::make_mut(&mut self.rungs)
            .get_mut(at)
            .map(Arc::make_mut)
    }

    /// All rungs, to be put in another order.
    pub(crate) fn rungs_mut(&mut self) -> &mut Vec<Arc<Rung>> {
        Arc::make_mut(&mut self.rungs)
    }
}

impl Default for Document {
    fn default() -> Document {
        Document::new()
    }
}

impl Rung {
    /// An empty rung.
    pub(crate) fn new(id: Id) -> Rung {
        Rung {
            id,
            comment: Vec::new(),
            begin: Begin::Rung,
            labels: Vec::new(),
            series: Series::new(),
        }
    }

    /// Whether its last code is an IF, after which a rung begins by itself.
    pub fn ends_in_if(&self) -> bool {
        self.last_if().is_some()
    }

    /// The IF that it ends in.
    pub(crate) fn last_if(&self) -> Option<Id> {
        match self.series.last() {
            Some(Node::Element(last)) if last.step.opcode() == Opcode::If => Some(last.id),
            _ => None,
        }
    }
}

impl Node {
    /// What it is known by.
    pub fn id(&self) -> Id {
        match self {
            Node::Element(element) => element.id,
            Node::Store(store) => store.id,
            Node::Parallel(parallel) => parallel.id,
            Node::Block(block) => block.id,
        }
    }

    /// The paths within it.
    pub fn paths(&self) -> &[Path] {
        match self {
            Node::Element(_) | Node::Store(_) => &[],
            Node::Parallel(parallel) => &parallel.paths,
            Node::Block(block) => std::slice::from_ref(&block.path),
        }
    }

    /// The paths within it, to be changed.
    pub(crate) fn paths_mut(&mut self) -> &mut [Path] {
        match self {
            Node::Element(_) | Node::Store(_) => &mut [],
            Node::Parallel(parallel) => &mut parallel.paths,
            Node::Block(block) => std::slice::from_mut(&mut block.path),
        }
    }
}

/// Calls back for each node of a series, each before what it holds.
pub fn visit<'s>(series: &'s [Node], to: &mut impl FnMut(&'s Node)) {
    for node in series {
        to(node);
        node.paths().iter().for_each(|path| visit(&path.series, to));
    }
}

/// Likewise, to change them.
pub(crate) fn visit_mut(series: &mut [Node], to: &mut impl FnMut(&mut Node)) {
    for node in series {
        to(node);
        let paths = node.paths_mut().iter_mut();
        paths.for_each(|path| visit_mut(&mut path.series, to));
    }
}

/// Whether a node or a path of this series is known by this.
pub(crate) fn holds(series: &[Node], id: Id) -> bool {
    let mut holds = false;
    visit(series, &mut |node| {
        holds |= node.id() == id || node.paths().iter().any(|path| path.id == id);
    });
    holds
}

/// How deep paths stand in paths.
pub(crate) fn depth(series: &[Node]) -> usize {
    let paths = series.iter().flat_map(Node::paths);
    let deepest = paths.map(|path| 1 + depth(&path.series)).max();
    deepest.unwrap_or(0)
}
