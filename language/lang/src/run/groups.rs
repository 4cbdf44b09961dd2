//! Cells that are eight bits of the board as one number.
//!
//! Owns that they have no value of their own: each bit is where its point is.

use super::Machine;
use crate::typed::{Tree, Value};
use unoclp_point::Address;

/// Such a cell, and those of its bits, the lowest first; none where the board lacks the bit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Group {
    cell: usize,
    bits: [Option<usize>; 8],
}

/// Those of a tree.
pub(super) fn of(tree: &Tree) -> Vec<Group> {
    let points = tree.points.iter();
    let groups = points.filter_map(|(cell, point)| {
        let first: u8 = match point {
            Address::Group(number) => number.saturating_sub(1).saturating_mul(8),
            Address::Inputs(_) | Address::Outputs(_) => 0,
            _ => return None,
        };
        let bit = |at: u8| {
            let number = first.saturating_add(at + 1);
            let wanted = match point {
                Address::Group(_) => Address::Marker(number),
                Address::Inputs(_) => Address::Input(number),
                _ => Address::Output(number),
            };
            let mut points = tree.points.iter();
            let found = points.find(|(_, point)| *point == wanted);
            found.map(|(cell, _)| *cell as usize)
        };
        let bits = std::array::from_fn(|at| bit(at as u8));
        let cell = *cell as usize;
        Some(Group { cell, bits })
    });
    groups.collect()
}

impl Machine<'_> {
    pub(super) fn group(&self, cell: usize) -> Option<Group> {
        let mut groups = self.groups.iter();
        groups.find(|group| group.cell == cell).copied()
    }

    /// What a cell holds.
    pub(super) fn held(&self, cell: usize) -> Option<Value> {
        let Some(group) = self.group(cell) else {
            return self.memory.get(cell).cloned();
        };
        let bits = (0..).zip(group.bits).map(|(at, bit)| {
            let bit = bit.and_then(|bit| self.memory.get(bit));
            i128::from(bit.is_some_and(Value::is_true)) << at
        });
        Some(Value::Int(bits.sum()))
    }

    /// Stores the low bits of a number in those of a group.
    pub(super) fn spread(&mut self, group: Group, value: &Value) {
        let number = value.int();
        for (at, bit) in group.bits.into_iter().enumerate() {
            if let Some(held) = bit.and_then(|bit| self.memory.get_mut(bit)) {
                *held = Value::truth(number >> at & 1 != 0);
            }
        }
    }
}
