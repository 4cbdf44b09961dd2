//! The elements of a ladder body, and the wires between them.

use crate::found::Found;
use crate::xml::{all, first, says, text};
use roxmltree::Node;
use std::collections::HashMap;
use unoclp_lang::Code;

/// A ladder body.
pub(crate) struct Network<'a, 'x> {
    /// What the POU is called.
    pub pou: String,
    pub elements: Vec<Element<'a, 'x>>,
    by_id: HashMap<&'a str, usize>,
}

/// A contact, a coil, a block, or whatever else is drawn.
pub(crate) struct Element<'a, 'x> {
    pub node: Node<'a, 'x>,
    pub local: &'a str,
    /// The name of its XML element: `contact`.
    pub kind: &'x str,
    /// Where it stands: from top to bottom, from left to right.
    pub place: (i64, i64),
    /// What it has as inputs; the only one of a contact has no name.
    pub inputs: Vec<Pin<'a>>,
    /// What its outputs are called, and whether they are negated.
    pub outputs: Vec<(&'a str, bool)>,
}

/// An input.
pub(crate) struct Pin<'a> {
    pub name: &'a str,
    pub negated: bool,
    /// `rising`, `falling`; else empty.
    pub edge: &'a str,
    /// Where its wires come from.
    pub wires: Vec<Wire<'a>>,
}

/// The beginning of a wire: an output of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Wire<'a> {
    /// The place of the element in the network.
    pub from: usize,
    /// The name of the output, where it has one.
    pub output: &'a str,
}

impl<'a, 'x: 'a> Network<'a, 'x> {
    /// The elements of a body; wires that come from nowhere are told.
    pub(crate) fn read(pou: &str, body: Node<'a, 'x>, found: &mut Found) -> Network<'a, 'x> {
        let mut network = Network {
            pou: pou.to_owned(),
            elements: Vec::new(),
            by_id: HashMap::new(),
        };
        let nodes: Vec<Node<'_, '_>> = body.children().filter(Node::is_element).collect();
        for (index, node) in nodes.iter().enumerate() {
            if let Some(local) = node.attribute("localId") {
                network.by_id.entry(local).or_insert(index);
            }
        }
        for node in nodes {
            let element = network.element(node, found);
            network.elements.push(element);
        }
        network
    }

    /// `Main, element 12`.
    pub(crate) fn name(&self, element: usize) -> (String, String) {
        let pou = &self.pou;
        match self.elements.get(element).map(|element| element.local) {
            Some(local) => (
                format!("`{pou}`, element {local}"),
                format!("`{pou}`, elemento {local}"),
            ),
            None => (format!("`{pou}`"), format!("`{pou}`")),
        }
    }

    fn element(&self, node: Node<'a, 'x>, found: &mut Found) -> Element<'a, 'x> {
        let number = |of: Node<'_, '_>, name| {
            let number: f64 = of
                .attribute(name)
                .and_then(|n| n.parse().ok())
                .unwrap_or(0.0);
            number as i64
        };
        let place = first(node, "position").map_or((0, 0), |at| (number(at, "y"), number(at, "x")));
        let mut element = Element {
            node,
            local: node.attribute("localId").unwrap_or("?"),
            kind: node.tag_name().name(),
            place,
            inputs: Vec::new(),
            outputs: Vec::new(),
        };
        for of in all(node, "connectionPointIn") {
            let pin = self.pin(node, of, "", found);
            // A right rail has many; they are one to us.
            match element.inputs.first_mut() {
                Some(first) => first.wires.extend(pin.wires),
                None => element.inputs.push(pin),
            }
        }
        if first(node, "connectionPointOut").is_some() {
            element.outputs.push(("", false));
        }
        for section in ["inputVariables", "inOutVariables", "outputVariables"] {
            let variables = all(node, section).flat_map(|section| all(section, "variable"));
            for variable in variables {
                let name = variable.attribute("formalParameter").unwrap_or_default();
                for of in all(variable, "connectionPointIn") {
                    let mut pin = self.pin(node, of, name, found);
                    pin.negated = says(variable, "negated");
                    pin.edge = edge(variable);
                    element.inputs.push(pin);
                }
                if section != "inputVariables" {
                    element.outputs.push((name, says(variable, "negated")));
                }
            }
        }
        element
    }

    fn pin(
        &self,
        element: Node<'a, 'x>,
        of: Node<'a, 'x>,
        name: &'a str,
        found: &mut Found,
    ) -> Pin<'a> {
        let mut wires = Vec::new();
        for connection in all(of, "connection") {
            let id = connection.attribute("refLocalId").unwrap_or_default();
            let output = connection.attribute("formalParameter").unwrap_or_default();
            match self.by_id.get(id) {
                Some(&from) => wires.push(Wire { from, output }),
                None => {
                    let local = element.attribute("localId").unwrap_or("?");
                    let who = (
                        format!("`{}`, element {local}", self.pou),
                        format!("`{}`, elemento {local}", self.pou),
                    );
                    found.tell(Code::XmlWire, connection, [who.into(), id.into()]);
                }
            }
        }
        Pin {
            name,
            negated: false,
            edge: "",
            wires,
        }
    }
}

impl<'a> Element<'a, '_> {
    /// The input with this name.
    pub(crate) fn input(&self, name: &str) -> Option<&Pin<'a>> {
        let mut inputs = self.inputs.iter();
        inputs.find(|pin| pin.name.eq_ignore_ascii_case(name))
    }

    /// The wires to the input with this name.
    pub(crate) fn wires(&self, name: &str) -> &[Wire<'a>] {
        self.input(name).map_or(&[], |pin| &pin.wires)
    }

    /// What is written at it: the variable of a contact or a coil, the expression of a value.
    pub(crate) fn written(&self) -> String {
        let element = first(self.node, "variable").or_else(|| first(self.node, "expression"));
        element.map_or(String::new(), text).trim().to_owned()
    }

    /// The type of a block, in upper case.
    pub(crate) fn block(&self) -> String {
        let name = self.node.attribute("typeName").unwrap_or_default();
        name.to_uppercase()
    }

    /// Whether what it gives is inverted.
    pub(crate) fn negated(&self) -> bool {
        says(self.node, "negated")
    }

    /// Whether this output of a block is negated.
    pub(crate) fn is_negated(&self, output: &str) -> bool {
        let mut outputs = self.outputs.iter();
        outputs.any(|(name, negated)| *negated && name.eq_ignore_ascii_case(output))
    }

    /// Whether it is a rail at which power ends.
    pub(crate) fn is_right_rail(&self) -> bool {
        self.kind == "rightPowerRail"
    }
}

/// `rising`, `falling`; else empty.
pub(crate) fn edge<'a>(of: Node<'a, '_>) -> &'a str {
    let edge = of.attribute("edge");
    edge.filter(|edge| matches!(*edge, "rising" | "falling"))
        .unwrap_or_default()
}
