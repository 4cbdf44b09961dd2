//! What circuits read and write: which of them may change places.

use crate::circuit::{Circuit, Leaf, leaves};
use std::collections::HashSet;
use unoclp_core::isa::{Class, Kind};
use unoclp_draw::edit::Step;
use unoclp_point::Address;

/// The points that circuits read and write.
#[derive(Default)]
pub(crate) struct Effects {
    reads: HashSet<Address>,
    writes: HashSet<Address>,
}

impl Effects {
    /// Those of a circuit; `timer` says which timer an element calls, which its instruction does not.
    pub(crate) fn of(circuit: &Circuit, timer: impl Fn(usize) -> Option<u8>) -> Effects {
        let mut effects = Effects::default();
        leaves(circuit, &mut |leaf| effects.leaf(leaf, &timer));
        effects
    }

    fn leaf(&mut self, leaf: &Leaf, timer: &impl Fn(usize) -> Option<u8>) {
        let steps = leaf
            .parts
            .iter()
            .flat_map(|part| part.load.iter().chain([&part.step]));
        for step in steps {
            let class = step.class();
            let point = match class {
                Class::Timer => timer(leaf.key.0).map(Address::Timer),
                _ => point(step),
            };
            let writes = matches!(
                class,
                Class::Coil | Class::Timer | Class::Count | Class::Store
            );
            match writes {
                true => self.writes.extend(point),
                false => self.reads.extend(point),
            }
        }
    }

    /// Both together.
    pub(crate) fn extend(&mut self, other: Effects) {
        self.reads.extend(other.reads);
        self.writes.extend(other.writes);
    }

    /// How many points they are.
    pub(crate) fn len(&self) -> usize {
        self.reads.len() + self.writes.len()
    }

    /// Whether the other reads what this one writes.
    pub(crate) fn feeds(&self, other: &Effects) -> bool {
        self.writes.iter().any(|point| other.reads.contains(point))
    }

    /// Whether it matters which of both comes first.
    pub(crate) fn meet(&self, other: &Effects) -> bool {
        let written = |point| other.writes.contains(point);
        self.reads.iter().any(written)
            || self.writes.iter().any(written)
            || self.writes.iter().any(|point| other.reads.contains(point))
    }
}

/// The point that an instruction of an import names.
pub(crate) fn point(step: &Step) -> Option<Address> {
    let number = step.number()?;
    match step.opcode().row().kind {
        Kind::Time | Kind::Timer => Some(Address::Timer(number)),
        kind => Address::in_code(kind, number),
    }
}
