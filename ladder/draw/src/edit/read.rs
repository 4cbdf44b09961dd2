//! From codes to a document.
//!
//! A frame is what one run of acc gathers: a rung, or an open branch or block. Where a branch begins at the same place
//! as what stands before it, both are paths of a [`Parallel`]; else it stays a [`Block`]. Written out again in the
//! order of the tree, each gives the codes it was made of.

use super::document::{
    Begin, Block, Document, Element, Gate, Id, Node, Parallel, Path, Rung, Series, Store,
};
use super::emit::Emitted;
use super::step::Step;
use super::table::{Row, Table};
use crate::Names;
use crate::ladder::ends_between;
use std::sync::Arc;
use unoclp_checked::SourceMap;
use unoclp_core::Instruction;
use unoclp_core::isa::{Class, Opcode};
use unoclp_point::Address;

impl Document {
    /// The document of a program's steps.
    pub fn of_steps<'c>(steps: impl IntoIterator<Item = Instruction<'c>>) -> Document {
        let mut reader = Reader {
            document: Document::empty(),
            before: None,
            frames: Vec::new(),
            latest: [None; 8],
        };
        let mut rungs: Vec<Arc<Rung>> = Vec::new();
        let mut rung: Option<Rung> = None;
        for step in steps {
            if reader
                .before
                .is_some_and(|before| ends_between(before, step))
                && let Some(done) = rung.take()
            {
                rungs.push(Arc::new(reader.finish(done)));
            }
            let mut now = rung.unwrap_or_else(|| reader.begin());
            reader.take(&mut now, step, rungs.last().map(|rung| &**rung));
            rung = Some(now);
            reader.before = Some(step);
        }
        if let Some(done) = rung {
            rungs.push(Arc::new(reader.finish(done)));
        }
        let mut document = reader.document;
        document.rungs = Arc::new(rungs);
        document
    }

    /// It with what the text of its program says: the title, and what each rung is about. The map is that of the
    /// steps that the document was made of.
    #[must_use]
    pub fn with_text(mut self, map: &SourceMap) -> Document {
        self.title = map.title.clone().into();
        let mut first = 0;
        let ends = Emitted::of(&self).ends;
        for (index, end) in ends.into_iter().enumerate() {
            if end > first
                && let Some(rung) = self.rung_mut(index)
            {
                rung.comment = map.about(first).map(str::to_owned).collect();
            }
            first = end;
        }
        self
    }

    /// It with this title, line by line.
    #[must_use]
    pub fn with_title(mut self, title: Vec<String>) -> Document {
        self.title = title.into();
        self
    }

    /// It with these rows in its symbol table, besides those that it has for other points.
    #[must_use]
    pub fn with_rows(mut self, rows: impl IntoIterator<Item = (Address, Row)>) -> Document {
        let table = Arc::make_mut(&mut self.table);
        rows.into_iter()
            .for_each(|(point, row)| table.set(point, row));
        self
    }

    /// It with these names.
    #[must_use]
    pub fn with_names(mut self, names: Names) -> Document {
        self.table = Arc::new(Table::of(names));
        self
    }
}

/// Where the power of a frame comes from.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Origin {
    Rail,
    /// What this node has stored.
    Store(Id),
}

struct Frame {
    gate: Gate,
    origin: Origin,
    recall: Option<u8>,
    series: Series,
}

struct Reader<'c> {
    document: Document,
    /// The step before.
    before: Option<Instruction<'c>>,
    /// The rung, then the branches that are open.
    frames: Vec<Frame>,
    /// Which node has stored each branch point last.
    latest: [Option<Id>; 8],
}

impl Frame {
    fn new(gate: Gate) -> Frame {
        Frame {
            gate,
            origin: Origin::Rail,
            recall: None,
            series: Series::new(),
        }
    }
}

impl<'c> Reader<'c> {
    fn begin(&mut self) -> Rung {
        self.frames = vec![Frame::new(Gate::Or)];
        self.latest = [None; 8];
        Rung::new(self.document.fresh())
    }

    fn finish(&mut self, mut rung: Rung) -> Rung {
        while self.frames.len() > 1 {
            self.close();
        }
        rung.series = std::mem::take(&mut self.frames).swap_remove(0).series;
        rung
    }

