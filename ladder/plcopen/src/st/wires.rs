//! What wires do besides carrying power: they form loops, and rungs write what they read.

use super::what::What;
use crate::network::Network;
use std::collections::{HashMap, HashSet};

/// The elements whose wires lead back to them, and through no function block.
pub(super) fn circles(network: &Network<'_, '_>, own: &[What]) -> Vec<bool> {
    let before = |at: usize| -> Vec<usize> {
        let element = &network.elements[at];
        let wires = element.inputs.iter().flat_map(|pin| &pin.wires);
        let wires = wires.filter(|wire| own[wire.from] != What::Block);
        let mut from: Vec<usize> = wires.map(|wire| wire.from).collect();
        if element.kind == "continuation" {
            from.extend(network.connector(at));
        }
        from
    };
    let count = network.elements.len();
    let (mut order, mut low) = (vec![0_usize; count], vec![0_usize; count]);
    let (mut waits, mut is_waiting) = (Vec::new(), vec![false; count]);
    let (mut next, mut found) = (1, vec![false; count]);
    for start in 0..count {
        let mut open = match order[start] {
            0 => vec![(start, before(start), 0)],
            _ => continue,
        };
        while let Some((at, from, looked)) = open.last_mut() {
            let at = *at;
            if *looked == 0 {
                (order[at], low[at]) = (next, next);
                next += 1;
                waits.push(at);
                is_waiting[at] = true;
                found[at] = from.contains(&at);
            }
            if let Some(&other) = from.get(*looked) {
                *looked += 1;
                if order[other] == 0 {
                    let others = before(other);
                    open.push((other, others, 0));
                } else if is_waiting[other] {
                    low[at] = low[at].min(order[other]);
                }
                continue;
            }
            if low[at] == order[at] {
                let first = waits.iter().rposition(|of| *of == at).unwrap_or(0);
                let circle = waits.split_off(first);
                for of in &circle {
                    is_waiting[*of] = false;
                    found[*of] |= circle.len() > 1;
                }
            }
            let of = low[at];
            open.pop();
            if let Some((before, ..)) = open.last() {
                low[*before] = low[*before].min(of);
            }
        }
    }
    found
}

/// The elements of rungs that write what they read.
pub(super) fn rewrites(network: &Network<'_, '_>, own: &[What]) -> Vec<bool> {
    let name = |written: &str| -> String {
        let name = written.split(['.', '[']).next().unwrap_or_default();
        name.trim().to_uppercase()
    };
    let mut written: HashMap<usize, HashSet<String>> = HashMap::new();
    for (at, element) in network.elements.iter().enumerate() {
        let is_out = match element.kind {
            "coil" | "outVariable" => true,
            "inOutVariable" => !element.wires("").is_empty(),
            _ => false,
        };
        if is_out {
            let rung = written.entry(network.rung(at)).or_default();
            rung.insert(name(&element.written));
        }
    }
    let mut rungs = HashSet::new();
    for (at, element) in network.elements.iter().enumerate() {
        let reads = matches!(element.kind, "contact" | "inVariable" | "inOutVariable");
        let rung = network.rung(at);
        let is_written = |of: &HashSet<String>| of.contains(&name(&element.written));
        if reads && written.get(&rung).is_some_and(is_written) {
            rungs.insert(rung);
        }
    }
    let all = 0..own.len();
    all.map(|at| rungs.contains(&network.rung(at))).collect()
}

/// The elements that call an instance.
pub(super) struct Calls {
    /// From top to bottom.
    pub all: Vec<usize>,
    /// How many of them have been asked for.
    pub made: usize,
}

/// The calls of each instance, by its name in capitals.
pub(super) fn instances(network: &Network<'_, '_>) -> HashMap<String, Calls> {
    let mut instances: HashMap<String, Calls> = HashMap::new();
    for (at, element) in network.elements.iter().enumerate() {
        if let Some(name) = element.node.attribute("instanceName") {
            let (all, made) = (Vec::new(), 0);
            let calls = instances.entry(name.to_uppercase());
            calls.or_insert(Calls { all, made }).all.push(at);
        }
    }
    for calls in instances.values_mut() {
        calls.all.sort_by_key(|at| network.turn(*at));
    }
    instances
}

/// The labels of a network, the first at the end; of several with one name, the first.
pub(super) fn labels(network: &Network<'_, '_>) -> Vec<usize> {
    let mut labels: Vec<usize> = (0..network.elements.len()).collect();
    labels.retain(|at| network.elements[*at].kind == "label");
    labels.sort_by_key(|at| network.turn(*at));
    let mut named = HashSet::new();
    labels.retain(|at| named.insert(network.elements[*at].node.attribute("label")));
    labels.reverse();
    labels
}
