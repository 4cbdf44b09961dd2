//! A condition that is drawn: contacts, values and functions, as an expression.
//!
//! A chart calls no blocks. So those that lead to conditions are called by an action of its own in each scan, as OpenPLC
//! Editor and Beremiz have it; a condition reads what they gave last.

use super::bodies::Bodies;
use super::written::Said;
use crate::found::{Found, span};
use crate::network::{DEEPEST, Network, Wire, edge};
use crate::xml::says;
use roxmltree::Node;
use unoclp_lang::{Code, Span};

/// An expression has no more pieces.
const LARGEST: usize = 5_000;

/// What is drawn in a body.
pub(super) struct Wired<'f, 'b, 'a, 'x> {
    network: Network<'a, 'x>,
    bodies: &'f mut Bodies<'b, 'a, 'x>,
    found: &'f mut Found,
    open: Vec<usize>,
    pieces: usize,
}

impl<'f, 'b, 'a, 'x: 'a> Wired<'f, 'b, 'a, 'x> {
    pub(super) fn new(
        bodies: &'f mut Bodies<'b, 'a, 'x>,
        body: Node<'a, 'x>,
        found: &'f mut Found,
    ) -> Wired<'f, 'b, 'a, 'x> {
        Wired {
            network: Network::read(&bodies.pou.name, body, &mut Found::default()),
            bodies,
            found,
            open: Vec::new(),
            pieces: 0,
        }
    }

    /// What leads to a transition by these wires.
    pub(super) fn condition(&mut self, wires: &[Node<'a, 'x>]) -> Option<Said> {
        let ends = wires.iter().filter_map(|wire| {
            let id = wire.attribute("refLocalId")?;
            let output = wire.attribute("formalParameter").unwrap_or_default();
            let of = |element: &crate::network::Element<'_, '_>| {
                element.node.attribute("localId") == Some(id)
            };
            let from = self.network.elements.iter().position(of)?;
            Some(Wire { from, output })
        });
        let ends: Vec<Wire<'a>> = ends.collect();
        match (ends.is_empty(), wires.first()) {
            (true, Some(wire)) => {
                let pou = format!("`{}`", self.network.pou);
                self.found.tell_at(Code::XmlWire, span(*wire), [pou.into()]);
                None
            }
            _ => self.any(&ends, 0),
        }
    }

    /// What leads to the coil that has the name of a transition, or to the only one.
    pub(super) fn coil(&mut self, name: &str) -> Option<Said> {
        let coils = || {
            let elements = self.network.elements.iter().enumerate();
            elements.filter(|(_, of)| matches!(of.kind, "coil" | "outVariable"))
        };
        let named = coils().find(|(_, of)| of.written.eq_ignore_ascii_case(name));
        let Some((at, _)) = named.or_else(|| coils().next()) else {
            let pou = format!("`{}`", self.network.pou);
            let at = self.network.elements.first().map(|first| span(first.node));
            let words = [pou.into(), ("an empty body", "um corpo vazio").into()];
            self.found
                .tell_at(Code::XmlCondition, at.unwrap_or_default(), words);
            return None;
        };
        let said = self.input(at, "")?;
        let negated = says(self.network.elements[at].node, "negated");
        Some(if negated { self.not(at, said) } else { said })
    }

    fn not(&self, at: usize, said: Said) -> Said {
        let at = span(self.network.elements[at].node);
        let mut all = vec![("NOT (".to_owned(), at)];
        all.extend(said);
        all.push((")".to_owned(), at));
        all
    }

    /// One of these ways.
    fn any(&mut self, ends: &[Wire<'a>], at: usize) -> Option<Said> {
        let mut all: Said = Vec::new();
        for (nth, wire) in ends.iter().enumerate() {
            let own = self.source(*wire)?;
            let at = own
                .first()
                .map_or(span(self.network.elements[at].node), |(_, at)| *at);
            if nth > 0 {
                all.push((" OR ".to_owned(), at));
            }
            all.extend(own);
        }
        if ends.len() > 1 {
            let first = all.first().map_or(Span::default(), |(_, at)| *at);
            all.insert(0, ("(".to_owned(), first));
            all.push((")".to_owned(), first));
        }
        self.pieces += all.len();
        if self.pieces > LARGEST {
            self.network.too_large(at, self.found);
            return None;
        }
        Some(all)
    }

    fn input(&mut self, at: usize, name: &str) -> Option<Said> {
        let wires = self.network.elements[at].wires(name).to_vec();
        if wires.is_empty() {
            let what = match name {
                "" => ("it", "ele").into(),
                name => name.into(),
            };
            self.network.tell(self.found, Code::XmlPin, at, [what]);
            return None;
        }
        self.any(&wires, at)
    }

    fn source(&mut self, wire: Wire<'a>) -> Option<Said> {
        if self.open.contains(&wire.from) || self.open.len() >= DEEPEST {
            self.network.tell(self.found, Code::XmlLoop, wire.from, []);
            return None;
        }
        self.open.push(wire.from);
        let said = self.element(wire);
        self.open.pop();
        said
    }

    fn element(&mut self, wire: Wire<'a>) -> Option<Said> {
        let at = wire.from;
        let (kind, node) = (
            self.network.elements[at].kind,
            self.network.elements[at].node,
        );
        let place = span(node);
        let negated = says(node, "negated");
        match kind {
            "leftPowerRail" => Some(vec![("TRUE".to_owned(), place)]),
            "contact" => {
                let mut said = self.input(at, "")?;
                let is_first = matches!(&said[..], [(text, _)] if text == "TRUE");
                match is_first {
                    true => said.clear(),
                    false => said.push((" AND ".to_owned(), place)),
                }
                let written = self.network.elements[at].written.clone();
                let name = match edge(node) {
                    "" => written,
                    edge => self.bodies.edge(edge, &written, place),
                };
                let not = if negated { "NOT " } else { "" };
                said.push((format!("{not}{name}"), place));
                Some(said)
            }
            "coil" => self.input(at, ""),
            "inVariable" | "inOutVariable" => {
                let said = vec![(format!("({})", self.network.elements[at].written), place)];
                Some(if negated { self.not(at, said) } else { said })
            }
            "continuation" => {
                let connector = self.network.continued_from(at, self.found)?;
                self.input(connector, "")
            }
            "block" => self.block(wire),
            _ => {
                self.network
                    .tell(self.found, Code::XmlElement, at, [kind.into()]);
                None
            }
        }
    }

    fn block(&mut self, wire: Wire<'a>) -> Option<Said> {
        let at = wire.from;
        let node = self.network.elements[at].node;
        let place = span(node);
        let name = node.attribute("typeName").unwrap_or_default().to_owned();
        let is_negated = self.network.elements[at].is_negated(wire.output);
        let instance = node
            .attribute("instanceName")
            .filter(|name| !name.is_empty());
        let said = match instance {
            Some(instance) => vec![(self.called(wire, instance, &name)?, place)],
            None => {
                let pins: Vec<(String, bool)> = {
                    let inputs = self.network.elements[at].inputs.iter();
                    let inputs = inputs.filter(|pin| !pin.wires.is_empty());
                    inputs
                        .map(|pin| (pin.name.to_owned(), pin.negated))
                        .collect()
                };
                if pins.iter().any(|(name, _)| name.eq_ignore_ascii_case("EN")) {
                    self.network
                        .tell(self.found, Code::XmlCondition, at, ["EN".into()]);
                    return None;
                }
                let mut all = vec![(format!("{name}("), place)];
                for (nth, (pin, negated)) in pins.iter().enumerate() {
                    let given = self.input(at, pin)?;
                    all.push((if nth > 0 { ", " } else { "" }.to_owned(), place));
                    match negated {
                        true => all.extend(self.not(at, given)),
                        false => all.extend(given),
                    }
                }
                all.push((")".to_owned(), place));
                all
            }
        };
        Some(if is_negated { self.not(at, said) } else { said })
    }

    /// An output of a block, which is called once in each scan.
    fn called(&mut self, wire: Wire<'a>, instance: &str, name: &str) -> Option<String> {
        let at = wire.from;
        let element = &self.network.elements[at];
        let output = match wire.output {
            "" => element
                .outputs
                .iter()
                .find(|(name, _)| !name.eq_ignore_ascii_case("ENO")),
            named => element.outputs.iter().find(|(name, _)| *name == named),
        };
        let gives = output.map_or("Q", |(name, _)| *name);
        let gives = format!("{instance}.{gives}");
        if !self.bodies.calls_first(instance) {
            return Some(gives);
        }
        let place = span(element.node);
        let declared = self.bodies.known.get(&instance.to_uppercase());
        if declared.is_none_or(|of| !of.kind.eq_ignore_ascii_case(name)) {
            self.network
                .tell(self.found, Code::XmlUndeclared, at, [instance.into()]);
            return None;
        }
        let inputs = element.inputs.iter().filter(|pin| !pin.wires.is_empty());
        let inputs: Vec<(&'a str, bool)> = inputs.map(|pin| (pin.name, pin.negated)).collect();
        // What leads back to the block brings what it gave before.
        let open = std::mem::take(&mut self.open);
        let mut call = vec![(format!("{instance}("), place)];
        for (pin, negated) in inputs {
            let given = self.input(at, pin)?;
            let comma = if call.len() > 1 { ", " } else { "" };
            call.push((format!("{comma}{pin} := "), place));
            call.extend(if negated { self.not(at, given) } else { given });
        }
        call.push((");\n".to_owned(), place));
        self.open = open;
        self.bodies.calls.push(call);
        Some(gives)
    }
}
