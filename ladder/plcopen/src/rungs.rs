//! Circuits as rungs of a document.

use crate::circuit::{Circuit, Item, Leaf, heads, leaves};
use crate::flow::Flow;
use crate::xml::{first, text};
use std::collections::HashMap;
use unoclp_core::isa::{Class, Opcode};
use unoclp_draw::edit::{self, Begin, Block, Id, Node, Parallel, Path, Rung};
use unoclp_lang::Span;

/// The rungs of all networks, as they are made.
#[derive(Default)]
pub(crate) struct Rungs {
    pub rungs: Vec<Rung>,
    /// Where what an id names is in the file, and in which program.
    pub origins: HashMap<Id, (Span, usize)>,
    /// Which timer an element is, by the order in which they were met.
    pub timers: HashMap<Id, u8>,
    /// Labels that wait for the next rung.
    pub labels: Vec<u8>,
    next: u32,
}

impl Rungs {
    /// Adds the circuits of a network, with the comments and labels drawn above each.
    pub(crate) fn add(
        &mut self,
        flow: &Flow<'_, '_, '_>,
        circuits: &[Circuit],
        title: Option<String>,
    ) {
        let network = flow.network;
        let top = |circuit: &Circuit| {
            let mut top = i64::MAX;
            leaves(circuit, &mut |leaf| {
                let element = network.elements.get(leaf.key.0);
                // A value may stand far from where it is used.
                let element = element.filter(|e| !(network.is_blocks && e.kind == "inVariable"));
                top = element.map_or(top, |element| top.min(element.place.0));
            });
            top
        };
        let tops: Vec<i64> = circuits.iter().map(top).collect();
        let mut notes: Vec<(i64, &str, String)> = Vec::new();
        for element in &network.elements {
            let written = match element.kind {
                "comment" => first(element.node, "content").map(text),
                "label" => element.node.attribute("label").map(str::to_owned),
                _ => None,
            };
            if let Some(written) = written {
                notes.push((element.place.0, element.kind, written));
            }
        }
        notes.sort_by_key(|(place, ..)| *place);
        let from = self.rungs.len();
        for circuit in circuits {
            self.rung(flow, circuit);
        }
        if let Some(title) = title
            && let Some(rung) = self.rungs.get_mut(from)
        {
            rung.comment.push(title);
        }
        for (place, kind, written) in notes {
            let below = tops.iter().position(|top| *top >= place);
            let rung = below.and_then(|at| self.rungs.get_mut(from + at));
            match (kind, flow.labels.get(&written)) {
                ("label", Some(&label)) => match rung {
                    Some(rung) => rung.labels.push(label),
                    None => self.labels.push(label),
                },
                _ => {
                    let lines = written
                        .trim()
                        .lines()
                        .map(|line| line.trim_end().to_owned());
                    let rung = match rung {
                        Some(rung) => Some(rung),
                        None => self.rungs.last_mut(),
                    };
                    if let Some(rung) = rung {
                        rung.comment.extend(lines);
                    }
                }
            }
        }
    }

    /// An empty rung of these labels, where some are left at the end.
    pub(crate) fn finish(&mut self) {
        if self.labels.is_empty() && !self.rungs.is_empty() {
            return;
        }
        let id = self.fresh();
        let labels = std::mem::take(&mut self.labels);
        self.rungs.push(rung(id, labels));
    }

    /// Puts a rung before all others.
    pub(crate) fn first(&mut self, leaf: &Leaf, at: Span) {
        let id = self.fresh();
        self.origins.insert(id, (at, 0));
        let mut rung = rung(id, Vec::new());
        for part in &leaf.parts {
            let id = self.fresh();
            self.origins.insert(id, (at, 0));
            rung.series.push(element(id, part));
        }
        self.rungs.insert(0, rung);
    }

    fn rung(&mut self, flow: &Flow<'_, '_, '_>, circuit: &Circuit) {
        let id = self.fresh();
        let mut keys = Vec::new();
        leaves(circuit, &mut |leaf| keys.push(leaf.key.0));
        if let Some(at) = keys.first() {
            self.origin(id, flow, *at);
        }
        let labels = std::mem::take(&mut self.labels);
        let mut rung = rung(id, labels);
        rung.series = self.series(flow, circuit);
        self.rungs.push(rung);
    }

    fn series(&mut self, flow: &Flow<'_, '_, '_>, circuit: &[Item]) -> edit::Series {
        let mut series = edit::Series::new();
        for item in circuit {
            match item {
                Item::Leaf(leaf) => self.leaf(flow, leaf, &mut series),
                Item::Parallel { ways, .. } => {
                    let id = self.fresh();
                    let paths = ways.iter().map(|way| self.path(flow, way)).collect();
                    let (parallel, point) = (id, None);
                    if let Some(at) = first_of(circuit) {
                        self.origin(id, flow, at);
                    }
                    series.push(Node::Parallel(Parallel {
                        id: parallel,
                        point,
                        paths,
                    }));
                }
                Item::Gate((at, _), gate, way) => {
                    let id = self.fresh();
                    self.origin(id, flow, *at);
                    series.push(Node::Block(Block {
                        id,
                        gate: *gate,
                        recall: None,
                        path: self.path(flow, way),
                    }));
                }
            }
        }
        series
    }

    fn path(&mut self, flow: &Flow<'_, '_, '_>, way: &[Item]) -> Path {
        let id = self.fresh();
        if let Some(at) = first_of(way) {
            self.origin(id, flow, at);
        }
        Path {
            id,
            series: self.series(flow, way),
        }
    }

    fn leaf(&mut self, flow: &Flow<'_, '_, '_>, leaf: &Leaf, series: &mut edit::Series) {
        for part in &leaf.parts {
            let drives = match part.step.opcode() {
                Opcode::Coil => unoclp_core::isa::OUTPUT_OPERAND,
                Opcode::MarkerCoil => unoclp_core::isa::MARKER_OPERAND,
                _ => 0,
            };
            // A coil right after a timer is what that drives.
            if drives > 0
                && let Some(Node::Element(timer)) = series.last_mut()
                && timer.step.class() == Class::Timer
                && let [preset, None] = *timer.step.lines()
            {
                let target = part.step.number().map(|number| drives + i32::from(number));
                timer.step = timer.step.clone().with_lines([preset, target]);
                continue;
            }
            let id = self.fresh();
            self.origin(id, flow, leaf.key.0);
            if part.step.class() == Class::Timer
                && let Some(&timer) = flow.all.timers.get(&(flow.pou, leaf.key.0))
            {
                self.timers.insert(id, timer);
            }
            series.push(element(id, part));
        }
    }

    fn origin(&mut self, id: Id, flow: &Flow<'_, '_, '_>, at: usize) {
        if let Some(element) = flow.network.elements.get(at) {
            let place = crate::found::span(element.node);
            self.origins.insert(id, (place, flow.pou));
        }
    }

    fn fresh(&mut self) -> Id {
        self.next += 1;
        Id(self.next)
    }
}

fn element(id: Id, part: &crate::circuit::Part) -> Node {
    Node::Element(edit::Element {
        id,
        load: part.load.clone(),
        step: part.step.clone(),
    })
}

fn rung(id: Id, labels: Vec<u8>) -> Rung {
    Rung {
        id,
        comment: Vec::new(),
        begin: Begin::Rung,
        labels,
        series: edit::Series::new(),
    }
}

/// The element that a circuit begins with.
fn first_of(circuit: &[Item]) -> Option<usize> {
    let mut first = None;
    heads(circuit, &mut |head| first = first.or(Some(head)));
    first
}
