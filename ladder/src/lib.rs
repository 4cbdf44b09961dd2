//! From a checked program to a ladder diagram: as text, live in a terminal, and as vector graphics.
//!
//! The way of a program through this crate: `symbols` says what each instruction looks like; `build` makes a
//! tree of each rung's elements; `fork` and `stores` arrange it, `energise` gives every wire its net; `wrap`
//! breaks what is too wide; `layout` makes cells of it. Text, terminals and SVG all show those cells.
//!
//! # Rules
//!
//! Numeric code is one accumulator, acc, and a stack (NC-6, NC-8); a ladder diagram is wires. Power on a wire is
//! acc there, so:
//!
//! - **Contacts and comparisons** stand in series. A load right before a comparison is drawn with it:
//!   `[ A0 >= 500 ]`. Where the source of the value is not known, it is called `V`.
//! - **`40` … `41`** is a path beside all that its rung, or the branch around it, holds so far; with a recall,
//!   beside what stands behind the stored point. Paths of one beginning and one end are one join, however they
//!   were nested.
//! - **`6540` … `41`** is its contents in series. Where they look at what stands before them – an edge, a NOT, a
//!   timer, a recalled point – the two results meet in a box, `[ AND ]`, the second from below. **`8840` …
//!   `41`** always is such a box, `[ XOR ]`.
//! - **A path that begins where no wire leads without crossing another** begins by name: at `•1`, a point of the same
//!   name, or at a left rail of its own, `├`. `•1.2` is point 01 as the rung has stored it the second time.
//!   A point at which nothing begins is named too, so that nothing is lost.
//! - **NOT, edges and `XI`** stand in series and act on all that stands before them in their path.
//! - **Coils, jumps and returns** leave acc as it is. One that is not the last of its rung gets a branch of its
//!   own, one below the other at the right rail; but between other elements of a path it stands in series.
//!   Paths that end a rung and all end in outputs do not come together again.
//! - **A timer** is its box, and behind it the coil that it drives, which is the same step.
//! - **Functions** of numbers stand in series, as boxes in the order in which they are done.
//! - **A rung that is too wide** goes on in another line: `→a`, `a→`. Ends of the same name join.
//!
//! Each step of a program is shown exactly once: as a symbol, as a joint of wires, or at the head of its rung. The
//! power of a wire is found from acc behind the steps of a scan ([`Nets::power`]); it flows to the right, and up
//! and down, never back.

#![forbid(unsafe_code)]

mod address;
mod block;
mod build;
mod drawing;
pub mod edit;
mod element;
mod energise;
mod face;
mod fork;
mod layout;
mod listing;
mod power;
mod stores;
mod svg_page;
mod symbols;
mod tree;
mod value;
mod words;
mod wrap;

pub use address::{Address, Names};
pub use block::Cell;
pub use drawing::{Drawing, NARROWEST, Picture, Style};
pub use element::{Element, Symbol};
pub use listing::{Title, listing};
pub use power::{Net, Nets, Power};
pub use svg_page::{Area, Labels, Paper, Report, Sheet};
pub use svg_page::{to_report, to_screen, to_sheet, to_svg};
pub use words::picture;

use build::Builder;
use power::Feed;
use tree::{Node, Origin, Series, Start};
use unoclp_core::Instruction;
use unoclp_core::isa::{Class, Opcode};

/// A program as rungs of elements.
#[derive(Clone, Debug)]
pub struct Ladder {
    /// The rungs, in order.
    pub rungs: Vec<Rung>,
    /// The symbols of all rungs.
    pub elements: Vec<Element>,
    /// The wires of all rungs.
    pub nets: Nets,
}

/// A rung of a ladder.
#[derive(Clone, Debug)]
pub struct Rung {
    /// Its first step.
    pub first: usize,
    /// How many steps it has.
    pub steps: usize,
    /// The labels at its head.
    pub labels: Vec<u8>,
    /// The ELS or END at its head.
    pub part: Option<Opcode>,
    /// The net of its left rail.
    pub(crate) rail: Net,
    /// The steps that begin it: its code and its labels.
    pub(crate) heads: Vec<usize>,
    pub(crate) series: Series,
}

