//! From a document to codes, each with what it came from.
//!
//! A series is written from left to right. Where a [`Parallel`] begins, its paths need a value that acc no longer is:
//! at the beginning of a rung, a path or a block that is what this began with; anywhere else a branch point keeps it.

use super::document::{Begin, Block, Document, Gate, Id, Node, Parallel, Path, Rung};
use super::shown;
use super::step::Step;
use unoclp_checked::Work;
use unoclp_core::Instruction;
use unoclp_core::isa::{BRANCH_POINTS, Opcode};

/// What a document says, in the order of a program file, without program start: made once for all who ask what its codes
/// are, what is wrong with them, and what they look like.
pub struct Emitted<'d> {
    pub(crate) document: &'d Document,
    /// The codes, the rungs one after the other.
    pub(crate) codes: Vec<Code<'d>>,
    /// After the last code of each rung.
    pub(crate) ends: Vec<usize>,
    /// Paths on which nothing stands, each with the code that it stands before.
    pub(crate) holes: Vec<(usize, Id)>,
    /// Parallels for which no branch point was left.
    pub(crate) without_point: Vec<Id>,
}

/// A code with its operands.
pub(crate) struct Code<'d> {
    /// What it came from: an element, a parallel or its path, a block, or the rung.
    pub(crate) of: Id,
    pub(crate) what: What<'d>,
    /// The outputs of a drum's steps.
    drum: Vec<u8>,
}

/// What a code says.
#[derive(Clone, Copy)]
pub(crate) enum What<'d> {
    /// An instruction of the document, which may lack something.
    Step(&'d Step),
    /// One that its form asks for; XX where it has one.
    Form(Opcode, Option<u8>),
}

impl Emitted<'_> {
    /// What the document says.
    pub fn of(document: &Document) -> Emitted<'_> {
        Work::note(|work| work.emissions += 1);
        let mut emitted = Emitted {
            document,
            codes: Vec::new(),
            ends: Vec::new(),
            holes: Vec::new(),
            without_point: Vec::new(),
        };
        let mut by_itself = true;
        for rung in document.rungs() {
            emitted.rung(rung, by_itself);
            emitted.ends.push(emitted.codes.len());
            by_itself = rung.ends_in_if();
        }
        emitted
    }

    /// Its instructions, what is missing in them as a drawing shows it.
    pub fn steps(&self) -> impl Iterator<Item = Instruction<'_>> {
        self.codes.iter().map(Code::step)
    }

    /// The document.
    pub fn document(&self) -> &Document {
        self.document
    }

    /// The rungs that have a code, which are those of the program, and their instructions.
    pub fn rungs(&self) -> impl Iterator<Item = (&Rung, impl Iterator<Item = Instruction<'_>>)> {
        let begins = std::iter::once(&0).chain(&self.ends);
        let rungs = self.document.rungs().zip(begins.zip(&self.ends));
        rungs
            .map(|(rung, (&begin, &end))| (rung, &self.codes[begin..end]))
            .filter(|(_, codes)| !codes.is_empty())
            .map(|(rung, codes)| (rung, codes.iter().map(Code::step)))
    }
}

/// What a rung knows of its branch points; bit 0 is point 01.
#[derive(Clone, Copy)]
struct Points {
    /// Those that other nodes of the rung name by their number.
    named: u8,
    /// Those of the parallels around.
    around: u8,
    /// The one that the frame begins with; else it begins at the rail.
    origin: Option<u8>,
}

impl<'d> Emitted<'d> {
    fn rung(&mut self, rung: &'d Rung, by_itself: bool) {
        match rung.begin {
            Begin::Rung if by_itself => {}
            Begin::Rung | Begin::NewRung => self.form(rung.id, Opcode::NewRung, None),
            Begin::Else => self.form(rung.id, Opcode::Else, None),
            Begin::EndIf => self.form(rung.id, Opcode::EndIf, None),
        }
        for &label in &rung.labels {
            self.form(rung.id, Opcode::Label, Some(label));
        }
        let points = Points {
            named: named(&rung.series),
            around: 0,
            origin: None,
        };
        self.series(&rung.series, points);
    }

