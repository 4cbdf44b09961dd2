//! Rungs, and what stands on their wires.

use super::Lost;
use super::names::Variables;
use super::numbers::Values;
use super::xml::{At, Body, Source};
use std::collections::HashMap;
use unoclp_core::Profile;
use unoclp_core::isa::{Class, Kind, MARKER_OPERAND, OUTPUT_OPERAND, Opcode};
use unoclp_ladder::Address;
use unoclp_ladder::edit::{Begin, Block, Document, Element, Gate, Id, Node, Rung, Step, visit};

/// From one element to the next, and from one row to the next.
const COLUMN: i64 = 120;
const ROW: i64 = 60;

/// A body as it is drawn.
pub(crate) struct Draw {
    pub body: Body,
    pub variables: Variables,
    pub lost: Vec<Lost>,
    /// What value holds.
    pub values: Values,
    rung: usize,
    /// The first row that is free.
    pub row: i64,
    timers: HashMap<Id, u8>,
    /// How often each counter is counted up, down, reset and loaded.
    counts: HashMap<u8, [usize; 4]>,
}

/// Where the power is.
#[derive(Clone)]
pub(crate) struct Wire {
    pub from: Vec<Source>,
    pub at: At,
}

impl Draw {
    pub(crate) fn new(document: &Document) -> Draw {
        let mut timers = HashMap::new();
        let mut kinds: HashMap<u8, &str> = HashMap::new();
        let mut counts: HashMap<u8, [usize; 4]> = HashMap::new();
        for rung in document.rungs() {
            visit(&rung.series, &mut |node| {
                let Node::Element(element) = node else { return };
                let opcode = element.step.opcode();
                if opcode.class() == Class::Timer {
                    let number = timers.len() as u8 + 1;
                    timers.insert(element.id, number);
                    kinds.insert(number, timer(opcode).unwrap_or("TON"));
                }
                let which = match opcode {
                    Opcode::CountUp => 0,
                    Opcode::CountDown => 1,
                    Opcode::ResetCounter => 2,
                    Opcode::LoadCounter => 3,
                    _ => return,
                };
                let counter = element.step.number().unwrap_or(0);
                counts.entry(counter).or_default()[which] += 1;
            });
        }
        let mut variables = Variables::new(document.table().names());
        let mut numbers: Vec<(&u8, &&str)> = kinds.iter().collect();
        numbers.sort();
        for (number, kind) in numbers {
            variables.of(Address::Timer(*number), kind);
        }
        Draw {
            body: Body::default(),
            variables,
            lost: Vec::new(),
            values: Values::default(),
            rung: 0,
            row: 20,
            timers,
            counts,
        }
    }

    /// Draws a rung, and the next where both are one block; how many.
    pub(crate) fn rung(&mut self, rung: &Rung, next: Option<&Rung>, number: usize) -> usize {
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
        let rail = self.rail();
        let counted = next.and_then(|next| self.counted(rung, next));
        let series = match counted {
            Some(_) => &rung.series[..rung.series.len() - 1],
            None => &rung.series[..],
        };
        self.values = Values::default();
        let mut wire = rail.clone();
        self.series(series, &mut wire, &rail);
        if let (Some((count, input)), Some(next)) = (counted, next) {
            self.rung = number + 1;
            self.row += ROW;
            let rail = self.rail();
            let mut other = rail.clone();
            self.values = Values::default();
            self.series(&next.series[..next.series.len() - 1], &mut other, &rail);
            let at = At {
                x: wire.at.x.max(other.at.x),
                y: wire.at.y,
            };
            self.count(count, &wire.from, Some((input, &other.from)), at);
            self.row = self.row.max(other.at.y) + 2 * ROW;
            return 2;
        }
        self.body.end(
            &wire.from,
            At {
                x: wire.at.x + COLUMN,
                y: wire.at.y,
            },
        );
        self.row += ROW;
        1
    }

    fn rail(&mut self) -> Wire {
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

    /// The counter of a rung that the next resets or loads, where nothing else does; and by which input.
    fn counted<'d>(&self, rung: &'d Rung, next: &Rung) -> Option<(&'d Element, &'static str)> {
        let (Some(Node::Element(count)), Some(Node::Element(coil))) =
            (rung.series.last(), next.series.last())
        else {
            return None;
        };
        let counter = count.step.number()?;
        let [up, down, reset, load] = self.counts.get(&counter).copied()?;
        let input = match (count.step.opcode(), coil.step.opcode()) {
            (Opcode::CountUp, Opcode::ResetCounter) if (up, reset) == (1, 1) && load == 0 => "R",
            (Opcode::CountDown, Opcode::LoadCounter) if (down, load) == (1, 1) && reset == 0 => {
                "LD"
            }
            _ => return None,
        };
        let plain = next.begin == Begin::Rung && next.labels.is_empty() && next.comment.is_empty();
        let one = up + down == 1;
        (plain && one && coil.step.number() == Some(counter) && next.series.len() > 1)
            .then_some((count, input))
    }

