//! From a place to a cell.

use super::{Frame, Machine, Stop};
use crate::{Base, Place, Root, Value};

impl Machine<'_> {
    /// The cell of a place; none where a subscript is outside, which sets S 04.
    pub(super) fn cell_of(&mut self, place: &Place, frame: &Frame) -> Result<Option<usize>, Stop> {
        let root = match place.root {
            Root::Static => Some(0),
            Root::Own => Some(frame.own),
            Root::Local => Some(frame.local),
            Root::Lent(number) => frame.lent.get(number as usize).copied().flatten(),
        };
        let mut offset = place.offset as usize;
        let mut within = true;
        for index in &place.indices {
            let subscript = self.evaluate(&index.subscript, frame)?.int();
            let number = subscript - i128::from(index.low);
            if (0..i128::from(index.count)).contains(&number) {
                offset += number as usize * index.stride as usize;
            } else {
                self.fail(place.at);
                within = false;
            }
        }
        Ok(root.filter(|_| within).map(|root| root + offset))
    }

    pub(super) fn read(&mut self, place: &Place, base: Base, frame: &Frame) -> Result<Value, Stop> {
        let cell = self.cell_of(place, frame)?;
        let value = cell.and_then(|cell| self.groups.held(&self.memory, cell));
        Ok(value.unwrap_or_else(|| Value::zero(base)))
    }

    pub(super) fn write(&mut self, cell: Option<usize>, value: Value) {
        if let Some(cell) = cell {
            self.groups.write(&mut self.memory, cell, value);
        }
    }

    pub(super) fn copy(&mut self, to: Option<usize>, from: Option<usize>, cells: u32) {
        let (Some(to), Some(from)) = (to, from) else {
            return;
        };
        let count = cells as usize;
        let values = self.memory.get(from..from + count).map(<[Value]>::to_vec);
        if let (Some(values), Some(held)) = (values, self.memory.get_mut(to..to + count)) {
            held.clone_from_slice(&values);
        }
    }
}
