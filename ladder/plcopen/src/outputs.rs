//! The circuits of a network, one for each output: what they have in common appears once.

use crate::anew::reads_anew;
use crate::apart::apart;
use crate::circuit::{Circuit, below, heads, leaves, size, within};
use crate::effects::Effects;
use crate::flow::Flow;
use crate::network::{Element, Network};
use crate::ways::Ways;
use crate::{pins, unused};
use std::collections::{BTreeSet, HashMap, HashSet};
use unoclp_lang::Code;

/// The circuits of a network, in the order in which they run.
pub(crate) fn circuits(flow: &mut Flow<'_, '_, '_>) -> Vec<Circuit> {
    let network = flow.network;
    let mut made = Made::default();
    let mut labels = labels(network).into_iter().peekable();
    pins::check(network, flow.found);
    unused::check(network, flow.found, &|element: &Element<'_, '_>| {
        element.remembers()
    });
    for at in unknown(network) {
        let kind = network.elements[at].kind;
        flow.tell(Code::XmlElement, at, [kind.into()]);
    }
    let is_block = |element: &Element<'_, '_>| element.remembers();
    let (sinks, apart) = sinks(network, &is_block, false);
    flow.apart = apart;
    for sink in sinks {
        let top = network.elements[sink].place.0;
        while labels.next_if(|label| *label <= top).is_some() {
            (made.since, made.jump) = (made.circuits.len(), None);
        }
        made.output(sink, flow);
    }
    // What nothing has asked for is called all the same.
    (made.since, made.jump) = (made.circuits.len(), None);
    for at in (0..network.elements.len()).filter(|at| network.elements[*at].remembers()) {
        if !flow.is_called(at) {
            made.output(at, flow);
        }
    }
    once(network, &made.circuits, flow);
    made.circuits
}

/// Circuits as they are made.
#[derive(Default)]
struct Made {
    circuits: Vec<Circuit>,
    /// What each of them reads and writes.
    effects: Vec<Effects>,
    /// Those that begin with an element.
    by_head: HashMap<usize, Vec<usize>>,
    /// What is drawn after a label or a jump is after it: in no circuit before this one, and where that has the
    /// jump, after that.
    since: usize,
    jump: Option<usize>,
}

impl Made {
    /// Adds what ends at this element, and what has to come before it.
    fn output(&mut self, sink: usize, flow: &mut Flow<'_, '_, '_>) {
        let element = &flow.network.elements[sink];
        if is_leave(element) {
            self.since = self.since.max(self.circuits.len().saturating_sub(1));
        }
        if let Some(order) = element.order
            && flow.calls.contains_key(&sink)
        {
            // Something that comes before it has asked for its result.
            flow.tell(Code::XmlOrder, sink, [order.to_string().into()]);
            return;
        }
        let circuit = flow.output(sink);
        let before = std::mem::take(&mut flow.before);
        let is_alone = before.is_empty();
        for (_, circuit) in before {
            self.push(circuit, flow);
        }
        if circuit.is_none() && !flow.found.has_errors() {
            flow.tell(Code::XmlTangle, sink, []);
        }
        if let Some(circuit) = circuit.filter(|circuit| !circuit.is_empty()) {
            self.add(circuit, sink, is_alone, flow);
        }
    }

    fn push(&mut self, circuit: Circuit, flow: &Flow<'_, '_, '_>) {
        self.effects.push(effects(&circuit, flow));
        self.circuits.push(circuit);
    }

    /// Adds the circuit of an output, to one that begins alike where it may be there.
    fn add(
        &mut self,
        mut circuit: Circuit,
        sink: usize,
        may_join: bool,
        flow: &mut Flow<'_, '_, '_>,
    ) {
        let mut begins = Vec::new();
        heads(&circuit, &mut |head| begins.push(head));
        let at = match may_join {
            true => self.join(&mut circuit, &begins, sink, flow),
            false => None,
        };
        let at = at.unwrap_or_else(|| {
            self.push(circuit, flow);
            self.circuits.len() - 1
        });
        if is_leave(&flow.network.elements[sink]) {
            (self.since, self.jump) = (at, Some(sink));
        }
        for head in begins {
            let known = self.by_head.entry(head).or_default();
            if known.last() != Some(&at) {
                known.push(at);
            }
        }
    }

    /// Puts a circuit into the last one that begins alike, unless something between them would then come too late.
    fn join(
        &mut self,
        circuit: &mut Circuit,
        begins: &[usize],
        sink: usize,
        flow: &mut Flow<'_, '_, '_>,
    ) -> Option<usize> {
        let known = begins.iter().filter_map(|head| self.by_head.get(head));
        let like: BTreeSet<usize> = known
            .flat_map(|at| at.iter().rev().take_while(|at| **at >= self.since))
            .copied()
            .collect();
        let own = effects(circuit, flow);
        let mut between = self.circuits.len();
        for at in like.into_iter().rev() {
            let looked_at = size(&self.circuits[at]) + (between - at) * own.len();
            flow.spend(sink, looked_at)?;
            // What is common stands where it did.
            let mut passed = self.effects[at + 1..between].iter();
            if passed.any(|passed| own.meet(passed)) {
                return None;
            }
            between = at + 1;
            if reads_anew(&self.circuits[at], circuit, flow.network) {
                return None;
            }
            let behind = self.jump.filter(|_| at == self.since);
            // Outputs within the other circuit come before the rest of it.
            let before = &self.effects[at];
            let may = [!before.feeds(&own), !own.feeds(before)];
            if join((&mut self.circuits[at], circuit), may, sink, behind) {
                self.effects[at].extend(own);
                return Some(at);
            }
        }
        None
    }
}