    fn series(&mut self, series: &'d [Node], points: Points) {
        for (index, node) in series.iter().enumerate() {
            match node {
                Node::Element(element) => {
                    for step in element.load.iter().chain([&element.step]) {
                        self.codes.push(Code {
                            of: element.id,
                            what: What::Step(step),
                            drum: shown::drum(step),
                        });
                    }
                }
                Node::Store(store) => self.form(store.id, Opcode::StoreBranch, Some(store.point)),
                Node::Parallel(parallel) => self.parallel(parallel, points, index == 0),
                Node::Block(block) => self.block(block, points),
            }
        }
    }

    fn path(&mut self, path: &'d Path, points: Points) {
        if path.series.is_empty() {
            self.holes.push((self.codes.len(), path.id));
        }
        self.series(&path.series, points);
    }

    fn parallel(&mut self, parallel: &'d Parallel, mut points: Points, is_first: bool) {
        if !is_first || parallel.point.is_some() {
            let point = self.point(parallel, points);
            self.form(parallel.id, Opcode::StoreBranch, Some(point));
            points.around |= bit(point);
            points.origin = Some(point);
        }
        for (index, path) in parallel.paths.iter().enumerate() {
            if index > 0 {
                self.open(path.id, Opcode::OpenBranch, points.origin);
            }
            self.path(path, points);
            if index > 0 {
                self.form(path.id, Opcode::CloseBranch, None);
            }
        }
    }

    fn block(&mut self, block: &'d Block, points: Points) {
        let open = match block.gate {
            Gate::Or => Opcode::OpenBranch,
            Gate::And => Opcode::OpenAnd,
            Gate::Xor => Opcode::OpenXor,
        };
        self.open(block.id, open, block.recall);
        let origin = block.recall;
        self.path(&block.path, Points { origin, ..points });
        self.form(block.id, Opcode::CloseBranch, None);
    }

    fn open(&mut self, of: Id, open: Opcode, recall: Option<u8>) {
        self.form(of, open, None);
        if recall.is_some() {
            self.form(of, Opcode::RecallBranch, recall);
        }
    }

    /// The branch point of a parallel: its own, or the lowest that nothing around it or within it has use for.
    fn point(&mut self, parallel: &Parallel, points: Points) -> u8 {
        if let Some(own) = parallel.point.filter(|&own| points.around & bit(own) == 0) {
            return own;
        }
        let mut taken = points.around | points.named;
        for path in &parallel.paths {
            super::document::visit(&path.series, &mut |node| {
                if let Node::Parallel(Parallel {
                    point: Some(own), ..
                }) = node
                {
                    taken |= bit(*own);
                }
            });
        }
        let free = (1..=BRANCH_POINTS).find(|&point| taken & bit(point) == 0);
        free.unwrap_or_else(|| {
            self.without_point.push(parallel.id);
            BRANCH_POINTS
        })
    }

    fn form(&mut self, of: Id, opcode: Opcode, number: Option<u8>) {
        self.codes.push(Code {
            of,
            what: What::Form(opcode, number),
            drum: Vec::new(),
        });
    }
}

/// The branch points that nodes name by their number, other than parallels their own.
fn named(series: &[Node]) -> u8 {
    let mut named = 0;
    super::document::visit(series, &mut |node| match node {
        Node::Store(store) => named |= bit(store.point),
        Node::Block(block) => named |= block.recall.map_or(0, bit),
        _ => {}
    });
    named
}

/// The bit of a branch point.
fn bit(point: u8) -> u8 {
    1u8.checked_shl(u32::from(point).wrapping_sub(1))
        .unwrap_or(0)
}

impl Code<'_> {
    /// The instruction that it is, what is missing in it as a drawing shows it.
    pub(crate) fn step(&self) -> Instruction<'_> {
        match self.what {
            What::Step(step) => shown::instruction(step, &self.drum),
            What::Form(opcode, number) => shown::form(opcode, number),
        }
    }
}

impl What<'_> {
    /// The lines of a program file that say it; none where something is missing.
    pub(crate) fn codes(&self) -> Option<Vec<i32>> {
        match self {
            What::Step(step) => step.codes().map(Iterator::collect),
            What::Form(opcode, number) => {
                let row = opcode.row();
                Some(vec![row.code + i32::from(number.unwrap_or(0))])
            }
        }
    }
}
