//! Rungs, and what is on their wires.

use super::counters::Counters;
use super::lost::Lost;
use super::names::Variables;
use super::xml::{At, Body, Source};
use std::collections::HashMap;
use unoclp_core::isa::{Class, Opcode};
use unoclp_draw::edit::{Begin, Block, Document, Gate, Id, Node, Rung, visit};
use unoclp_point::Address;

/// From one element to the next, and from one row to the next.
pub(crate) const COLUMN: i64 = 120;
pub(crate) const ROW: i64 = 60;

/// A body as it is drawn.
pub(crate) struct Draw {
    /// Whether as a block diagram.
    pub is_blocks: bool,
    pub body: Body,
    pub variables: Variables,
    pub lost: Vec<Lost>,
    /// What value holds.
    pub values: Values,
    pub rung: usize,
    /// The first row that is free.
    pub row: i64,
    pub timers: HashMap<Id, u8>,
    pub counters: Counters,
    /// The blocks of those counters that are drawn, in a block diagram.
    pub drawn: HashMap<u8, u32>,
}

/// What value holds, and what has been pushed; none where that is not known.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Values {
    pub value: Option<Source>,
    pub pushed: Vec<Source>,
    /// The block whose result has just been stored.
    pub stored: Option<Source>,
}

/// Where the power is.
#[derive(Clone)]
pub(crate) struct Wire {
    pub from: Vec<Source>,
    pub at: At,
}

impl Draw {
    pub(crate) fn new(document: &Document, is_blocks: bool) -> Draw {
        let mut timers = HashMap::new();
        let mut kinds: HashMap<u8, &str> = HashMap::new();
        for rung in document.rungs() {
            visit(&rung.series, &mut |node| {
                let Node::Element(element) = node else { return };
                let opcode = element.step.opcode();
                if opcode.class() == Class::Timer && element.step.is_own_timer() {
                    let own = kinds.len() as u8 + 1;
                    timers.insert(element.id, own);
                    kinds.insert(own, timer(opcode).unwrap_or("TON"));
                }
            });
        }
        let mut variables = Variables::new(document.table().names());
        let mut numbers: Vec<(&u8, &&str)> = kinds.iter().collect();
        numbers.sort();
        for (number, kind) in numbers {
            variables.of(Address::Timer(*number), kind);
        }
        Draw {
            is_blocks,
            drawn: HashMap::new(),
            body: Body::default(),
            variables,
            lost: Vec::new(),
            values: Values::default(),
            rung: 0,
            row: 20,
            timers,
            counters: Counters::of(document),
        }
    }

    /// Draws the first of these rungs, and those after it that are one block with it; how many.
    pub(crate) fn rung(&mut self, rungs: &[&Rung], number: usize) -> usize {
        let Some(rung) = rungs.first() else { return 1 };
        self.rung = number;
        if matches!(rung.begin, Begin::Else | Begin::EndIf) {
            self.lose(rung.id, "ELS, END");
        }
        if !rung.comment.is_empty() {
            let at = At { x: 20, y: self.row };
            self.body.note(None, &rung.comment.join("\n"), at);
            self.row += ROW;
        }
        for label in &rung.labels {
            let at = At { x: 20, y: self.row };
            self.body.note(Some(&format!("L{label:02}")), "", at);
            self.row += ROW;
        }
        if let Some(count) = self.counters.together(rungs) {
            self.counter(rungs.get(..count).unwrap_or_default());
            return count;
        }
        let wire = self.way(&rung.series);
        if !self.is_blocks {
            let x = wire.at.x + COLUMN;
            self.body.end(&wire.from, At { x, ..wire.at });
        }
        self.row += ROW;
        1
    }

    /// Draws what is in series from a left rail of its own.
    pub(crate) fn way(&mut self, series: &[Node]) -> Wire {
        let rail = self.rail();
        self.values = Values::default();
        let mut wire = rail.clone();
        match self.is_blocks {
            true => self.series_of_blocks(series, (&mut wire, &rail), 1),
            false => self.series(series, &mut wire, &rail),
        }
        wire
    }