/// Whether an element leaves what follows out.
fn is_leave(element: &Element<'_, '_>) -> bool {
    matches!(element.kind, "jump" | "return")
}

fn effects(circuit: &Circuit, flow: &Flow<'_, '_, '_>) -> Effects {
    Effects::of(circuit, |at| flow.all.timers.get(&(flow.pou, at)).copied())
}

/// Makes one of two circuits that begin alike, where the output comes after this jump; else it leaves both as they are. `may`:
/// whether the outputs of the first may be within the second, and those of the second within the first.
fn join(
    (into, circuit): (&mut Circuit, &mut Circuit),
    may: [bool; 2],
    sink: usize,
    jump: Option<usize>,
) -> bool {
    let before = jump.map(|jump| (jump, into.clone(), circuit.clone()));
    let mut joined = below(into, circuit);
    if !joined && may[0] && within(circuit, into) {
        std::mem::swap(into, circuit);
        joined = true;
    }
    joined = joined || may[1] && within(into, circuit);
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

/// What remembers something appears once in a program.
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

/// The elements at which power ends, in the order in which they run: from top to bottom, between two labels or jumps
/// those first that have an order. What is a function block, is asked. In a text all
/// coils are among them; else those which lead on, but run apart, and these once more by themselves.
pub(crate) fn sinks(
    network: &Network<'_, '_>,
    is_block: &dyn Fn(&Element<'_, '_>) -> bool,
    is_text: bool,
) -> (Vec<usize>, HashSet<usize>) {
    let mut sinks = Vec::new();
    for (at, element) in network.elements.iter().enumerate() {
        let mut readers = network.readers[at].iter();
        let leads_on = readers.any(|reader| !network.is_end(reader.at));
        match element.kind {
            _ if element.is_loose() => {}
            "contact" if !leads_on && element.wires("").is_empty() => {}
            "block" if element.order.is_some() && is_block(element) => sinks.push(at),
            "coil" if is_text => sinks.push(at),
            "coil" | "contact" | "block" if !leads_on => sinks.push(at),
            "inOutVariable" if element.wires("").is_empty() => {}
            "outVariable" | "inOutVariable" | "jump" | "return" => sinks.push(at),
            _ => {}
        }
    }
    let parts = |at: &usize| matches!(network.elements[*at].kind, "label" | "jump" | "return");
    let mut parting: Vec<_> = (0..network.elements.len())
        .filter(parts)
        .map(|at| network.turn(at))
        .collect();
    parting.sort_unstable();
    let turn = |&at: &usize| {
        let part = parting.partition_point(|parting| *parting < network.turn(at));
        let order = order(network, at).unwrap_or(u32::MAX);
        // In a block diagram those come last that nothing has asked for.
        let is_last = network.is_blocks && network.elements[at].kind == "block";
        (part, parts(&at), order, is_last, network.turn(at))
    };
    sinks.sort_by_cached_key(turn);
    let turns: Vec<_> = sinks.iter().map(turn).collect();
    let apart = apart(network, &sinks, |at| {
        turns.partition_point(|other| *other < turn(&at))
    });
    sinks.extend(&apart);
    sinks.sort_by_cached_key(turn);
    (sinks, apart)
}

/// The elements that no ladder has.
pub(crate) fn unknown(network: &Network<'_, '_>) -> Vec<usize> {
    let elements = network.elements.iter().enumerate();
    let is_known = |element: &Element<'_, '_>| match element.kind {
        "coil" | "contact" | "block" | "inVariable" | "outVariable" | "inOutVariable" => true,
        "jump" | "return" | "label" | "comment" | "connector" | "continuation" => true,
        "leftPowerRail" | "rightPowerRail" => true,
        // What a maker adds beside the ladder, such as a title of a rung.
        "vendorElement" => element.inputs.is_empty() && element.outputs.is_empty(),
        _ => false,
    };
    let unknown = elements.filter(|(_, element)| !is_known(element));
    unknown.map(|(at, _)| at).collect()
}

/// The order of an output: its own, else that of the function whose result it takes.
fn order(network: &Network<'_, '_>, at: usize) -> Option<u32> {
    let element = &network.elements[at];
    let [wire] = element.wires("") else {
        return element.order;
    };
    let from = &network.elements[wire.from];
    let of_function = from
        .order
        .filter(|_| from.kind == "block" && !from.remembers());
    element.order.or(of_function)
}
