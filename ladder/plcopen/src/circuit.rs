//! What is in series and in parallel on the path of the power to an output.

use unoclp_draw::edit::{Gate, Step};

/// A way of the power, from the left rail.
pub(crate) type Circuit = Vec<Item>;

/// What a piece of a circuit is known by: its element, and which part of that.
pub(crate) type Key = (usize, usize);

/// A piece of a circuit.
#[derive(Clone, Debug)]
pub(crate) enum Item {
    Leaf(Leaf),
    /// Ways beside each other; all of them end in outputs, or they come together again.
    Parallel {
        ways: Vec<Circuit>,
        ends: bool,
    },
    /// A way of its own from the left rail, whose result meets what is before it.
    Gate(Key, Gate, Circuit),
}

/// Instructions that stay together.
#[derive(Clone, Debug)]
pub(crate) struct Leaf {
    pub key: Key,
    pub parts: Vec<Part>,
    /// Whether it is an output, which leaves the power as it is.
    pub is_output: bool,
    /// Whether it may be in a program once only.
    pub is_once: bool,
}

/// An instruction; of a comparison with what it looks at.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub load: Option<Step>,
    pub step: Step,
}

impl From<Step> for Part {
    fn from(step: Step) -> Part {
        Part { load: None, step }
    }
}

impl Leaf {
    /// One instruction without a memory.
    pub(crate) fn plain(key: Key, step: Step) -> Leaf {
        Leaf::of(key, vec![step.into()])
    }

    /// These instructions, without a memory.
    pub(crate) fn of(key: Key, parts: Vec<Part>) -> Leaf {
        Leaf {
            key,
            parts,
            is_output: false,
            is_once: false,
        }
    }

    pub(crate) fn once(self) -> Leaf {
        Leaf {
            is_once: true,
            ..self
        }
    }

    pub(crate) fn output(self) -> Leaf {
        Leaf {
            is_output: true,
            ..self
        }
    }
}

impl Item {
    fn is_output(&self) -> bool {
        matches!(self, Item::Leaf(leaf) if leaf.is_output)
    }

    /// Whether the power takes the same way through both; outputs on it do not count.
    fn same(&self, other: &Item) -> bool {
        match (self, other) {
            (Item::Leaf(one), Item::Leaf(other)) => one.key == other.key,
            (Item::Gate(one, ..), Item::Gate(other, ..)) => one == other,
            (
                Item::Parallel { ways: one, ends },
                Item::Parallel {
                    ways: other,
                    ends: other_ends,
                },
            ) => {
                ends == other_ends
                    && one.len() == other.len()
                    && one
                        .iter()
                        .zip(other)
                        .all(|(one, other)| same_way(one, other))
            }
            _ => false,
        }
    }
}

fn same_way(one: &[Item], other: &[Item]) -> bool {
    let conducts = |item: &&Item| !item.is_output();
    let (mut one, mut other) = (one.iter().filter(conducts), other.iter().filter(conducts));
    loop {
        match (one.next(), other.next()) {
            (None, None) => return true,
            (Some(one), Some(other)) if one.same(other) => {}
            _ => return false,
        }
    }
}

/// How many instructions a circuit has.
pub(crate) fn size(circuit: &[Item]) -> usize {
    let sizes = circuit.iter().map(|item| match item {
        Item::Leaf(leaf) => leaf.parts.len(),
        Item::Parallel { ways, .. } => 1 + ways.iter().map(|way| size(way)).sum::<usize>(),
        Item::Gate(_, _, circuit) => 1 + size(circuit),
    });
    sizes.sum()
}

/// Calls back for each leaf.
pub(crate) fn leaves<'c>(circuit: &'c [Item], to: &mut impl FnMut(&'c Leaf)) {
    for item in circuit {
        match item {
            Item::Leaf(leaf) => to(leaf),
            Item::Parallel { ways, .. } => ways.iter().for_each(|way| leaves(way, to)),
            Item::Gate(_, _, circuit) => leaves(circuit, to),
        }
    }
}

/// The elements that power reaches first.
pub(crate) fn heads(circuit: &[Item], to: &mut impl FnMut(usize)) {
    match circuit.first() {
        Some(Item::Leaf(leaf)) => to(leaf.key.0),
        Some(Item::Gate(key, ..)) => to(key.0),
        Some(Item::Parallel { ways, .. }) => ways.iter().for_each(|way| heads(way, to)),
        None => {}
    }
}

