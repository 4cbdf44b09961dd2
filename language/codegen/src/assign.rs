//! A value into its place.
//!
//! Owns how numbers and bits are stored, narrowed and checked against a subrange.

use super::coder::Coder;
use super::flat::TEMPORARY;
use super::logic::Bit;
use super::pen::Acc;
use super::seats::Seat;
use super::traces::Shows;
use unoclp_core::isa::{Opcode, Operand, Value as Taken};
use unoclp_point::Address;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Convert, Expr, ExprKind, Place, Store, Width};

/// The type that a number has where it is stored.
fn stored_as(value: &Expr, store: Store) -> Base {
    match store {
        Store::Narrow(base) | Store::Within(base, ..) => base,
        _ => value.base,
    }
}

/// Where what is loaded first stands.
fn first_at(value: &Expr) -> Span {
    match &value.kind {
        ExprKind::Convert(_, of) | ExprKind::Unary(_, of) | ExprKind::Binary(_, of, _) => {
            first_at(of)
        }
        _ => value.at,
    }
}

impl Coder<'_, '_> {
    pub(super) fn assign(&mut self, to: &Place, value: &Expr, store: Store) {
        let begin = self.pen.lines.len();
        let value = self.prepare(value.clone());
        if self.is_there(to, &value, store, begin) {
            return;
        }
        let to = match to.indices.is_empty() {
            true => to.clone(),
            false => self.prepare_place(to.clone()),
        };
        self.assign_prepared(&to, &value, store);
    }

    /// Lets what has been made in a temporary be made where it goes, if nothing on the way reads that.
    fn is_there(&mut self, to: &Place, value: &Expr, store: Store, begin: usize) -> bool {
        let (ExprKind::Read(from), Store::Narrow(base)) = (&value.kind, store) else {
            return false;
        };
        let cell = to.offset;
        let plain = to.indices.is_empty() && from.indices.is_empty();
        if self.seats.outputs.contains_key(&to.offset) {
            return false;
        }
        let seat = |cell| self.seats.of.get(&cell).copied();
        let (Some(Seat::At(Address::Register(held))), Some(Seat::At(Address::Register(goal)))) =
            (seat(from.offset), seat(to.offset))
        else {
            return false;
        };
        if !plain || from.offset < TEMPORARY || !self.is_within(value, base) {
            return false;
        }
        let Some(made) = self.pen.lines.get_mut(begin..) else {
            return false;
        };
        let first = made.iter().position(|line| line.is_store(held));
        let read = first.is_none_or(|first| made[first..].iter().any(|line| line.names(goal)));
        if read {
            return false;
        }
        for line in &mut *made {
            line.rename(held, goal, to.offset);
        }
        let stores = made.iter().enumerate();
        let stores = stores.filter(|(_, line)| line.is_store(goal));
        let stores: Vec<usize> = stores.map(|(index, _)| begin + index).collect();
        for line in stores {
            self.shows_number_at(line, base, cell);
        }
        if self.pen.holds == Some(Seat::At(Address::Register(held))) {
            self.pen.holds = Some(Seat::At(Address::Register(goal)));
        } else if self.pen.holds == Some(Seat::At(Address::Register(goal))) {
            self.pen.holds = None;
        }
        true
    }

    pub(super) fn assign_prepared(&mut self, to: &Place, value: &Expr, store: Store) {
        let seat = self.seats.of.get(&to.offset).copied();
        if value.base == Base::Bool {
            return self.assign_bit(to, seat, value);
        }
        if let Some(index) = to.indices.first() {
            self.pen.fresh();
            self.value(&index.subscript);
            self.pen.plain(Opcode::Push);
            self.value(value);
            self.narrowed(value, store);
            let within = self.within(value, store);
            if let (Some(Seat::At(Address::Register(first))), Ok(length)) =
                (seat, u8::try_from(index.count))
            {
                let table = Operand::Table { first, length };
                self.pen.with(Opcode::StoreTable, table, Some(to.offset));
                self.shows_number(stored_as(value, store), to.offset);
            }
            self.pen.holds = None;
            return self.fail_unless(within);
        }
        self.placed(first_at(value), |this| this.pen.fresh());
        self.value_for(seat, value, store);
        let within = self.within(value, store);
        let before = self.pen.lines.len();
        self.placed(to.at, |this| this.store(to.offset));
        if self.pen.lines.len() > before {
            self.shows_number(stored_as(value, store), to.offset);
        }
        self.fail_unless(within);
    }

    /// Whether what is stored there is cut by itself.
    fn takes_low_bits(seat: Option<Seat>) -> bool {
        matches!(
            seat,
            Some(Seat::At(Address::Group(_) | Address::Outputs(_)))
        )
    }

