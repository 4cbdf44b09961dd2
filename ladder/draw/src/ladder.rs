//! A program as rungs of elements.

use crate::Element;
use crate::build::Builder;
use crate::power::{Feed, Net, Nets};
use crate::tree::{Node, Origin, Series, Start};
use std::ops::Range;
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
    /// The nets before its own, without that of the left rail.
    pub nets: u32,
    /// Its elements, by their place among all.
    pub(crate) elements: Range<usize>,
    /// The timers before it, and with its own.
    pub(crate) timers: Range<u8>,
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
        let (nets, elements, timer) = (self.nets.own(), self.elements.len(), *timers);
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
                *timers = timers.saturating_add(u8::from(instruction.is_own_timer()));
                builder.push(step, *instruction, *timers);
            }
        }
        let series = builder.finish(&mut self.nets, rail);
        self.rungs.push(Rung {
            first,
            steps: steps.len(),
            labels,
            part,
            nets,
            elements: elements..self.elements.len(),
            timers: timer..*timers,
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

impl Rung {
    /// The number of a net among the rung's own, from 1; that of the left rail is 0 in all of them.
    pub(crate) fn net(&self, net: Net) -> u32 {
        net.number().saturating_sub(self.nets)
    }
}

/// Whether a rung ends between these two (NC-8, NC-28).
pub(crate) fn ends_between(one: Instruction<'_>, next: Instruction<'_>) -> bool {
    one.opcode.class() == Class::If || matches!(next.opcode.class(), Class::Rung | Class::Part)
}
