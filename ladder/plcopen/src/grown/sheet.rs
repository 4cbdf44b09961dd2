//! A drawn body of a file: its elements, their places, and the wires between them.

use crate::export::escaped;
use crate::xml::{all, first, within};
use roxmltree::Node;
use std::collections::{HashMap, HashSet};

/// A drawn body.
pub(super) struct Sheet<'t, 'a, 'x> {
    pub text: &'t str,
    pub body: Node<'a, 'x>,
    pub is_blocks: bool,
    /// The largest number of an element.
    pub last: u64,
}

impl<'t, 'a, 'x: 'a> Sheet<'t, 'a, 'x> {
    pub(super) fn of(text: &'t str, body: Node<'a, 'x>) -> Option<Sheet<'t, 'a, 'x>> {
        let is_blocks = match body.tag_name().name() {
            "LD" => false,
            "FBD" => true,
            _ => return None,
        };
        let ids = body.children().filter_map(|node| node.attribute("localId"));
        let last = ids.filter_map(|id| id.parse().ok()).max().unwrap_or(0);
        Some(Sheet {
            text,
            body,
            is_blocks,
            last,
        })
    }

    pub(super) fn element(&self, id: &str) -> Option<Node<'a, 'x>> {
        let mut elements = self.body.children();
        elements.find(|node| node.attribute("localId") == Some(id))
    }

    /// The pin of an element that power, or its first value, comes to.
    pub(super) fn power(&self, node: Node<'a, 'x>) -> Option<Node<'a, 'x>> {
        first(node, "connectionPointIn").or_else(|| {
            let pins = all(first(node, "inputVariables")?, "variable");
            let mut pins = pins.filter_map(|pin| first(pin, "connectionPointIn"));
            pins.next()
        })
    }

    /// The wires that lead to a pin, without the points between.
    pub(super) fn wires(&self, pin: Node<'a, 'x>) -> Vec<String> {
        let wire = |wire: Node<'_, '_>| {
            let of = |name| wire.attribute(name).filter(|said| !said.is_empty());
            Some(connection(of("refLocalId")?, of("formalParameter")))
        };
        all(pin, "connection").filter_map(wire).collect()
    }

    /// The wires that come from an element.
    pub(super) fn readers(&self, id: &str) -> Vec<Node<'a, 'x>> {
        let wires = within(self.body, "connection");
        let own = wires.filter(|wire| wire.attribute("refLocalId") == Some(id));
        own.collect()
    }

    /// The wires that come from this output of it; one without a name comes from its only one.
    pub(super) fn readers_of(&self, id: &str, output: Option<&str>) -> Vec<Node<'a, 'x>> {
        let mut wires = self.readers(id);
        wires.retain(|wire| {
            let name = wire.attribute("formalParameter").unwrap_or_default();
            name.is_empty() || output.is_none_or(|output| output.eq_ignore_ascii_case(name))
        });
        wires
    }

    /// Where an element stands.
    pub(super) fn place(&self, node: Node<'_, '_>) -> Option<(f64, f64)> {
        let at = first(node, "position")?;
        let number = |name| {
            at.attribute(name)?
                .parse::<f64>()
                .ok()
                .filter(|n| n.is_finite())
        };
        Some((number("x")?, number("y")?))
    }

    /// The output of an element that goes on: the one that something takes already, otherwise its first.
    pub(super) fn output(&self, node: Node<'a, 'x>, id: &str) -> Option<&'a str> {
        let taken = self.readers(id).into_iter();
        let mut taken = taken.filter_map(|wire| wire.attribute("formalParameter"));
        taken.next().filter(|name| !name.is_empty()).or_else(|| {
            let list = first(node, "outputVariables")?;
            let mut names = all(list, "variable").filter_map(|of| of.attribute("formalParameter"));
            let first = names.next()?;
            match first == "ENO" && self.is_blocks {
                true => names.next(),
                false => Some(first),
            }
        })
    }
}

/// The elements that wires to each element come from.
pub(super) struct Sources<'a>(HashMap<&'a str, Vec<&'a str>>);

impl<'a> Sources<'a> {
    pub(super) fn of<'x: 'a>(sheet: &Sheet<'_, 'a, 'x>) -> Sources<'a> {
        let elements = sheet.body.children().filter_map(|node| {
            let wires = within(node, "connection");
            let from = wires.filter_map(|wire| wire.attribute("refLocalId"));
            Some((node.attribute("localId")?, from.collect()))
        });
        Sources(elements.collect())
    }

    /// Whether a wire leads from one element to the other.
    pub(super) fn leads(&self, from: &str, to: &str) -> bool {
        self.0.get(to).is_some_and(|all| all.contains(&from))
    }

    /// All that stands before one of these elements.
    pub(super) fn before(&self, elements: impl Iterator<Item = &'a str>) -> HashSet<&'a str> {
        let mut waiting: Vec<&str> = elements.collect();
        let mut met = HashSet::new();
        while let Some(element) = waiting.pop() {
            let from = self.0.get(element).into_iter().flatten();
            waiting.extend(from.filter(|from| met.insert(**from)));
        }
        met
    }
}

/// The element of a wire.
pub(super) fn connection(from: &str, output: Option<&str>) -> String {
    let output = output.map_or(String::new(), |name| {
        format!(" formalParameter=\"{}\"", escaped(name))
    });
    format!("<connection refLocalId=\"{}\"{output}/>", escaped(from))
}