    /// Draws what stands in series; `rail` is where a way of its own begins.
    fn series(&mut self, series: &[Node], wire: &mut Wire, rail: &Wire) {
        for node in series {
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
                Node::Block(block) => self.gate(block, wire, rail),
            }
        }
    }

    fn gate(&mut self, block: &Block, wire: &mut Wire, rail: &Wire) {
        if block.recall.is_some() {
            return self.lose(block.id, "()");
        }
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

    fn element(&mut self, element: &Element, wire: &mut Wire) {
        let step = &element.step;
        let (opcode, number) = (step.opcode(), step.number().unwrap_or(0));
        match step.class() {
            Class::Contact | Class::Condition => self.contact(element, wire),
            Class::Coil => self.coil(element, wire),
            Class::Timer => self.timer(element, wire),
            Class::Count => {
                let [up, down, reset, load] = self.counts.get(&number).copied().unwrap_or_default();
                if up + down != 1 || reset + load > 0 {
                    return self.lose(element.id, opcode.row().letters);
                }
                let id = self.count(element, &wire.from.clone(), None, wire.at);
                wire.from = vec![(id, "Q")];
                wire.at.x += COLUMN;
            }
            Class::Logic => {
                let (kind, instance, input, output) = match opcode {
                    Opcode::RisingEdge => ("R_TRIG", true, "CLK", "Q"),
                    Opcode::FallingEdge => ("F_TRIG", true, "CLK", "Q"),
                    _ => ("NOT", false, "IN", "OUT"),
                };
                let instance = instance.then(|| self.variables.instance(kind));
                let inputs = [(input, &wire.from[..])];
                let id = self
                    .body
                    .block(kind, instance.as_deref(), &inputs, &[output], wire.at);
                wire.from = vec![(id, output)];
                wire.at.x += COLUMN;
            }
            Class::Xor => {
                let Some(point) = bit(step) else {
                    return self.lose(element.id, opcode.row().letters);
                };
                let name = self.variables.of(point, "BOOL");
                let value = self.value_of(&name, wire.at);
                let second = if opcode.is_inverted() { "!IN2" } else { "IN2" };
                let inputs = [("IN1", &wire.from[..]), (second, &[value][..])];
                let id = self.body.block("XOR", None, &inputs, &["OUT"], wire.at);
                wire.from = vec![(id, "OUT")];
                wire.at.x += COLUMN;
            }
            Class::Leave => {
                let negated = if opcode.is_inverted() {
                    " negated=\"true\""
                } else {
                    ""
                };
                match step.class() == Class::Leave && opcode.row().kind == Kind::Jump {
                    true => {
                        let attributes = format!(" label=\"L{number:02}\"{negated}");
                        self.body.leave("jump", &attributes, &wire.from, wire.at);
                    }
                    false => self.body.leave("return", negated, &wire.from, wire.at),
                }
                wire.at.x += COLUMN;
            }
            _ => self.number(element, wire),
        }
    }

    fn contact(&mut self, element: &Element, wire: &mut Wire) {
        let step = &element.step;
        let opcode = step.opcode();
        let number = step.number().unwrap_or(0);
        let variable = match opcode.row().kind {
            Kind::TimerQ => {
                let known = self.timers.values().any(|timer| *timer == number);
                known.then(|| format!("{}.Q", self.variables.of(Address::Timer(number), "TON")))
            }
            Kind::Counter => self.counter(number).and_then(|(name, down)| {
                let zero = step.class() == Class::Condition;
                (zero == down).then(|| format!("{name}.Q"))
            }),
            _ => bit(step).map(|point| self.variables.of(point, "BOOL")),
        };
        let Some(variable) = variable else {
            return self.lose(element.id, opcode.row().letters);
        };
        let attributes = format!(" negated=\"{}\"", opcode.is_inverted());
        let id = self
            .body
            .symbol("contact", &attributes, &variable, &wire.from, wire.at);
        wire.from = vec![(id, "")];
        wire.at.x += COLUMN;
    }

    fn coil(&mut self, element: &Element, wire: &mut Wire) {
        let opcode = element.step.opcode();
        let attributes = match opcode {
            Opcode::Coil | Opcode::MarkerCoil => " negated=\"false\"",
            Opcode::NegatedCoil | Opcode::NegatedMarkerCoil => " negated=\"true\"",
            Opcode::SetCoil | Opcode::SetMarker => " negated=\"false\" storage=\"set\"",
            Opcode::ResetCoil | Opcode::ResetMarker => " negated=\"false\" storage=\"reset\"",
            other => return self.lose(element.id, other.row().letters),
        };
        let Some(point) = bit(&element.step) else {
            return self.lose(element.id, opcode.row().letters);
        };
        let name = self.variables.of(point, "BOOL");
        self.body
            .symbol("coil", attributes, &name, &wire.from, wire.at);
        wire.at.x += COLUMN;
    }

    fn timer(&mut self, element: &Element, wire: &mut Wire) {
        let opcode = element.step.opcode();
        let (Some(kind), Some(&number)) = (timer(opcode), self.timers.get(&element.id)) else {
            return self.lose(element.id, opcode.row().letters);
        };
        let &[Some(preset), Some(target)] = element.step.lines() else {
            return self.lose(element.id, opcode.row().letters);
        };
        let instance = self.variables.of(Address::Timer(number), kind);
        let preset = self.value_of(&format!("T#{preset}ms"), wire.at);
        let inputs = [("IN", &wire.from[..]), ("PT", &[preset][..])];
        let id = self
            .body
            .block(kind, Some(&instance), &inputs, &["Q", "ET"], wire.at);
        wire.from = vec![(id, "Q")];
        wire.at.x += COLUMN;
        let point = match target {
            OUTPUT_OPERAND.. => Address::Output((target - OUTPUT_OPERAND) as u8),
            _ => Address::Marker((target - MARKER_OPERAND) as u8),
        };
        let name = self.variables.of(point, "BOOL");
        self.body
            .symbol("coil", " negated=\"false\"", &name, &wire.from, wire.at);
        wire.at.x += COLUMN;
    }

    /// The instance of a counter, and whether it counts down; none where it is no block.
    pub(crate) fn counter(&mut self, number: u8) -> Option<(String, bool)> {
        let [up, down, ..] = self.counts.get(&number).copied()?;
        if up + down != 1 {
            return None;
        }
        let kind = if down == 1 { "CTD" } else { "CTU" };
        Some((self.variables.of(Address::Counter(number), kind), down == 1))
    }

    fn count(
        &mut self,
        element: &Element,
        from: &[Source],
        other: Option<(&'static str, &[Source])>,
        at: At,
    ) -> u32 {
        let counter = element.step.number().unwrap_or(0);
        let preset = element.step.lines().first().copied().flatten();
        let Some((instance, down)) = self.counter(counter) else {
            self.lose(element.id, element.step.opcode().row().letters);
            return 0;
        };
        let (kind, input) = if down { ("CTD", "CD") } else { ("CTU", "CU") };
        let preset = self.value_of(&preset.unwrap_or(0).to_string(), at);
        let mut inputs = vec![(input, from)];
        inputs.extend(other);
        let preset = [preset];
        inputs.push(("PV", &preset[..]));
        self.body
            .block(kind, Some(&instance), &inputs, &["Q", "CV"], at)
    }

    /// A value below and before a block that takes it.
    pub(crate) fn value_of(&mut self, expression: &str, at: At) -> Source {
        self.row = self.row.max(at.y) + ROW;
        let at = At {
            x: at.x - COLUMN / 2,
            y: self.row,
        };
        self.body.value(expression, at)
    }

    /// What is not read again as it was.
    pub(crate) fn not_read(&self, document: &Document, text: &str) -> Vec<Lost> {
        let made = crate::import(text, Profile::UNO).document;
        let own = instructions(document);
        let read = made.as_ref().map(instructions).unwrap_or_default();

        let pairs = own.iter().zip(&read);
        let alike = pairs.take_while(|(one, other)| one.1 == other.1).count();
        if made.is_some() && alike == own.len() && alike == read.len() {
            return Vec::new();
        }
        let at = own.get(alike).or(own.last()).map_or(Id(0), |(id, _)| *id);
        vec![Lost {
            at,
            rung: document.rung_of(at).map_or(1, |rung| rung + 1),
            what: "( … )".to_owned(),
        }]
    }

    /// Where an element is that no project can say.
    pub(crate) fn lose(&mut self, at: Id, what: impl Into<String>) {
        let (rung, what) = (self.rung, what.into());
        self.lost.push(Lost { at, rung, what });
    }
}

/// The instructions of a document. A new rung says nothing where one begins by itself.
fn instructions(document: &Document) -> Vec<(Id, Vec<i32>)> {
    let mut instructions = document.instructions().unwrap_or_default();
    let first = instructions.first().map(|(_, lines)| &lines[..]);
    if first == Some(&[Opcode::NewRung.row().code]) {
        instructions.remove(0);
    }
    instructions
}

/// The block of a timer.
fn timer(opcode: Opcode) -> Option<&'static str> {
    Some(match opcode {
        Opcode::OnDelay => "TON",
        Opcode::OffDelay => "TOF",
        Opcode::Pulse => "TP",
        _ => return None,
    })
}

/// The input, output or marker that an instruction names.
fn bit(step: &Step) -> Option<Address> {
    let number = step.number()?;
    Some(match step.opcode().row().kind {
        Kind::Input => Address::Input(number),
        Kind::Output => Address::Output(number),
        Kind::Marker => Address::Marker(number),
        _ => return None,
    })
}