impl Ladder {
    /// The ladder of a program's steps.
    pub fn new<'c>(steps: impl Iterator<Item = Instruction<'c>>) -> Ladder {
        let steps: Vec<Instruction<'_>> = steps.collect();
        let mut ladder = Ladder::empty();
        let mut timers = 0;
        let mut first = 0;
        while first < steps.len() {
            let rest = &steps[first..];
            let ends = |pair: &[Instruction<'_>]| ends_between(pair[0], pair[1]);
            let count = rest
                .windows(2)
                .position(ends)
                .map_or(rest.len(), |at| at + 1);
            ladder.rung(first, &steps[first..first + count], &mut timers);
            first += count;
        }
        ladder
    }

    /// A ladder without rungs.
    pub(crate) fn empty() -> Ladder {
        Ladder {
            rungs: Vec::new(),
            elements: Vec::new(),
            nets: Nets::new(),
        }
    }

    /// Adds a rung of these steps, the first of which has this number; `timers` counts the timers so far.
    pub(crate) fn rung(&mut self, first: usize, steps: &[Instruction<'_>], timers: &mut u8) {
        let (mut heads, mut labels) = (Vec::new(), Vec::new());
        let mut part = None;
        let mut rail = Nets::RAIL;
        let mut builder = Builder::new(&mut self.elements);
        for (step, instruction) in (first..).zip(steps) {
            let class = instruction.opcode.class();
            if matches!(class, Class::Rung | Class::Label | Class::Part) {
                if class == Class::Label {
                    labels.extend(instruction.number());
                }
                if class == Class::Part {
                    part = Some(instruction.opcode);
                }
                heads.push(step);
                // A jump comes to a label, and not to the code before it.
                rail = self.nets.add(Feed::Step(step));
            } else {
                *timers = timers.saturating_add(u8::from(class == Class::Timer));
                builder.push(step, *instruction, *timers);
            }
        }
        let series = builder.finish(&mut self.nets, rail);
        self.rungs.push(Rung {
            first,
            steps: steps.len(),
            labels,
            part,
            rail,
            heads,
            series,
        });
    }

    /// The steps that a rung shows: as symbols, as joints of its wires, or at its head.
    pub fn shown(&self, rung: &Rung) -> Vec<usize> {
        let mut shown = rung.heads.clone();
        for node in &rung.series {
            node.visit(&mut |node| match node {
                Node::Element(index) => shown.extend(&self.elements[*index].steps),
                Node::Store(store) => shown.push(store.step),
                Node::Block(_, steps) => shown.extend(steps),
                Node::Join(join) => join.paths.iter().for_each(|path| shown.extend(&path.steps)),
                Node::Fork(_) | Node::Goto(_) => {}
            });
        }
        shown
    }

    /// Draws it.
    pub fn draw(&self, style: &Style<'_>) -> Drawing<'_> {
        Drawing::new(self, style)
    }

    /// What a path begins with that begins elsewhere.
    pub(crate) fn start(&self, start: &Start) -> String {
        match start {
            Start::Here => String::new(),
            Start::Named(name) => name.clone(),
            Start::At(Origin::Rail, _) => "├".to_owned(),
            Start::At(Origin::Store(step), _) => format!("•{}", self.store_name(*step)),
        }
    }

    fn store_name(&self, step: usize) -> String {
        let mut name = String::new();
        let rung = self.rungs.iter().rev().find(|rung| rung.first <= step);
        for node in rung.iter().flat_map(|rung| &rung.series) {
            node.visit(&mut |node| {
                if let Node::Store(store) = node
                    && store.step == step
                {
                    name.clone_from(&store.name);
                }
            });
        }
        name
    }
}

/// Whether a rung ends between these two (NC-8, NC-28).
pub(crate) fn ends_between(one: Instruction<'_>, next: Instruction<'_>) -> bool {
    one.opcode.class() == Class::If || matches!(next.opcode.class(), Class::Rung | Class::Part)
}
