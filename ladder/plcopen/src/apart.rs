//! Coils in the middle of a path that run apart from it, as in OpenPLC: each coil has its own turn, and power passes it by.
//!
//! Owns which coils these are. Where nothing comes between a coil and the end of its path, both run as one.

use crate::network::Network;
use std::collections::HashSet;

/// The coils that lead on, but do not run right before the first output after them. `sinks`: the outputs in their order;
/// `turn`: where an element comes among them.
pub(crate) fn apart(
    network: &Network<'_, '_>,
    sinks: &[usize],
    turn: impl Fn(usize) -> usize,
) -> HashSet<usize> {
    let mut first = vec![None; network.elements.len()];
    for (place, sink) in sinks.iter().enumerate() {
        let mut open = vec![*sink];
        while let Some(at) = open.pop() {
            if first[at].is_none() {
                first[at] = Some(place);
                let pins = network.elements[at].inputs.iter();
                open.extend(pins.flat_map(|pin| &pin.wires).map(|wire| wire.from));
            }
        }
    }
    let is_sink: HashSet<usize> = sinks.iter().copied().collect();
    let coils = (0..network.elements.len()).filter(|at| network.elements[*at].kind == "coil");
    let leads_on = coils.filter(|at| !is_sink.contains(at));
    leads_on
        .filter(|at| first[*at].is_some_and(|place| place != turn(*at)))
        .collect()
}