/// Ways that come together: what they begin with in common appears once, before the others.
pub(crate) fn together(mut ways: Vec<Circuit>) -> Circuit {
    let common = common(&ways);
    let mut circuit = match ways.first() {
        Some(first) => first[..common].to_vec(),
        None => return Circuit::new(),
    };
    for way in &mut ways {
        way.drain(..common);
    }
    if ways.iter().all(Vec::is_empty) {
        return circuit;
    }
    // Neighbours that begin alike branch off later.
    let mut groups: Vec<Vec<Circuit>> = Vec::new();
    for way in ways {
        let beside = |group: &Vec<Circuit>| match (group[0].first(), way.first()) {
            (Some(one), Some(other)) => one.same(other),
            _ => false,
        };
        match groups.last_mut() {
            Some(group) if beside(group) => group.push(way),
            _ => groups.push(vec![way]),
        }
    }
    let mut ways: Vec<Circuit> = groups.into_iter().map(together).collect();
    match ways.len() {
        1 => circuit.append(&mut ways[0]),
        _ => circuit.push(Item::Parallel { ways, ends: false }),
    }
    circuit
}

/// How many pieces all ways begin with in common.
fn common(ways: &[Circuit]) -> usize {
    let Some((first, others)) = ways.split_first() else {
        return 0;
    };
    let alike = |(at, item): &(usize, &Item)| {
        let mut others = others.iter();
        others.all(|other| other.get(*at).is_some_and(|other| item.same(other)))
    };
    first.iter().enumerate().take_while(alike).count()
}

/// How far two circuits are one, outputs in the first left out.
fn shared(into: &[Item], other: &[Item]) -> (usize, usize) {
    let (mut at, mut of_other) = (0, 0);
    while let Some(item) = into.get(at) {
        if item.is_output() {
            at += 1;
        } else if other.get(of_other).is_some_and(|other| item.same(other)) {
            (at, of_other) = (at + 1, of_other + 1);
        } else {
            break;
        }
    }
    (at, of_other)
}

/// Puts what is drawn below into a circuit where both begin alike; else it leaves both as they are.
pub(crate) fn below(into: &mut Circuit, other: &mut Circuit) -> bool {
    let (at, of_other) = shared(into, other);
    if of_other == 0 {
        return false;
    }
    if at == into.len() {
        into.extend(other.drain(of_other..));
        return true;
    }
    let mut rest = other.split_off(of_other);
    if let Some(Item::Parallel { ways, ends: true }) = into.get_mut(at) {
        if !ways.iter_mut().any(|way| below(way, &mut rest)) {
            ways.push(rest);
        }
        return true;
    }
    let ways = vec![into.split_off(at), rest];
    into.push(Item::Parallel { ways, ends: true });
    true
}

/// Puts outputs into a circuit that goes on where their power comes from; else it leaves both as they are.
pub(crate) fn within(into: &mut Circuit, outputs: &mut Circuit) -> bool {
    let (at, of_other) = shared(into, outputs);
    let is_end = outputs[of_other..].iter().all(Item::is_output);
    if of_other > 0 && is_end {
        into.splice(at..at, outputs.drain(of_other..));
        return true;
    }
    let Some(Item::Parallel { ways, .. }) = into.get_mut(at) else {
        return false;
    };
    // Outputs after the first ways of it alone: those come together before.
    if let Some(Item::Parallel { ways: own, .. }) = outputs.get(of_other)
        && own.len() < ways.len()
        && own
            .iter()
            .zip(&*ways)
            .all(|(one, other)| same_way(one, other))
        && outputs[of_other + 1..].iter().all(Item::is_output)
    {
        let first = ways.drain(..own.len()).collect();
        let first = Item::Parallel {
            ways: first,
            ends: false,
        };
        let behind = outputs.drain(of_other + 1..);
        ways.insert(0, std::iter::once(first).chain(behind).collect());
        return true;
    }
    let mut rest = outputs.split_off(of_other);
    let is_done = ways.iter_mut().any(|way| within(way, &mut rest));
    if !is_done {
        outputs.append(&mut rest);
    }
    is_done
}

/// A circuit, and this after it.
pub(crate) fn followed(mut circuit: Circuit, leaf: Leaf) -> Circuit {
    circuit.push(Item::Leaf(leaf));
    circuit
}