    /// A prepared number as it is stored at this seat.
    pub(super) fn value_for(&mut self, seat: Option<Seat>, value: &Expr, store: Store) {
        if !Self::takes_low_bits(seat) {
            self.value(value);
            return self.narrowed(value, store);
        }
        let mut value = value;
        while let ExprKind::Convert(Convert::Wrap | Convert::Keep, whole) = &value.kind
            && whole.base != Base::Bool
            && !whole.base.is_real()
            && value.base.bits() >= 8
        {
            value = whole;
        }
        self.value(value);
    }

    /// Value in the bits that are stored.
    pub(super) fn narrowed(&mut self, value: &Expr, store: Store) {
        if let Store::Narrow(base) | Store::Within(base, ..) = store
            && !base.is_real()
            && base.bits() < 32
            && !self.is_within(value, base)
        {
            self.narrow(base);
        }
    }

    /// acc := whether value may be stored; whether that is a question.
    fn within(&mut self, value: &Expr, store: Store) -> bool {
        let Store::Within(base, low, high) = store else {
            return false;
        };
        let (least, most) = super::ranges::bounds(value);
        let fits = low <= least && most <= high;
        if fits && base.range().is_some_and(|(a, b)| a <= least && most <= b) {
            return false;
        }
        let operand = |number: i128| Taken::Constant(number as i32);
        let holds = self.pen.holds;
        let unsigned = base.width() == Width::Unsigned;
        let (from, to) = match unsigned {
            true => (Opcode::UnsignedGreaterOrEqual, Opcode::UnsignedLess),
            false => (Opcode::GreaterOrEqual, Opcode::LessOrEqual),
        };
        self.pen.operation(from, operand(low), None);
        match unsigned {
            true if high >= i128::from(u32::MAX) => {}
            true => self.pen.operation(to, operand(high + 1), None),
            false => self.pen.operation(to, operand(high), None),
        }
        self.pen.holds = holds;
        self.pen.acc = Acc::Other;
        true
    }

    fn fail_unless(&mut self, asked: bool) {
        if asked {
            self.pen.plain(Opcode::Not);
            self.pen.border(Opcode::If);
            self.fail();
            self.pen.border(Opcode::EndIf);
        }
    }

    fn assign_bit(&mut self, to: &Place, seat: Option<Seat>, value: &Expr) {
        let known = match &value.kind {
            ExprKind::Constant(value) => Some(value.is_true()),
            _ => None,
        };
        if let Some(index) = to.indices.first() {
            let held = match known {
                Some(_) => value.clone(),
                None => self.number_of(value),
            };
            self.pen.fresh();
            self.value(&index.subscript);
            self.pen.plain(Opcode::Push);
            self.value(&Expr {
                base: Base::Dint,
                ..held
            });
            if let (Some(Seat::At(Address::Register(first))), Ok(length)) =
                (seat, u8::try_from(index.count))
            {
                let table = Operand::Table { first, length };
                self.pen.with(Opcode::StoreTable, table, Some(to.offset));
                self.shows_number(Base::Bool, to.offset);
            }
            self.pen.holds = None;
            return;
        }
        match (seat, known) {
            (Some(Seat::At(Address::Register(_))), Some(known)) => {
                self.pen.fresh();
                self.pen
                    .operation(Opcode::Load, Taken::Constant(known.into()), None);
                self.placed(to.at, |this| this.store(to.offset));
                self.shows_number(Base::Bool, to.offset);
            }
            (Some(Seat::At(Address::Register(_))), None) => {
                self.bit(value, false);
                self.pen.changes_value(Opcode::LoadBit);
                self.pen.fresh();
                self.placed(to.at, |this| this.store(to.offset));
                self.shows_number(Base::Bool, to.offset);
            }
            (Some(seat), Some(known)) => {
                self.pen.fresh();
                self.placed(to.at, |this| this.coil(seat, known, to.offset));
                let (when, to) = (true, known);
                self.shows(Shows::Bit { when, to });
            }
            (Some(seat), None) if self.is_opposite_of_acc(value) => {
                self.placed(to.at, |this| this.drive_opposite(seat, to.offset));
                self.shows(Shows::Power { inverted: true });
            }
            (Some(seat), None) => {
                self.bit(value, false);
                self.placed(to.at, |this| this.drive(seat, to.offset));
                self.shows(Shows::Power { inverted: false });
            }
            (None, _) => {}
        }
    }

    /// Whether it is the opposite of the bit that acc holds.
    fn is_opposite_of_acc(&self, value: &Expr) -> bool {
        let bit = self.logic(value, false);
        match (&bit, self.pen.acc) {
            (Bit::Contact(of), Acc::Bit(held)) => {
                of.negated && of.seat == held && self.goes_on(&bit, held)
            }
            _ => false,
        }
    }

    /// A bit as 0 or 1 in a register.
    fn number_of(&mut self, value: &Expr) -> Expr {
        let cell = self.seats.temporary(false, false);
        self.bit(value, false);
        self.pen.changes_value(Opcode::LoadBit);
        self.pen.fresh();
        self.store(cell);
        super::flat::read(cell, Base::Dint, value.at)
    }
}
