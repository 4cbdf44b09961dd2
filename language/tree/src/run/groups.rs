//! Cells that are eight bits of the board as one number.
//!
//! Owns that they have no value of their own: each bit is where its point is.

use crate::{Tree, Value};
use unoclp_point::Address;

/// Such a cell, and those of its bits, the lowest first; none where the board lacks the bit.
#[derive(Clone, Copy, Debug)]
struct Group {
    cell: usize,
    bits: [Option<usize>; 8],
}

/// Those of a tree.
pub(super) fn of(tree: &Tree) -> Groups {
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
    Groups(groups.collect())
}

/// All of a tree.
#[derive(Clone, Debug, Default)]
pub(super) struct Groups(Vec<Group>);

impl Groups {
    fn of(&self, cell: usize) -> Option<&Group> {
        self.0.iter().find(|group| group.cell == cell)
    }

    /// What a cell of this memory holds.
    pub(super) fn held(&self, memory: &[Value], cell: usize) -> Option<Value> {
        let Some(group) = self.of(cell) else {
            return memory.get(cell).cloned();
        };
        let bits = (0..).zip(group.bits).map(|(at, bit)| {
            let bit = bit.and_then(|bit| memory.get(bit));
            i128::from(bit.is_some_and(Value::is_true)) << at
        });
        Some(Value::Int(bits.sum()))
    }

    /// Stores a value in a cell of this memory; of a number that is eight bits, each where it is.
    pub(super) fn write(&self, memory: &mut [Value], cell: usize, value: Value) {
        let Some(group) = self.of(cell) else {
            if let Some(held) = memory.get_mut(cell) {
                *held = value;
            }
            return;
        };
        let number = value.int();
        for (at, bit) in group.bits.into_iter().enumerate() {
            if let Some(held) = bit.and_then(|bit| memory.get_mut(bit)) {
                *held = Value::truth(number >> at & 1 != 0);
            }
        }
    }
}
