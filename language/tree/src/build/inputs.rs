//! Inputs of the board in which a program stores, as other PLCs take it: what is stored lasts until the next scan.

use super::builder::Builder;
use super::places::Target;
use crate::{Expr, ExprKind, Place, Root, Stmt, StmtKind, Store, TypeId};
use unoclp_point::Address;
use unoclp_text::diagnostics::Code;

impl Builder<'_, '_> {
    /// Whether a target is an input in which something may be stored; that is told the first time.
    pub(super) fn stores_in_input(&mut self, target: &Target) -> bool {
        let place = &target.place;
        if !self.keeps_inputs || place.root != Root::Static || !place.indices.is_empty() {
            return false;
        }
        let mut points = self.tree.points.iter();
        let is_input = points.any(|(cell, point)| {
            *cell == place.offset && matches!(point, Address::Input(_) | Address::Analogue(_))
        });
        if is_input && !self.stored_inputs.contains_key(&place.offset) {
            self.stored_inputs.insert(place.offset, target.at);
            let written = self.written(target.at);
            self.tell(Code::StInputStored, target.at, [written.into()]);
        }
        is_input
    }

    /// Such an input is read into a variable at the beginning of each scan.
    pub(super) fn read_stored_inputs(&mut self) {
        let mut reads = Vec::new();
        for (offset, at) in std::mem::take(&mut self.stored_inputs) {
            let Some(cell) = self.tree.cells.get(offset as usize).cloned() else {
                continue;
            };
            let (base, input) = (cell.base, self.tree.cells.len() as u32);
            self.tree.cells.push(cell);
            for (cell, _) in &mut self.tree.points {
                if *cell == offset {
                    *cell = input;
                }
            }
            let place = |offset| Place {
                root: Root::Static,
                offset,
                indices: Vec::new(),
                at,
            };
            let value = Expr {
                kind: ExprKind::Read(Box::new(place(input))),
                base,
                ty: TypeId::of(base),
                at,
            };
            let kind = StmtKind::Assign(place(offset), value, Store::Narrow(base));
            reads.push(Stmt { kind, at });
        }
        let first = self.tree.programs.first().map(|unit| *unit as usize);
        if let Some(draft) = first.and_then(|first| self.drafts.get_mut(first)) {
            draft.unit.body.splice(0..0, reads);
        }
    }
}
