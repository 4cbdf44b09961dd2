//! The blocks of a rung, and what leads to each.
//!
//! What stands in series is gathered until something looks at all of it: then it becomes one AND. Paths beside each other
//! become one OR. Where something stands before them, and contacts alone stand on them, their OR is an input of the AND;
//! else what stands before them leads to each of them, as the power does.

use crate::power::Net;
use crate::tree::{Gate, Join, Node, Path, Start};
use crate::{Ladder, Rung, Symbol};
use unoclp_point::Address;

/// The blocks of a rung, in the order in which the program runs.
pub(crate) struct Graph<'l> {
    ladder: &'l Ladder,
    pub vertices: Vec<Vertex>,
    /// Those that lead to nothing: outputs, and what is left at the end.
    pub ends: Vec<usize>,
}

/// A block, or whatever else a wire begins or ends at.
pub(crate) struct Vertex {
    pub kind: Kind,
    pub inputs: Vec<Pin>,
    /// The net of what it gives.
    pub net: Net,
    /// What it gives, of the points alone: `|2 I1 !I2`. None: its net says it.
    pub says: Option<String>,
}

/// What a vertex is.
pub(crate) enum Kind {
    /// A contact: what it reads.
    Value(usize),
    /// The left rail, or a named point of the rung.
    Named(String),
    /// `&`, `≥1`, `=1`; a box of the document where it is one.
    Gate(&'static str, Option<usize>),
    /// A box.
    Box(usize),
    /// A coil, a jump or a return.
    Output(usize),
    /// A point that paths begin at by its name.
    Store(String),
}

/// An input of a block.
#[derive(Clone, Copy)]
pub(crate) struct Pin {
    pub from: usize,
    pub negated: bool,
}

/// What stands in series, as far as nothing has looked at it.
#[derive(Clone)]
struct Terms {
    pins: Vec<Pin>,
    /// The net after all of them.
    net: Net,
    /// Whether an output has taken all of it.
    taken: bool,
}

impl<'l> Graph<'l> {
    /// The blocks of a rung.
    pub(crate) fn of(ladder: &'l Ladder, rung: &Rung) -> Graph<'l> {
        let mut graph = Graph {
            ladder,
            vertices: Vec::new(),
            ends: Vec::new(),
        };
        let mut terms = Terms::none(rung.rail);
        graph.series(&rung.series, &mut terms);
        if !terms.taken && !terms.pins.is_empty() {
            let end = graph.all(&mut terms);
            graph.ends.push(end.from);
        }
        graph
    }

    fn add(&mut self, kind: Kind, inputs: Vec<Pin>, net: Net, says: Option<String>) -> Pin {
        self.vertices.push(Vertex {
            kind,
            inputs,
            net,
            says,
        });
        Pin {
            from: self.vertices.len() - 1,
            negated: false,
        }
    }

    /// All that stands in series so far, as one wire.
    fn all(&mut self, terms: &mut Terms) -> Pin {
        let all = match terms.pins[..] {
            [] => self.add(Kind::Named("1".to_owned()), Vec::new(), terms.net, None),
            [one] => one,
            _ => {
                let pins = std::mem::take(&mut terms.pins);
                self.add(Kind::Gate("&", None), pins, terms.net, None)
            }
        };
        terms.pins = vec![all];
        all
    }

    fn series(&mut self, series: &[Node], terms: &mut Terms) {
        for node in series {
            match node {
                Node::Element(index) => self.element(*index, terms),
                Node::Store(store) if store.named => {
                    let all = self.all(terms);
                    let kind = Kind::Store(format!("•{}", store.name));
                    let store = self.add(kind, vec![all], terms.net, None);
                    self.ends.push(store.from);
                }
                Node::Store(_) | Node::Goto(_) => {}
                Node::Block(series, _) => self.series(series, terms),
                Node::Join(join) => self.join(join, terms),
                Node::Fork(branches) => {
                    let all = (!terms.pins.is_empty()).then(|| self.all(terms));
                    for branch in branches {
                        let mut own = Terms::none(terms.net);
                        own.pins.extend(all);
                        own.taken = all.is_some();
                        self.series(branch, &mut own);
                        if !own.taken && !own.pins.is_empty() {
                            let end = self.all(&mut own);
                            self.ends.push(end.from);
                        }
                    }
                    terms.taken = true;
                }
            }
        }
    }

    fn element(&mut self, index: usize, terms: &mut Terms) {
        let Some(element) = self.ladder.elements.get(index) else {
            return;
        };
        let net = element.net;
        match &element.symbol {
            Symbol::Contact { closed, .. } => {
                let says = element.point.filter(is_seen).map(|point| point.to_string());
                let mut pin = self.add(Kind::Value(index), Vec::new(), net, says);
                pin.negated = *closed;
                terms.pins.push(pin);
                (terms.net, terms.taken) = (net, false);
            }
            Symbol::Coil { .. } | Symbol::Leave { .. } => {
                let all = self.all(terms);
                let output = self.add(Kind::Output(index), vec![all], net, None);
                self.ends.push(output.from);
                terms.taken = true;
            }
            Symbol::Inline(_) | Symbol::Box { .. } => {
                let inputs = match terms.pins.is_empty() && element.is_condition() {
                    true => Vec::new(),
                    false => vec![self.all(terms)],
                };
                let given = self.add(Kind::Box(index), inputs, net, None);
                *terms = Terms::of(given, net);
            }
        }
    }

    fn join(&mut self, join: &Join, terms: &mut Terms) {
        let is_input = join.gate == Gate::Or
            && !terms.pins.is_empty()
            && join.paths.iter().all(|path| self.is_plain(path));
        let before = match is_input || terms.pins.is_empty() {
            true => None,
            false => Some(self.all(terms)),
        };
        let mut inputs = Vec::with_capacity(join.paths.len());
        for path in &join.paths {
            let mut own = Terms::none(path.net);
            match (&path.start, self.ladder.start(&path.start)) {
                (Start::Here, _) => own.pins.extend(before),
                (_, name) if name == "├" => {}
                (_, name) => {
                    let named = self.add(Kind::Named(name), Vec::new(), path.net, None);
                    own.pins.push(named);
                }
            }
            self.series(&path.series, &mut own);
            inputs.push(self.all(&mut own));
        }
        let sign = match join.gate {
            Gate::Or => "≥1",
            Gate::And => "&",
            Gate::Xor => "=1",
        };
        let says = is_input.then(|| self.said('|', &inputs)).flatten();
        let given = self.add(Kind::Gate(sign, join.element), inputs, join.net, says);
        if is_input {
            self.say_ands();
            terms.pins.push(given);
            (terms.net, terms.taken) = (join.net, false);
        } else {
            *terms = Terms::of(given, join.net);
        }
    }

    /// Whether contacts alone stand on a path, of points that are seen whatever the power is.
    fn is_plain(&self, path: &Path) -> bool {
        path.start == Start::Here && !path.series.is_empty() && self.are_plain(&path.series)
    }

    fn are_plain(&self, series: &[Node]) -> bool {
        series.iter().all(|node| match node {
            Node::Element(index) => self.ladder.elements.get(*index).is_some_and(|element| {
                let is_contact = matches!(element.symbol, Symbol::Contact { .. });
                is_contact && element.point.is_some_and(|point| is_seen(&point))
            }),
            Node::Join(join) => {
                join.gate == Gate::Or && join.paths.iter().all(|path| self.is_plain(path))
            }
            Node::Store(store) => !store.named,
            _ => false,
        })
    }

    /// What a gate of these inputs says, of points alone.
    fn said(&self, sign: char, inputs: &[Pin]) -> Option<String> {
        let mut said = format!("{sign}{}", inputs.len());
        for pin in inputs {
            let vertex = self.vertices.get(pin.from)?;
            let own = match (&vertex.says, &vertex.kind) {
                (Some(says), _) => says.clone(),
                (None, Kind::Gate("&", None)) => self.said('&', &vertex.inputs)?,
                (None, Kind::Gate("≥1", None)) => self.said('|', &vertex.inputs)?,
                _ => return None,
            };
            said += if pin.negated { " !" } else { " " };
            said += &own;
        }
        Some(said)
    }

    /// Gates within an input of an AND know of points alone, since the power before them is another matter.
    fn say_ands(&mut self) {
        let Some(last) = self.vertices.last() else {
            return;
        };
        let mut open: Vec<usize> = last.inputs.iter().map(|pin| pin.from).collect();
        while let Some(at) = open.pop() {
            let sign = match self.vertices[at].kind {
                Kind::Gate("&", None) => '&',
                Kind::Gate("≥1", None) => '|',
                _ => continue,
            };
            let inputs = &self.vertices[at].inputs;
            open.extend(inputs.iter().map(|pin| pin.from));
            let says = self.said(sign, inputs);
            self.vertices[at].says = says;
        }
    }
}

impl Terms {
    fn none(net: Net) -> Terms {
        Terms {
            pins: Vec::new(),
            net,
            taken: false,
        }
    }

    fn of(pin: Pin, net: Net) -> Terms {
        Terms {
            pins: vec![pin],
            ..Terms::none(net)
        }
    }
}

/// Whether a page sees what this point is, whatever the power before its contact.
fn is_seen(point: &Address) -> bool {
    matches!(
        point,
        Address::Input(_) | Address::Output(_) | Address::Marker(_)
    )
}
