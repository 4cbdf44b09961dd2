//! Contacts of several outputs, which each output reads again, as in OpenPLC: one output may have changed what the next reads.
//!
//! Owns whether a contact that is read once for two outputs says the same as read for each. Must not know how circuits become
//! one. What a block gives is computed once there too.

use crate::circuit::{Circuit, Item, Key, Leaf, leaves};
use crate::effects::point;
use crate::network::{Network, edge};
use crate::xml::says;
use std::collections::HashSet;
use unoclp_point::Address;

/// Whether a circuit would read something else, once the outputs of this one have run, where both begin alike.
pub(crate) fn reads_anew(of: &Circuit, circuit: &Circuit, network: &Network<'_, '_>) -> bool {
    let mut shared = HashSet::new();
    leaves(circuit, &mut |leaf| {
        shared.insert(leaf.key);
    });
    let mut look = Look {
        network,
        shared,
        seen: Vec::new(),
        is_anew: false,
    };
    look.series(of, true);
    look.is_anew
}

struct Look<'n, 'a, 'x> {
    network: &'n Network<'a, 'x>,
    /// What both circuits go through.
    shared: HashSet<Key>,
    /// The contacts of those so far: their points, and whether they are normally closed.
    seen: Vec<(Address, bool)>,
    is_anew: bool,
}

impl Look<'_, '_, '_> {
    /// Goes along a series; whether all on the way to it is shared.
    fn series(&mut self, series: &[Item], mut is_all: bool) {
        let before = self.seen.len();
        for item in series {
            match item {
                Item::Leaf(leaf) if leaf.is_output => self.output(leaf, is_all),
                Item::Leaf(leaf) if self.shared.contains(&leaf.key) => self.passed(leaf, before),
                Item::Leaf(leaf) => {
                    is_all = false;
                    self.writes(leaf);
                }
                Item::Parallel { ways, ends } => {
                    for way in ways {
                        self.series(way, is_all && *ends);
                    }
                }
                // An edge remembers what it was.
                Item::Gate(..) => {}
            }
        }
    }

    /// A contact, or a block, whose result stays.
    fn passed(&mut self, leaf: &Leaf, before: usize) {
        let Some(element) = self.network.elements.get(leaf.key.0) else {
            return;
        };
        let is_read = matches!(element.kind, "contact" | "inVariable" | "inOutVariable");
        if !is_read || leaf.key.1 != 0 || !edge(element.node).is_empty() {
            return self.seen.truncate(before);
        }
        let points = leaf.parts.iter().filter_map(|part| point(&part.step));
        let is_closed = says(element.node, "negated");
        self.seen.extend(points.map(|point| (point, is_closed)));
    }

    /// A block of this circuit alone changes what it is read by.
    fn writes(&mut self, leaf: &Leaf) {
        let mut points = leaf.parts.iter().filter_map(|part| point(&part.step));
        let is_block = self.network.elements.get(leaf.key.0);
        let is_block = is_block.is_some_and(|element| element.kind == "block");
        self.is_anew |= is_block && points.any(|of| self.seen.iter().any(|(seen, _)| *seen == of));
    }

    /// A coil changes nothing for those contacts that say of it, by themselves, what brought it there: one that is set by its
    /// own power through normally open ones, or reset through normally closed ones.
    fn output(&mut self, leaf: &Leaf, is_all: bool) {
        let Some(element) = self.network.elements.get(leaf.key.0) else {
            return;
        };
        let is_coil = element.kind == "coil" && edge(element.node).is_empty();
        let negated = says(element.node, "negated");
        let keeps = |is_closed: bool| match (element.node.attribute("storage"), negated) {
            (Some("set"), false) => !is_closed,
            (Some("reset"), false) => is_closed,
            (Some("set" | "reset"), true) => false,
            _ => is_all && is_closed == negated,
        };
        for written in leaf.parts.iter().filter_map(|part| point(&part.step)) {
            let mut seen = self.seen.iter().filter(|(seen, _)| *seen == written);
            self.is_anew |= seen.any(|(_, is_closed)| !(is_coil && keeps(*is_closed)));
        }
    }
}
