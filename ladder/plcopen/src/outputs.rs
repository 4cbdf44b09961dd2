//! The circuits of a network, one for each output: what they have in common stands once.

use crate::circuit::{Circuit, below, heads, leaves, within};
use crate::flow::Flow;
use crate::network::{Element, Network};
use std::collections::{HashMap, HashSet};
use unoclp_lang::Code;

/// The circuits of a network, each with its place.
pub(crate) fn circuits(flow: &mut Flow<'_, '_, '_>) -> Vec<Circuit> {
    let network = flow.network;
    let mut circuits: Vec<Circuit> = Vec::new();
    let mut by_head: HashMap<usize, Vec<usize>> = HashMap::new();
    let mut labels = labels(network).into_iter().peekable();
    // What is drawn behind a label or a jump stands behind it: in no circuit before this one, and where that has the
    // jump, behind that.
    let (mut since, mut jump) = (0, None);
    for sink in sinks(flow) {
        let top = network.elements[sink].place.0;
        while labels.next_if(|label| *label <= top).is_some() {
            (since, jump) = (circuits.len(), None);
        }
        let is_jump = matches!(network.elements[sink].kind, "jump" | "return");
        if is_jump {
            since = since.max(circuits.len().saturating_sub(1));
        }
        let circuit = flow.output(sink);
        let before = std::mem::take(&mut flow.before);
        let is_alone = before.is_empty();
        for (_, circuit) in before {
            circuits.push(circuit);
        }
        if circuit.is_none() && !flow.found.has_errors() {
            flow.tell(Code::XmlTangle, sink, []);
        }
        let Some(mut circuit) = circuit.filter(|circuit| !circuit.is_empty()) else {
            continue;
        };
        let mut begins = Vec::new();
        heads(&circuit, &mut |head| begins.push(head));
        let like: HashSet<usize> = begins
            .iter()
            .filter_map(|head| by_head.get(head))
            .flatten()
            .copied()
            .filter(|at| is_alone && *at >= since)
            .collect();
        let mut like: Vec<usize> = like.into_iter().collect();
        like.sort_unstable_by(|one, other| other.cmp(one));
        let joined = like.into_iter().find(|&at| {
            let behind = jump.filter(|_| at == since);
            join(&mut circuits[at], &mut circuit, sink, behind)
        });
        let at = joined.unwrap_or_else(|| {
            circuits.push(circuit);
            circuits.len() - 1
        });
        if is_jump {
            (since, jump) = (at, Some(sink));
        }
        for head in begins {
            by_head.entry(head).or_default().push(at);
        }
    }
    once(network, &circuits, flow);
    circuits
}

/// Makes one of two circuits that begin alike, where the output comes behind this jump; else it leaves both as they are.
fn join(into: &mut Circuit, circuit: &mut Circuit, sink: usize, jump: Option<usize>) -> bool {
    let before = jump.map(|jump| (jump, into.clone(), circuit.clone()));
    let mut joined = below(into, circuit);
    if !joined && within(circuit, into) {
        std::mem::swap(into, circuit);
        joined = true;
    }
    joined = joined || within(into, circuit);
    let Some((jump, old, own)) = before else {
        return joined;
    };
    let mut order = Vec::new();
    leaves(into, &mut |leaf| order.push(leaf.key.0));
    let place = |of: usize| order.iter().position(|at| *at == of);
    if joined && place(jump) > place(sink) {
        (*into, *circuit) = (old, own);
        return false;
    }
    joined
}

/// The heights at which labels are drawn, from top to bottom.
fn labels(network: &Network<'_, '_>) -> Vec<i64> {
    let labels = network.elements.iter().filter(|e| e.kind == "label");
    let mut heights: Vec<i64> = labels.map(|label| label.place.0).collect();
    heights.sort_unstable();
    heights
}

/// What remembers something stands once in a program.
fn once(network: &Network<'_, '_>, circuits: &[Circuit], flow: &mut Flow<'_, '_, '_>) {
    let mut seen = HashSet::new();
    let mut twice = Vec::new();
    for circuit in circuits {
        leaves(circuit, &mut |leaf| {
            if leaf.is_once && !seen.insert(leaf.key) {
                twice.push(leaf.key.0);
            }
        });
    }
    twice.retain(|&at| at < network.elements.len());
    for at in twice {
        flow.tell(Code::XmlTangle, at, []);
    }
}

/// The elements at which power ends, from top to bottom.
fn sinks(flow: &mut Flow<'_, '_, '_>) -> Vec<usize> {
    let network = flow.network;
    let mut leads_on = vec![false; network.elements.len()];
    let continued: HashSet<_> = network
        .elements
        .iter()
        .filter(|e| e.kind == "continuation")
        .map(|e| e.node.attribute("name"))
        .collect();
    // A right rail leads nowhere, nor does a connector that nothing continues.
    let takes = |element: &&Element<'_, '_>| match element.kind {
        "connector" => continued.contains(&element.node.attribute("name")),
        _ => !element.is_right_rail(),
    };
    for element in network.elements.iter().filter(takes) {
        for wire in element.inputs.iter().flat_map(|pin| &pin.wires) {
            leads_on[wire.from] = true;
        }
    }
    let mut sinks = Vec::new();
    for (at, element) in network.elements.iter().enumerate() {
        match element.kind {
            "coil" | "contact" | "block" if !leads_on[at] => sinks.push(at),
            "coil" | "contact" | "block" => {}
            "outVariable" | "jump" | "return" => sinks.push(at),
            "leftPowerRail" | "rightPowerRail" | "comment" | "label" | "inVariable" => {}
            "connector" | "continuation" | "inOutVariable" => {}
            kind => flow.tell(Code::XmlElement, at, [kind.into()]),
        }
    }
    sinks.sort_by_key(|&at| (network.elements[at].place, at));
    sinks
}