    fn take(&mut self, rung: &mut Rung, step: Instruction<'c>, above: Option<&Rung>) {
        let number = step.number().unwrap_or(0);
        match step.opcode.class() {
            Class::Rung => {
                let by_itself = above.is_none_or(Rung::ends_in_if);
                rung.begin = if by_itself {
                    Begin::NewRung
                } else {
                    Begin::Rung
                };
            }
            Class::Part if step.opcode == Opcode::Else => rung.begin = Begin::Else,
            Class::Part => rung.begin = Begin::EndIf,
            Class::Label if self.top().series.is_empty() => rung.labels.push(number),
            Class::OpenOr => self.frames.push(Frame::new(Gate::Or)),
            Class::OpenAnd => self.frames.push(Frame::new(Gate::And)),
            Class::OpenXor => self.frames.push(Frame::new(Gate::Xor)),
            Class::Close => self.close(),
            Class::RecallPoint => {
                let store = self.latest(number).and_then(|latest| *latest);
                let frame = self.top();
                frame.recall = Some(number);
                if let Some(store) = store {
                    frame.origin = Origin::Store(store);
                }
            }
            Class::StorePoint => {
                let id = self.document.fresh();
                if let Some(latest) = self.latest(number) {
                    *latest = Some(id);
                }
                let store = Store { id, point: number };
                self.top().series.push(Node::Store(store));
            }
            Class::Comparison | Class::ValueContact => {
                let load = match self.top().series.pop_if(|last| is_load(last)) {
                    Some(Node::Element(load)) => Some(load.step),
                    _ => None,
                };
                self.element(load, step);
            }
            _ => self.element(None, step),
        }
    }

    fn element(&mut self, load: Option<Step>, step: Instruction<'_>) {
        let id = self.document.fresh();
        let step = Step::of(step);
        self.top()
            .series
            .push(Node::Element(Element { id, load, step }));
    }

    fn latest(&mut self, point: u8) -> Option<&mut Option<Id>> {
        self.latest.get_mut(usize::from(point).wrapping_sub(1))
    }

    /// The innermost frame; the loader has seen to it that the rung's own is never closed.
    fn top(&mut self) -> &mut Frame {
        if self.frames.is_empty() {
            self.frames.push(Frame::new(Gate::Or));
        }
        let last = self.frames.len() - 1;
        &mut self.frames[last]
    }

    fn close(&mut self) {
        if self.frames.len() < 2 {
            return;
        }
        let Some(inner) = self.frames.pop() else {
            return;
        };
        let path = Path {
            id: self.document.fresh(),
            series: inner.series,
        };
        if inner.gate == Gate::Or
            && let Some(from) = place(self.top(), inner.origin)
        {
            return self.beside(from, path);
        }
        let id = self.document.fresh();
        let (gate, recall) = (inner.gate, inner.recall);
        self.top().series.push(Node::Block(Block {
            id,
            gate,
            recall,
            path,
        }));
    }

    /// Puts a path beside all that stands from here on, which begins where the path does.
    fn beside(&mut self, from: Place, path: Path) {
        let (fresh, first) = (self.document.fresh(), self.document.fresh());
        let series = &mut self.top().series;
        let mut before = match from {
            Place::Head => std::mem::take(series),
            Place::At(index) => series.split_off(index),
        };
        let (mut id, mut point) = (fresh, None);
        match (from, &mut before[..]) {
            // What stands there are such paths, and no more.
            (Place::Head, [Node::Parallel(parallel)]) if parallel.point.is_none() => {
                parallel.paths.push(path);
                return series.append(&mut before);
            }
            (Place::At(_), [Node::Parallel(parallel)]) => {
                parallel.paths.push(path);
                return series.append(&mut before);
            }
            // They end before this path does: the outer one is now known by where both begin.
            (Place::At(_), [Node::Parallel(parallel), ..]) => {
                id = std::mem::replace(&mut parallel.id, fresh);
                point = parallel.point.take();
            }
            (Place::At(_), [Node::Store(store), ..]) => {
                (id, point) = (store.id, Some(store.point));
                before.remove(0);
            }
            _ => {}
        }
        let first = Path {
            id: first,
            series: before,
        };
        let paths = vec![first, path];
        series.push(Node::Parallel(Parallel { id, point, paths }));
    }
}

/// Where in a frame a path branches off.
#[derive(Clone, Copy)]
enum Place {
    /// Where the frame begins.
    Head,
    /// At this node, which is what the path begins with.
    At(usize),
}

/// Where in a frame a path from this origin branches off, if it does.
fn place(frame: &Frame, origin: Origin) -> Option<Place> {
    let Origin::Store(id) = origin else {
        return (frame.origin == Origin::Rail).then_some(Place::Head);
    };
    let stores = |node: &Node| match node {
        Node::Store(store) => store.id == id,
        Node::Parallel(parallel) => parallel.id == id,
        _ => false,
    };
    let head = (frame.origin == origin).then_some(Place::Head);
    head.or_else(|| frame.series.iter().position(stores).map(Place::At))
}

/// Whether this is a load and nothing else.
fn is_load(node: &Node) -> bool {
    matches!(node, Node::Element(element) if element.step.class() == Class::Load)
}
