//! IF: by brackets, by a coil, or by stores that look at acc.
//!
//! Owns which of them a statement takes.

use super::coder::Coder;
use super::flat::{Does, Step, each};
use super::pen::Acc;
use super::seats::Seat;
use super::traces::Shows;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;
use unoclp_tree::{Base, Binary, Convert, Expr, ExprKind, Store, Unary};

/// IFs in one another, at most: one of the eight (NC-28) is left for checks of values.
pub(super) const MOST_IFS: u32 = 7;

impl Coder<'_, '_> {
    pub(super) fn choice(&mut self, condition: &Expr, then: &[Step], otherwise: &[Step]) {
        let at = self.pen.at;
        let condition = self.prepare(condition.clone());
        if self.is_drawn(at) {
            self.bit(&condition, false);
            self.tests(at, Shows::Power { inverted: false });
            return self.parts(|this| this.steps(then), otherwise);
        }
        if let ExprKind::Constant(value) = &condition.kind {
            let taken = if value.is_true() { then } else { otherwise };
            return self.steps(taken);
        }
        if let Some((cell, seat, set)) = self.as_coil(then, otherwise) {
            self.bit(&condition, !set);
            self.tests(at, Shows::Power { inverted: !set });
            self.drive(seat, cell);
            for (part, to) in [(then, set), (otherwise, !set)] {
                self.pen.at = part.first().map_or(at, |step| step.at);
                self.shows(Shows::Bit { when: to, to });
            }
            return;
        }
        if self.is_plain(then) && self.is_plain(otherwise) {
            self.bit(&condition, then.is_empty());
            let inverted = then.is_empty();
            self.tests(at, Shows::Power { inverted });
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
        let inverted = then.is_empty();
        self.tests(at, Shows::Power { inverted });
        self.parts(|this| this.steps(first), second);
    }

    /// What is done where acc is 1, and what else.
    pub(super) fn parts(&mut self, first: impl FnOnce(&mut Self), second: &[Step]) {
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
        let coil = matches!(
            seat,
            Seat::At(Address::Marker(_)) | Seat::At(Address::Output(_))
        );
        let bit = coil && value.base == Base::Bool && to.indices.is_empty();
        bit.then(|| (to.offset, seat, known.is_true()))
    }

    /// Whether all of this can be done by stores that look at acc.
    pub(super) fn is_plain(&self, steps: &[Step]) -> bool {
        let last = steps.len().saturating_sub(1);
        steps.len() <= 4
            && steps.iter().enumerate().all(|(at, step)| match &step.does {
                Does::Assign(to, value, Store::Narrow(base)) if value.base != Base::Bool => {
                    let seat = self.seats.of.get(&to.offset);
                    let stored = matches!(
                        seat,
                        Some(Seat::At(
                            Address::Register(_)
                                | Address::Pwm(_)
                                | Address::Group(_)
                                | Address::Outputs(_)
                        ))
                    );
                    stored
                        && to.indices.is_empty()
                        && self.is_harmless(value)
                        && *base != Base::Bool
                }
                Does::Assign(..) => self.constant_bit(step).is_some(),
                Does::Jump(None, ..) => at == last,
                Does::Order(order, block, cell) => self.is_plain_order(order, *block, *cell),
                _ => false,
            })
    }

    /// Whether computing it changes nothing, however it comes out, and needs no step before it.
    pub(super) fn is_harmless(&self, value: &Expr) -> bool {
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
                        Unary::Not | Unary::Low(..) | Unary::Order => true,
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
    pub(super) fn conditional(&mut self, steps: &[Step]) {
        for step in steps {
            self.pen.at = step.at;
            self.shown = step.shown;
            match &step.does {
                Does::Jump(_, label, back) => {
                    self.pen.jump(Opcode::Jump, *label, *back);
                    self.pen.acc = Acc::Other;
                }
                Does::Assign(to, value, store) => match self.constant_bit(step) {
                    Some((cell, seat, set)) => {
                        self.placed(to.at, |this| this.coil(seat, set, cell));
                        let (when, to) = (true, set);
                        self.shows(Shows::Bit { when, to });
                    }
                    None => {
                        let seat = self.seats.of.get(&to.offset).copied();
                        self.value_for(seat, value, *store);
                        self.placed(to.at, |this| this.store(to.offset));
                        self.shows_number(value.base, to.offset);
                        // Where acc is 0 the register is as it was.
                        let seat = self.seats.of.get(&to.offset).copied();
                        if seat.is_some() && self.pen.holds == seat && self.pen.acc != Acc::One {
                            self.pen.holds = None;
                        }
                    }
                },
                Does::Order(order, block, cell) => self.order(order, *block, *cell),
                _ => {}
            }
        }
    }
}
