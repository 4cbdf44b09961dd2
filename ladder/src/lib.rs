//! From a checked program to a ladder diagram: as text, live in a terminal, and as vector graphics.
//!
//! # Rules
//!
//! TODO

#![forbid(unsafe_code)]

mod address;
mod block;
mod build;
mod drawing;
mod element;
mod face;
mod layout;
mod listing;
mod power;
mod source;
mod svg_page;
mod tree;
mod wrap;

pub use address::{Address, Names};
pub use block::Cell;
pub use drawing::{Drawing, NARROWEST, Picture, Style};
pub use element::{Element, Symbol};
pub use listing::listing;
pub use power::{Net, Nets, Power};
pub use source::{Place, Source};
pub use svg_page::to_svg;

use build::Builder;
use power::Feed;
use tree::{Node, Origin, Series, Start};
use unoclp_core::isa::Opcode;
use unoclp_core::{Delay, Instruction};

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
        let mut ladder = Ladder {
            rungs: Vec::new(),
            elements: Vec::new(),
            nets: Nets::new(),
        };
        let mut timers = 0;
        let mut first = 0;
        while first < steps.len() {
            let begins = |step: &Instruction<'_>| step.opcode == Opcode::NewRung;
            let behind = &steps[first + 1..];
            let count = 1 + behind.iter().position(begins).unwrap_or(behind.len());
            ladder.rung(first, &steps[first..first + count], &mut timers);
            first += count;
        }
        ladder
    }

    fn rung(&mut self, first: usize, steps: &[Instruction<'_>], timers: &mut u8) {
        let (mut heads, mut labels) = (Vec::new(), Vec::new());
        let mut rail = Nets::RAIL;
        let mut builder = Builder::new(&mut self.elements);
        for (step, instruction) in (first..).zip(steps) {
            match instruction.opcode {
                Opcode::NewRung | Opcode::Label => {
                    if instruction.opcode == Opcode::Label {
                        labels.extend(instruction.number());
                    }
                    heads.push(step);
                    // A jump comes to a label, and not to the code before it.
                    rail = self.nets.add(Feed::Step(step));
                }
                opcode => {
                    *timers += u8::from(Delay::of(opcode).is_some());
                    builder.push(step, *instruction, *timers);
                }
            }
        }
        let series = builder.finish(&mut self.nets, rail);
        self.rungs.push(Rung {
            first,
            steps: steps.len(),
            labels,
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
