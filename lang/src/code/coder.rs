//! From steps to instructions.
//!
//! Owns how each statement is written. Must not know the text, nor the numbers of labels and timers.

use super::flat::{Arm, Does, Flat, Step, TEMPORARY, each, place};
use super::numbers::bits;
use super::pen::{Acc, Pen};
use super::seats::{Seat, Seats};
use super::uses::Uses;
use crate::diagnostics::{Code, Found, Span};
use crate::typed::{
    Base, Binary, Compare, Convert, Expr, ExprKind, Place, Store, Unary, Value, Width,
};
use unoclp_core::Target;
use unoclp_core::isa::{Opcode, Operand, Value as Taken};

/// IFs in one another, at most: one of the eight (NC-28) is left for checks of values.
const MOST_IFS: u32 = 7;

pub(super) struct Coder<'a, 'f> {
    pub flat: &'a Flat,
    pub uses: &'a Uses,
    pub seats: Seats,
    pub pen: Pen,
    pub found: &'f mut Found,
    pub labels: u32,
    /// IFs that are open.
    pub deep: u32,
    /// What timers drive that nobody else has asked for.
    pub unused: Option<Target>,
}

impl Coder<'_, '_> {
    pub(super) fn steps(&mut self, steps: &[Step]) {
        let mut rest = steps;
        while let Some((step, behind)) = rest.split_first() {
            rest = behind;
            self.pen.at = step.at;
            let mark = self.seats.mark();
            if let Does::Standard(block, cell, inputs) = &step.does {
                if self.standard(*block, *cell, inputs, behind.first()) {
                    rest = behind.get(1..).unwrap_or_default();
                }
            } else {
                self.step(step);
            }
            self.seats.release_to(mark);
        }
    }

    fn step(&mut self, step: &Step) {
        match &step.does {
            Does::Assign(to, value, store) => self.assign(to, value, *store),
            Does::Copy(to, from, cells) => self.copy(to, from, *cells),
            Does::If(condition, then, otherwise) => self.choice(condition, then, otherwise),
            Does::Case(selector, arms, otherwise) => self.case(selector, arms, otherwise),
            Does::Label(label) => self.pen.label(*label),
            Does::Jump(condition, label, back) => match condition {
                None => {
                    self.pen.fresh();
                    self.pen.jump(Opcode::Jump, *label, *back);
                }
                Some(condition) => {
                    let condition = self.prepare(condition.clone());
                    let (condition, opcode) = match condition.kind {
                        ExprKind::Unary(Unary::Not, inner) if is_logic(&inner) => {
                            (*inner, Opcode::JumpNot)
                        }
                        _ => (condition, Opcode::Jump),
                    };
                    self.bit(&condition, false);
                    self.pen.jump(opcode, *label, *back);
                    // Behind it acc is known, but not 1.
                    self.pen.acc = Acc::Other;
                }
            },
            Does::Standard(..) => {}
            Does::Fail => {
                self.fail();
            }
        }
    }

    /// Sets S 04; value becomes 0.
    pub(super) fn fail(&mut self) {
        self.pen.operation(Opcode::Divide, Taken::Constant(0), None);
    }

    /// A new label.
    fn label(&mut self) -> u32 {
        self.labels += 1;
        self.labels - 1
    }

    /// Value into the register of this cell, where acc is 1.
    pub(super) fn store(&mut self, cell: u32) {
        match self.seats.of.get(&cell) {
            Some(&Seat::Register(register)) => {
                self.pen.numbered(Opcode::Store, register, Some(cell));
                if self.pen.acc == Acc::One {
                    self.pen.holds = Some(Seat::Register(register));
                }
            }
            Some(&Seat::Pwm(output)) => self.pen.numbered(Opcode::StorePwm, output, Some(cell)),
            Some(&Seat::Count(counter)) => {
                self.pen.numbered(Opcode::StoreCount, counter, Some(cell));
            }
            _ => {}
        }
    }

    fn assign(&mut self, to: &Place, value: &Expr, store: Store) {
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
        let plain = to.indices.is_empty() && from.indices.is_empty();
        let seat = |cell| self.seats.of.get(&cell).copied();
        let (Some(Seat::Register(held)), Some(Seat::Register(goal))) =
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
        for line in made {
            line.rename(held, goal, to.offset);
        }
        if self.pen.holds == Some(Seat::Register(held)) {
            self.pen.holds = Some(Seat::Register(goal));
        } else if self.pen.holds == Some(Seat::Register(goal)) {
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
            if let (Some(Seat::Register(first)), Ok(length)) = (seat, u8::try_from(index.count)) {
                let table = Operand::Table { first, length };
                self.pen.with(Opcode::StoreTable, table, Some(to.offset));
            }
            self.pen.holds = None;
            return self.fail_unless(within);
        }
        self.pen.fresh();
        self.value(value);
        self.narrowed(value, store);
        let within = self.within(value, store);
        self.store(to.offset);
        self.fail_unless(within);
    }

