//! Several cells into as many others.
//!
//! Owns which of them one instruction moves.

use super::coder::Coder;
use super::flat::place;
use super::seats::Seat;
use unoclp_core::isa::{Opcode, Operand};
use unoclp_point::Address;
use unoclp_tree::{Base, Compare, Convert, Expr, ExprKind, Place, Store, Value};

impl Coder<'_, '_> {
    pub(super) fn copy(&mut self, to: &Place, from: &Place, cells: u32) {
        let seat = |this: &Self, cell| this.seats.of.get(&cell).copied();
        if to.indices.is_empty() && from.indices.is_empty() {
            let rows = (0..cells).map(|n| (seat(self, from.offset + n), seat(self, to.offset + n)));
            let moved = match (seat(self, from.offset), seat(self, to.offset)) {
                (Some(Seat::At(Address::Register(a))), Some(Seat::At(Address::Register(b)))) => {
                    let register = |n| Seat::At(Address::Register(n));
                    let mut rows = rows.zip(0_u8..);
                    let row = rows.all(|((x, y), n)| {
                        x == a.checked_add(n).map(register) && y == b.checked_add(n).map(register)
                    });
                    row.then_some((a, b))
                }
                _ => None,
            };
            if let (Some((from, to)), Ok(count @ 2..)) = (moved, u8::try_from(cells)) {
                self.pen.fresh();
                let block = Operand::Move { from, to, count };
                self.pen.with(Opcode::Move, block, None);
                self.pen.holds = None;
                return;
            }
        }
        // One by one; a subscript that is outside stores nothing.
        let source = self.prepare_place(from.clone());
        let target = self.prepare_place(to.clone());
        let (source, reach) = match source.indices.first() {
            Some(index) => {
                let (count, kept) = (index.count, self.keep(index.subscript.clone()));
                (Some(kept), count)
            }
            None => (None, 0),
        };
        let target = target.indices.first().map(|index| {
            let count = index.count;
            (self.keep(index.subscript.clone()), count)
        });
        let again = |subscript: &Expr, count: u32| {
            vec![unoclp_tree::Index {
                subscript: subscript.clone(),
                low: 0,
                count,
                stride: 1,
            }]
        };
        let copies = |this: &mut Self| {
            for n in 0..cells {
                let Some(base) = this.base(from.offset + n) else {
                    continue;
                };
                let mut one = place(from.offset + n, from.at);
                if let Some(index) = &source {
                    one.indices = again(index, reach);
                }
                let value = super::flat::expr(ExprKind::Read(Box::new(one)), base, from.at);
                let mut goal = place(to.offset + n, to.at);
                if let Some((index, count)) = &target {
                    goal.indices = again(index, *count);
                }
                this.assign_prepared(&goal, &value, Store::Narrow(Base::Dint));
            }
        };
        let Some(index) = &source else {
            return copies(self);
        };
        let bare = ExprKind::Convert(Convert::Keep, Box::new(index.clone()));
        let bare = super::flat::expr(bare, Base::Udint, from.at);
        let end = super::flat::constant(Value::Int(reach.into()), Base::Udint, from.at);
        let inside = super::flat::compare(Compare::Less, bare, end);
        self.bit(&inside, false);
        self.pen.border(Opcode::If);
        copies(self);
        self.pen.border(Opcode::Else);
        self.fail();
        self.pen.border(Opcode::EndIf);
        self.pen.holds = None;
    }

    fn base(&self, cell: u32) -> Option<Base> {
        self.flat.cells.get(cell as usize).map(|held| held.base)
    }
}
