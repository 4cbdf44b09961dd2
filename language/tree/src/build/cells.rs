//! The cells of a variable, and what they begin with.

use super::builder::Builder;
use super::named::Traits;
use crate::standard::{Standard, counter};
use crate::{Base, Cell, Initial, Kind, TypeId, Value};

impl Builder<'_, '_> {
    /// The cells of a new variable with what they begin with.
    pub(super) fn initial_cells(&self, ty: TypeId, traits: &Traits) -> Vec<Cell> {
        let mut cells = Vec::new();
        self.push_cells(ty, &mut cells);
        if let Some(initial) = &traits.initial {
            self.fill(ty, initial, &mut cells);
        }
        for cell in &mut cells {
            // A block says of its own variables what is kept.
            cell.retain |= traits.retain;
        }
        cells
    }

    /// Appends the cells of a value, as its type begins them. Types nest no deeper than their declarations, which
    /// front ends limit.
    fn push_cells(&self, ty: TypeId, cells: &mut Vec<Cell>) {
        let start = cells.len();
        let one = |base, initial| Cell {
            base,
            initial,
            retain: false,
            scratch: false,
        };
        let kind = self.tree.types.kind(ty);
        match kind {
            Kind::Base(base) | Kind::Text { base, .. } => {
                cells.push(one(*base, Value::zero(*base)))
            }
            Kind::Enum(values) => cells.push(one(Base::Int, Value::Int(values.first().1.into()))),
            // Without a word about it, a subrange begins with its least value (IEC 61131-3, 2.3.3.2).
            Kind::Range { base, low, .. } => cells.push(one(*base, Value::Int(*low))),
            Kind::Array { of, .. } => {
                let size = self.tree.types.get(*of).cells as usize;
                let total = self.tree.types.get(ty).cells as usize;
                if size > 0 && total > 0 {
                    self.push_cells(*of, cells);
                    let element = cells[start..].to_vec();
                    for _ in 1..total / size {
                        cells.extend_from_slice(&element);
                    }
                }
            }
            Kind::Struct(members) => {
                for member in members {
                    let at = cells.len();
                    self.push_cells(member.ty, cells);
                    if let Some(initial) = &member.initial {
                        self.fill(member.ty, initial, &mut cells[at..]);
                    }
                }
            }
            Kind::Standard(block) => {
                let parts = block.parts().iter();
                cells.extend(parts.map(|part| one(part.1, Value::zero(part.1))));
                begin_outputs(*block, &mut cells[start..]);
            }
            Kind::Block(unit) => {
                if let Some(draft) = self.draft(*unit) {
                    cells.extend_from_slice(&draft.unit.own);
                }
            }
        }
        for initial in self.tree.types.initials(ty) {
            self.fill(ty, &initial, &mut cells[start..]);
        }
    }

    /// Puts first values into the cells of a value.
    fn fill(&self, ty: TypeId, initial: &Initial, cells: &mut [Cell]) {
        match initial {
            Initial::Value(value) => {
                if let Some(cell) = cells.first_mut() {
                    cell.initial = value.clone();
                }
            }
            Initial::Elements(elements) => {
                let Kind::Array { of, .. } = self.tree.types.kind(ty) else {
                    return;
                };
                let size = self.tree.types.get(*of).cells as usize;
                let mut at = 0;
                for (times, element) in elements {
                    for _ in 0..*times {
                        let Some(cells) = cells.get_mut(at..at + size) else {
                            return;
                        };
                        if let Some(element) = element {
                            self.fill(*of, element, cells);
                        }
                        at += size;
                    }
                }
            }
            Initial::Members(members) => {
                for (offset, ty, initial) in members {
                    if let Some(cells) = cells.get_mut(*offset as usize..) {
                        self.fill(*ty, initial, cells);
                    }
                }
                if let Kind::Standard(block) = self.tree.types.kind(ty) {
                    begin_outputs(*block, cells);
                }
            }
        }
    }
}

/// What a counter of the board says before its first call: that it is 0, and whether that is its preset.
fn begin_outputs(block: Standard, cells: &mut [Cell]) {
    if block != Standard::Counter {
        return;
    }
    let at = |part: u32| part as usize;
    let preset = cells.get(at(counter::PRESET));
    let reached = preset.is_none_or(|preset| preset.initial.int() <= 0);
    for (part, state) in [(counter::UP, reached), (counter::DOWN, true)] {
        if let Some(cell) = cells.get_mut(at(part)) {
            cell.initial = Value::truth(state);
        }
    }
}