    /// Value in the bits that are stored.
    fn narrowed(&mut self, value: &Expr, store: Store) {
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
            if let (Some(Seat::Register(first)), Ok(length)) = (seat, u8::try_from(index.count)) {
                let table = Operand::Table { first, length };
                self.pen.with(Opcode::StoreTable, table, Some(to.offset));
            }
            self.pen.holds = None;
            return;
        }
        match (seat, known) {
            (Some(Seat::Register(_)), Some(known)) => {
                self.pen.fresh();
                self.pen
                    .operation(Opcode::Load, Taken::Constant(known.into()), None);
                self.store(to.offset);
            }
            (Some(Seat::Register(_)), None) => {
                self.bit(value, false);
                self.pen.changes_value(Opcode::LoadBit);
                self.pen.fresh();
                self.store(to.offset);
            }
            (Some(seat), Some(known)) => {
                self.pen.fresh();
                self.coil(seat, known, to.offset);
            }
            (Some(seat), None) => {
                self.bit(value, false);
                self.drive(seat, to.offset);
            }
            (None, _) => {}
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

    /// A coil: the bit := acc.
    pub(super) fn drive(&mut self, seat: Seat, cell: u32) {
        match seat {
            Seat::Output(n) => self.pen.numbered(Opcode::Coil, n, Some(cell)),
            Seat::Marker(n) => self.pen.numbered(Opcode::MarkerCoil, n, Some(cell)),
            _ => return,
        }
        // acc is what the bit holds now; where it is 1 for certain, that is worth more.
        if self.pen.acc != Acc::One {
            self.pen.acc = Acc::Bit(seat);
        }
    }

    /// Sets or resets a bit where acc is 1.
    fn coil(&mut self, seat: Seat, set: bool, cell: u32) {
        let (opcode, number) = match (seat, set) {
            (Seat::Output(n), true) if self.pen.acc == Acc::One => (Opcode::Coil, n),
            (Seat::Marker(n), true) if self.pen.acc == Acc::One => (Opcode::MarkerCoil, n),
            (Seat::Output(n), true) => (Opcode::SetCoil, n),
            (Seat::Output(n), false) => (Opcode::ResetCoil, n),
            (Seat::Marker(n), true) => (Opcode::SetMarker, n),
            (Seat::Marker(n), false) => (Opcode::ResetMarker, n),
            _ => return,
        };
        self.pen.numbered(opcode, number, Some(cell));
        // A contact that acc was may be this one.
        if let Acc::Bit(held) = self.pen.acc
            && held == seat
        {
            self.pen.acc = Acc::Other;
        }
    }

    fn copy(&mut self, to: &Place, from: &Place, cells: u32) {
        let seat = |this: &Self, cell| this.seats.of.get(&cell).copied();
        if to.indices.is_empty() && from.indices.is_empty() {
            let rows = (0..cells).map(|n| (seat(self, from.offset + n), seat(self, to.offset + n)));
            let moved = match (seat(self, from.offset), seat(self, to.offset)) {
                (Some(Seat::Register(a)), Some(Seat::Register(b))) => {
                    let mut rows = rows.zip(0_u8..);
                    let row = rows.all(|((x, y), n)| {
                        x == a.checked_add(n).map(Seat::Register)
                            && y == b.checked_add(n).map(Seat::Register)
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
            vec![crate::typed::Index {
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
        let inside = super::prepare::compare(Compare::Less, bare, end);
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

    fn choice(&mut self, condition: &Expr, then: &[Step], otherwise: &[Step]) {
        let condition = self.prepare(condition.clone());
        if let ExprKind::Constant(value) = &condition.kind {
            let taken = if value.is_true() { then } else { otherwise };
            return self.steps(taken);
        }
        if let Some((cell, seat, set)) = self.as_coil(then, otherwise) {
            self.bit(&condition, !set);
            return self.drive(seat, cell);
        }
        if self.is_plain(then) && self.is_plain(otherwise) {
            self.bit(&condition, then.is_empty());
            if then.is_empty() {
                return self.conditional(otherwise);
            }
            self.conditional(then);
            if !otherwise.is_empty() {
                self.pen.plain(Opcode::Not);
                self.pen.acc = Acc::Other;
                self.conditional(otherwise);
            }
            return;
        }
        let (first, second) = match then.is_empty() {
            true => (otherwise, then),
            false => (then, otherwise),
        };
        self.bit(&condition, then.is_empty());
        self.parts(|this| this.steps(first), second);
    }

    /// What is done where acc is 1, and what else.
    fn parts(&mut self, first: impl FnOnce(&mut Self), second: &[Step]) {
        let holds = self.pen.holds;
        if self.deep >= MOST_IFS {
            // Brackets are all in use: labels do the same.
            let (other, end) = (self.label(), self.label());
            self.pen.jump(Opcode::JumpNot, other, None);
            self.pen.acc = Acc::Other;
            first(self);
            if !second.is_empty() {
                self.pen.fresh();
                self.pen.jump(Opcode::Jump, end, None);
            }
            self.pen.label(other);
            if !second.is_empty() {
                self.steps(second);
                self.pen.label(end);
            }
            return;
        }
        self.deep += 1;
        self.pen.border(Opcode::If);
        first(self);
        if !second.is_empty() {
            self.pen.border(Opcode::Else);
            self.pen.holds = holds;
            self.steps(second);
        }
        self.pen.border(Opcode::EndIf);
        self.pen.holds = None;
        self.deep -= 1;
    }

    /// `IF … THEN x := TRUE; ELSE x := FALSE; END_IF`: a coil; whether it is set in the first part.
    fn as_coil(&self, then: &[Step], otherwise: &[Step]) -> Option<(u32, Seat, bool)> {
        let ([one], [other]) = (then, otherwise) else {
            return None;
        };
        let (first, second) = (self.constant_bit(one)?, self.constant_bit(other)?);
        let same = first.0 == second.0 && first.2 != second.2;
        same.then_some(first)
    }

    /// A bit that is set or reset.
    fn constant_bit(&self, step: &Step) -> Option<(u32, Seat, bool)> {
        let Does::Assign(to, value, _) = &step.does else {
            return None;
        };
        let ExprKind::Constant(known) = &value.kind else {
            return None;
        };
        let seat = self.seats.of.get(&to.offset).copied()?;
        let coil = matches!(seat, Seat::Marker(_) | Seat::Output(_));
        let bit = coil && value.base == Base::Bool && to.indices.is_empty();
        bit.then(|| (to.offset, seat, known.is_true()))
    }

    /// Whether all of this can be done by stores that look at acc.
    fn is_plain(&self, steps: &[Step]) -> bool {
        let last = steps.len().saturating_sub(1);
        steps.len() <= 4
            && steps.iter().enumerate().all(|(at, step)| match &step.does {
                Does::Assign(to, value, Store::Narrow(base)) if value.base != Base::Bool => {
                    let seat = self.seats.of.get(&to.offset);
                    let stored = matches!(seat, Some(Seat::Register(_) | Seat::Pwm(_)));
                    stored
                        && to.indices.is_empty()
                        && self.is_harmless(value)
                        && *base != Base::Bool
                }
                Does::Assign(..) => self.constant_bit(step).is_some(),
                Does::Jump(None, ..) => at == last,
                _ => false,
            })
    }

    /// Whether computing it changes nothing, however it comes out, and needs no step before it.
    fn is_harmless(&self, value: &Expr) -> bool {
        let mut harmless = self.height(value) < 6;
        each(value, &mut |e| {
            harmless &= e.base != Base::Bool
                && match &e.kind {
                    ExprKind::Constant(_) => true,
                    ExprKind::Read(place) => place.indices.is_empty(),
                    ExprKind::Convert(how, _) => {
                        matches!(how, Convert::Keep | Convert::Wrap | Convert::Float)
                    }
                    ExprKind::Unary(op, a) => match op {
                        Unary::Negate => true,
                        Unary::Not => true,
                        Unary::Abs => a.base.is_real(),
                        Unary::Sqrt => false,
                    },
                    ExprKind::Binary(op, a, b) => match op {
                        Binary::Add | Binary::Subtract | Binary::Multiply => !a.base.is_real(),
                        Binary::And | Binary::Or | Binary::Xor => true,
                        Binary::Divide | Binary::Modulo => {
                            !a.base.is_real()
                                && matches!(&b.kind, ExprKind::Constant(v) if v.int() != 0)
                        }
                        _ => false,
                    },
                    _ => false,
                };
        });
        harmless
    }

    /// Stores that look at acc.
    fn conditional(&mut self, steps: &[Step]) {
        for step in steps {
            self.pen.at = step.at;
            match &step.does {
                Does::Jump(_, label, back) => {
                    self.pen.jump(Opcode::Jump, *label, *back);
                    self.pen.acc = Acc::Other;
                }
                Does::Assign(to, value, store) => match self.constant_bit(step) {
                    Some((cell, seat, set)) => self.coil(seat, set, cell),
                    None => {
                        self.value(value);
                        self.narrowed(value, *store);
                        self.store(to.offset);
                        // Where acc is 0 the register is as it was.
                        let seat = self.seats.of.get(&to.offset).copied();
                        if seat.is_some() && self.pen.holds == seat && self.pen.acc != Acc::One {
                            self.pen.holds = None;
                        }
                    }
                },
                _ => {}
            }
        }
    }

    fn case(&mut self, selector: &Expr, arms: &[Arm], otherwise: &[Step]) {
        let selector = self.prepare(selector.clone());
        if arms.is_empty() {
            return self.steps(otherwise);
        }
        let room = MOST_IFS.saturating_sub(self.deep) as usize;
        if arms.len() <= room {
            self.pen.fresh();
            self.value(&selector);
            return self.arms(&selector, arms, otherwise);
        }
        // More than IFs can stand in one another: one behind the other, by a copy of the number.
        let held = self.keep(selector);
        for (bounds, body) in arms {
            self.pen.fresh();
            self.value(&held);
            self.one_of(bounds, self.is_unsigned(&held));
            self.parts(|this| this.steps(body), &[]);
        }
        if otherwise.is_empty() {
            return;
        }
        self.pen.fresh();
        self.value(&held);
        let mut first = true;
        for (bounds, _) in arms {
            for bound in bounds {
                if !first {
                    self.pen.plain(Opcode::OpenBranch);
                }
                self.between(*bound, self.is_unsigned(&held));
                if !first {
                    self.pen.plain(Opcode::CloseBranch);
                }
                first = false;
            }
        }
        self.pen.plain(Opcode::Not);
        self.pen.acc = Acc::Other;
        self.parts(|this| this.steps(otherwise), &[]);
    }

    /// The arms one in the ELSE of another; value is the selector, which nothing on that way changes.
    fn arms(&mut self, selector: &Expr, arms: &[Arm], otherwise: &[Step]) {
        let Some(((bounds, body), rest)) = arms.split_first() else {
            return self.steps(otherwise);
        };
        let holds = self.pen.holds;
        self.one_of(bounds, self.is_unsigned(selector));
        if rest.is_empty() && otherwise.is_empty() && self.is_plain(body) {
            return self.conditional(body);
        }
        self.deep += 1;
        self.pen.border(Opcode::If);
        self.steps(body);
        if !rest.is_empty() || !otherwise.is_empty() {
            self.pen.border(Opcode::Else);
            self.pen.holds = holds;
            self.arms(selector, rest, otherwise);
        }
        self.pen.border(Opcode::EndIf);
        self.pen.holds = None;
        self.deep -= 1;
    }

    /// acc := whether value is within one of these bounds.
    fn one_of(&mut self, bounds: &[(i128, i128)], unsigned: bool) {
        for (at, bound) in bounds.iter().enumerate() {
            if at > 0 {
                self.pen.plain(Opcode::OpenBranch);
            }
            self.between(*bound, unsigned);
            if at > 0 {
                self.pen.plain(Opcode::CloseBranch);
            }
        }
        self.pen.acc = Acc::Other;
    }

    fn between(&mut self, (low, high): (i128, i128), unsigned: bool) {
        let holds = self.pen.holds;
        let number = |number: i128| Taken::Constant(bits(&Value::Int(number), Base::Dint));
        if low == high {
            self.pen.operation(Opcode::Equal, number(low), None);
        } else if unsigned {
            self.pen
                .operation(Opcode::UnsignedGreaterOrEqual, number(low), None);
            if high < i128::from(u32::MAX) {
                self.pen
                    .operation(Opcode::UnsignedLess, number(high + 1), None);
            }
        } else {
            self.pen
                .operation(Opcode::GreaterOrEqual, number(low), None);
            self.pen.operation(Opcode::LessOrEqual, number(high), None);
        }
        self.pen.holds = holds;
        self.pen.acc = Acc::Other;
    }

    /// What timers drive for nobody.
    pub(super) fn idle_target(&mut self, at: Span) -> Target {
        if let Some(target) = self.unused {
            return target;
        }
        let target = match self.seats.lasting(true) {
            Some(Seat::Marker(n)) => Target::Marker(n),
            _ => {
                let words = ("marker", "memória");
                let most = "56".to_owned();
                let name = String::new();
                self.found.tell(
                    Code::BoardNoneLeft,
                    at,
                    [words.into(), most.into(), name.into()],
                );
                Target::Marker(1)
            }
        };
        self.unused = Some(target);
        target
    }
}

/// Whether a negation of it costs as much as it does.
fn is_logic(inner: &Expr) -> bool {
    matches!(
        inner.kind,
        ExprKind::Binary(..) | ExprKind::Select(_) | ExprKind::Ordered(..)
    )
}