    fn rail(&mut self) -> Wire {
        if self.is_blocks {
            return self.first_of_blocks();
        }
        let at = At { x: 20, y: self.row };
        let rail = self.body.rail(at);
        Wire {
            from: vec![(rail, "")],
            at: At {
                x: at.x + COLUMN,
                y: at.y,
            },
        }
    }

    /// Draws what is in series; `rail` is where a way of its own begins.
    fn series(&mut self, series: &[Node], wire: &mut Wire, rail: &Wire) {
        if self.is_blocks {
            return self.series_of_blocks(series, (wire, rail), 0);
        }
        for node in series {
            self.node(node, wire, rail);
        }
    }

    /// Draws a piece of what is in series.
    pub(super) fn node(&mut self, node: &Node, wire: &mut Wire, rail: &Wire) {
        match node {
            Node::Element(element) => {
                let end = self.row.max(wire.at.y);
                self.element(element, wire);
                self.row = end.max(self.row);
            }
            Node::Store(store) => self.lose(store.id, "()"),
            Node::Parallel(parallel) => {
                let from = wire.clone();
                let before = self.values.clone();
                let mut after: Option<Values> = None;
                let mut ends = Vec::new();
                let mut x = from.at.x;
                for (index, path) in parallel.paths.iter().enumerate() {
                    let mut way = from.clone();
                    if index > 0 {
                        self.row += ROW;
                        way.at.y = self.row;
                    }
                    self.values = before.clone();
                    self.series(&path.series, &mut way, rail);
                    x = x.max(way.at.x);
                    ends.extend(way.from);
                    let same = after.as_ref().is_none_or(|after| *after == self.values);
                    after = Some(if same {
                        self.values.clone()
                    } else {
                        Values::default()
                    });
                }
                self.values = after.unwrap_or_default();
                ends.dedup();
                wire.from = ends;
                // Outputs run from top to bottom: what follows is drawn no higher.
                wire.at = At { x, y: self.row };
            }
            Node::Block(block) if block.recall.is_some() => self.lose(block.id, "()"),
            Node::Block(block) if self.is_blocks => self.gate_of_blocks(block, wire, rail),
            Node::Block(block) => self.gate(block, wire, rail),
        }
    }

    fn gate(&mut self, block: &Block, wire: &mut Wire, rail: &Wire) {
        let kind = match block.gate {
            Gate::And => "AND",
            Gate::Or => "OR",
            Gate::Xor => "XOR",
        };
        self.row += ROW;
        let at = At {
            x: rail.at.x,
            y: self.row,
        };
        let mut way = Wire {
            from: rail.from.clone(),
            at,
        };
        let values = self.values.clone();
        self.series(&block.path.series, &mut way, rail);
        if self.values != values {
            self.values = Values::default();
        }
        let x = wire.at.x.max(way.at.x);
        let inputs = [("IN1", &wire.from[..]), ("IN2", &way.from[..])];
        let at = At { x, y: self.row };
        let id = self.body.block(kind, None, &inputs, &["OUT"], at);
        *wire = Wire {
            from: vec![(id, "OUT")],
            at: At {
                x: x + COLUMN,
                y: at.y,
            },
        };
    }

    /// A value below and before a block that takes it.
    pub(crate) fn value_of(&mut self, expression: &str, at: At) -> Source {
        self.row = self.row.max(at.y) + ROW;
        let at = At {
            x: at.x - COLUMN / 2,
            y: self.row,
        };
        self.body.value(expression, false, at)
    }

    /// Where an element is that no project can say.
    pub(crate) fn lose(&mut self, at: Id, what: impl Into<String>) {
        self.lost.push(Lost {
            at,
            rung: self.rung,
            what: what.into(),
            is_blocks: false,
        });
    }
}

/// The block of a timer.
pub(crate) fn timer(opcode: Opcode) -> Option<&'static str> {
    Some(match opcode {
        Opcode::OnDelay => "TON",
        Opcode::OffDelay => "TOF",
        Opcode::Pulse => "TP",
        _ => return None,
    })
}
