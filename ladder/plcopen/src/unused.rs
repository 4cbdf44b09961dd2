//! Parts of a network that do nothing: they lead to no output, or nothing leads to them.

use crate::found::Found;
use crate::network::{Element, Network};
use crate::pins::inputs;
use std::collections::HashSet;
use unoclp_lang::{Code, Word};

/// Tells of networks without an output, at their ends; of circles that nothing leaves; of labels that no jump leads to.
/// What is a function block, is asked.
pub(crate) fn check(
    network: &Network<'_, '_>,
    found: &mut Found,
    is_block: &dyn Fn(&Element<'_, '_>) -> bool,
) {
    let acts = |at: &usize| acts(&network.elements[*at], is_block);
    let outputs = (0..network.elements.len()).filter(acts);
    let mut does = vec![false; network.elements.len()];
    leading_to(network, outputs, &mut does);
    let idle: Vec<usize> = (0..network.elements.len())
        .filter(|at| !does[*at] && is_drawn(&network.elements[*at]))
        .collect();
    let ends = idle.iter().filter(|at| readers(network, **at).is_empty());
    let ends: Vec<usize> = ends.copied().collect();
    for &end in &ends {
        let what = what(&network.elements[end]);
        network.tell(found, Code::XmlNoSink, end, [what]);
    }
    leading_to(network, ends.into_iter(), &mut does);
    for at in idle {
        if does[at] {
            continue;
        }
        let inside = circle(network, at);
        if network.is_blocks {
            // Wires may lead back; these lead nowhere else.
            let what = what(&network.elements[inside]);
            network.tell(found, Code::XmlNoSink, inside, [what]);
        } else {
            network.tell(found, Code::XmlLoop, inside, []);
        }
        leading_to(network, std::iter::once(inside), &mut does);
    }
    let loose = (0..network.elements.len()).filter(|at| network.elements[*at].is_loose());
    // A wire that comes from nowhere is told itself.
    let loose = loose.filter(|at| {
        let mut parts = network.elements[*at].node.descendants();
        !parts.any(|part| part.tag_name().name() == "connection")
    });
    loose.for_each(|at| network.tell(found, Code::XmlLoose, at, []));
    labels(network, found);
}

/// Whether an element does something by itself.
fn acts(element: &Element<'_, '_>, is_block: &dyn Fn(&Element<'_, '_>) -> bool) -> bool {
    match element.kind {
        "inOutVariable" => !element.wires("").is_empty(),
        // One that is not imported is told otherwise.
        "block" => is_block(element) || inputs(&element.block()).is_none(),
        kind => matches!(kind, "coil" | "outVariable" | "jump" | "return"),
    }
}

/// Whether an element does something only where it leads to one that acts.
fn is_drawn(element: &Element<'_, '_>) -> bool {
    let kinds = [
        "contact",
        "block",
        "inVariable",
        "inOutVariable",
        "connector",
        "continuation",
    ];
    kinds.contains(&element.kind)
}

/// Marks these elements, and all that leads to them.
fn leading_to(network: &Network<'_, '_>, to: impl Iterator<Item = usize>, marked: &mut [bool]) {
    let mut open: Vec<usize> = to.collect();
    while let Some(at) = open.pop() {
        if std::mem::replace(&mut marked[at], true) {
            continue;
        }
        let element = &network.elements[at];
        let wires = element.inputs.iter().flat_map(|pin| &pin.wires);
        open.extend(wires.map(|wire| wire.from));
        if element.kind == "continuation" {
            open.extend(network.connector(at));
        }
    }
}

/// The elements that one leads to, ends left out.
fn readers(network: &Network<'_, '_>, at: usize) -> Vec<usize> {
    if network.elements[at].kind == "connector" {
        return network.continuations(at).to_vec();
    }
    let readers = network.readers[at].iter().map(|reader| reader.at);
    readers
        .filter(|reader| network.elements[*reader].kind != "rightPowerRail")
        .collect()
}

/// An element of the circle to which this one leads, as all that it leads to does.
fn circle(network: &Network<'_, '_>, mut at: usize) -> usize {
    let mut seen = HashSet::new();
    while seen.insert(at) {
        match readers(network, at).first() {
            Some(next) => at = *next,
            None => break,
        }
    }
    at
}

fn labels(network: &Network<'_, '_>, found: &mut Found) {
    let named = |kind| {
        let elements = network.elements.iter().enumerate();
        elements
            .filter(move |(_, element)| element.kind == kind)
            .map(|(at, element)| (at, element.node.attribute("label").unwrap_or_default()))
    };
    let jumps: HashSet<&str> = named("jump").map(|(_, label)| label).collect();
    for (at, label) in named("label") {
        if !jumps.contains(label) {
            network.tell(found, Code::XmlNoJump, at, [label.into()]);
        }
    }
}

/// What an element is called.
fn what(element: &Element<'_, '_>) -> Word {
    let name = match element.kind {
        "block" => element.node.attribute("typeName"),
        "connector" | "continuation" => element.node.attribute("name"),
        _ => Some(&*element.written),
    };
    name.filter(|name| !name.is_empty())
        .unwrap_or(element.kind)
        .into()
}
