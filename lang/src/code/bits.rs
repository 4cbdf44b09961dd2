//! BOOL expressions as contacts, branches and comparisons.
//!
//! Owns how logic becomes a ladder. Must not know statements.

use super::coder::Coder;
use super::flat::{constant, read};
use super::pen::Acc;
use super::seats::Seat;
use crate::typed::{Base, Binary, Compare, Convert, Expr, ExprKind, Unary, Value};
use unoclp_core::isa::{Opcode, Value as Operand};

/// Logic whose negations stand at its contacts.
#[derive(Clone, Debug)]
pub(super) enum Bit {
    Is(bool),
    /// A contact of a bit, and its cell.
    Contact(Seat, bool, u32),
    Test(Compare, Expr, Expr),
    And(Vec<Bit>),
    Or(Vec<Bit>),
    Xor(Vec<Bit>, bool),
}

/// The opcodes of a bit's contact, open and closed.
fn contact(seat: Seat) -> Option<(Opcode, Opcode, u8)> {
    Some(match seat {
        Seat::Input(n) => (Opcode::InputContact, Opcode::InputContactNot, n),
        Seat::Output(n) => (Opcode::OutputContact, Opcode::OutputContactNot, n),
        Seat::Marker(n) => (Opcode::MarkerContact, Opcode::MarkerContactNot, n),
        Seat::System(n) => (Opcode::SystemContact, Opcode::SystemContactNot, n),
        Seat::Reached(n) => (Opcode::CounterContact, Opcode::CounterContactNot, n),
        Seat::Zero(n) => (Opcode::ZeroContact, Opcode::ZeroContactNot, n),
        _ => return None,
    })
}

fn xor(seat: Seat, negated: bool) -> Option<(Opcode, u8)> {
    let pick = |plain, inverted| if negated { inverted } else { plain };
    Some(match seat {
        Seat::Input(n) => (pick(Opcode::XorInput, Opcode::XorInputNot), n),
        Seat::Output(n) => (pick(Opcode::XorOutput, Opcode::XorOutputNot), n),
        Seat::Marker(n) => (pick(Opcode::XorMarker, Opcode::XorMarkerNot), n),
        _ => return None,
    })
}

/// The opposite comparison.
fn opposite(op: Compare) -> Compare {
    match op {
        Compare::Equal => Compare::NotEqual,
        Compare::NotEqual => Compare::Equal,
        Compare::Less => Compare::GreaterEqual,
        Compare::LessEqual => Compare::Greater,
        Compare::Greater => Compare::LessEqual,
        Compare::GreaterEqual => Compare::Less,
    }
}

fn and(all: Vec<Bit>) -> Bit {
    let mut parts = Vec::new();
    for part in all {
        match part {
            Bit::Is(true) => {}
            Bit::Is(false) => return Bit::Is(false),
            Bit::And(inner) => parts.extend(inner),
            other => parts.push(other),
        }
    }
    match parts.len() {
        0 => Bit::Is(true),
        1 => parts.swap_remove(0),
        _ => Bit::And(parts),
    }
}

fn or(all: Vec<Bit>) -> Bit {
    let mut parts = Vec::new();
    for part in all {
        match part {
            Bit::Is(false) => {}
            Bit::Is(true) => return Bit::Is(true),
            Bit::Or(inner) => parts.extend(inner),
            other => parts.push(other),
        }
    }
    match parts.len() {
        0 => Bit::Is(false),
        1 => parts.swap_remove(0),
        _ => Bit::Or(parts),
    }
}

impl Coder<'_, '_> {
    /// A prepared expression as logic.
    pub(super) fn logic(&self, from: &Expr, negated: bool) -> Bit {
        let test = |op: Compare, a: &Expr, b: &Expr| {
            let op = if negated { opposite(op) } else { op };
            Bit::Test(op, a.clone(), b.clone())
        };
        let none = |e: &Expr| match e.base.is_real() {
            true => constant(Value::Real(0.0), e.base, e.at),
            false => constant(Value::Int(0), e.base, e.at),
        };
        match &from.kind {
            ExprKind::Constant(value) => Bit::Is(value.is_true() != negated),
            ExprKind::Read(place) if place.indices.is_empty() => {
                match self.seats.of.get(&place.offset) {
                    Some(Seat::Register(_)) => {
                        let held = read(place.offset, Base::Dint, from.at);
                        test(Compare::NotEqual, &held, &none(&held))
                    }
                    Some(&seat) => Bit::Contact(seat, negated, place.offset),
                    None => Bit::Is(negated),
                }
            }
            ExprKind::Read(place) => {
                let kind = ExprKind::Read(place.clone());
                let held = super::flat::expr(kind, Base::Dint, from.at);
                test(Compare::NotEqual, &held, &none(&held))
            }
            ExprKind::Unary(Unary::Not, a) => self.logic(a, !negated),
            ExprKind::Binary(Binary::And | Binary::Min, a, b) => {
                let parts = vec![self.logic(a, negated), self.logic(b, negated)];
                if negated { or(parts) } else { and(parts) }
            }
            ExprKind::Binary(Binary::Or | Binary::Max, a, b) => {
                let parts = vec![self.logic(a, negated), self.logic(b, negated)];
                if negated { and(parts) } else { or(parts) }
            }
            ExprKind::Binary(Binary::Xor, a, b) => self.exclusive(a, b, negated),
            ExprKind::Compare(op, a, b) if a.base == Base::Bool => {
                let (x, y) = (|not| self.logic(a, not), |not| self.logic(b, not));
                match (op, negated) {
                    (Compare::Equal, _) => self.exclusive(a, b, !negated),
                    (Compare::NotEqual, _) => self.exclusive(a, b, negated),
                    (Compare::Less, false) | (Compare::GreaterEqual, true) => {
                        and(vec![x(true), y(false)])
                    }
                    (Compare::Less, true) | (Compare::GreaterEqual, false) => {
                        or(vec![x(false), y(true)])
                    }
                    (Compare::Greater, false) | (Compare::LessEqual, true) => {
                        and(vec![x(false), y(true)])
                    }
                    (Compare::Greater, true) | (Compare::LessEqual, false) => {
                        or(vec![x(true), y(false)])
                    }
                }
            }
            ExprKind::Compare(op, a, b) => test(*op, a, b),
            ExprKind::Convert(Convert::Wrap, a) if a.base != Base::Bool => {
                let one = constant(Value::Int(1), a.base, a.at);
                let low = super::inline::both(Binary::And, (**a).clone(), one);
                test(Compare::NotEqual, &low, &none(a))
            }
            ExprKind::Convert(_, a) if a.base == Base::Bool => self.logic(a, negated),
            ExprKind::Convert(_, a) => test(Compare::NotEqual, a, &none(a)),
            _ => Bit::Is(negated),
        }
    }

    fn exclusive(&self, a: &Expr, b: &Expr, negated: bool) -> Bit {
        let mut parts = Vec::new();
        let mut turned = negated;
        for part in [self.logic(a, false), self.logic(b, false)] {
            match part {
                Bit::Is(is) => turned ^= is,
                Bit::Xor(inner, not) => {
                    parts.extend(inner);
                    turned ^= not;
                }
                other => parts.push(other),
            }
        }
        match parts.len() {
            0 => Bit::Is(turned),
            _ => Bit::Xor(parts, turned),
        }
    }

    /// Brings a prepared expression into acc.
    pub(super) fn bit(&mut self, from: &Expr, negated: bool) {
        let bit = self.logic(from, negated);
        self.bring(bit);
    }

    /// Likewise logic.
    pub(super) fn bring(&mut self, mut bit: Bit) {
        if let Acc::Bit(held) = self.pen.acc
            && begins(&mut bit, held)
        {
            match bit {
                Bit::And(parts) => parts.iter().skip(1).for_each(|part| self.series(part)),
                Bit::Or(parts) => self.parallel(&parts[1..]),
                _ => {}
            }
            return;
        }
        self.pen.fresh();
        self.start(&bit);
    }

    fn changes(&mut self) {
        self.pen.acc = Acc::Other;
    }

    fn start(&mut self, bit: &Bit) {
        match bit {
            Bit::Is(true) => {}
            Bit::Is(false) => {
                self.pen.plain(Opcode::Not);
                self.changes();
            }
            Bit::And(parts) => {
                let first = parts.iter().position(is_block).unwrap_or(0);
                self.start(&parts[first]);
                for (at, part) in parts.iter().enumerate() {
                    if at != first {
                        self.series(part);
                    }
                }
            }
            Bit::Or(parts) => {
                self.start(&parts[0]);
                self.parallel(&parts[1..]);
            }
            Bit::Xor(parts, turned) => self.start_xor(parts, *turned),
            Bit::Contact(..) | Bit::Test(..) => self.series(bit),
        }
    }

    fn parallel(&mut self, parts: &[Bit]) {
        for part in parts {
            self.block(Opcode::OpenBranch, part);
        }
    }

    fn start_xor(&mut self, parts: &[Bit], mut turned: bool) {
        let plain = |part: &Bit| match part {
            Bit::Contact(seat, ..) => xor(*seat, false).is_some(),
            _ => false,
        };
        let first = parts.iter().position(|part| !plain(part)).unwrap_or(0);
        self.start(&parts[first]);
        for (at, part) in parts.iter().enumerate() {
            if at == first {
                continue;
            }
            match part {
                Bit::Contact(seat, negated, cell) if plain(part) => {
                    let negated = *negated != std::mem::take(&mut turned);
                    if let Some((opcode, number)) = xor(*seat, negated) {
                        self.pen.numbered(opcode, number, Some(*cell));
                    }
                    self.changes();
                }
                _ => self.block(Opcode::OpenXor, part),
            }
        }
        if turned {
            self.pen.plain(Opcode::Not);
            self.changes();
        }
    }

    fn block(&mut self, opening: Opcode, part: &Bit) {
        self.pen.plain(opening);
        self.start(part);
        self.pen.plain(Opcode::CloseBranch);
        self.changes();
    }

    pub(super) fn series(&mut self, bit: &Bit) {
        match bit {
            Bit::Is(true) => {}
            Bit::Contact(Seat::Timer(timer), negated, cell) => {
                let opcode = match negated {
                    true => Opcode::TimerContactNot,
                    false => Opcode::TimerContact,
                };
                self.pen.of_timer(opcode, *timer, Some(*cell));
                self.changes();
            }
            Bit::Contact(seat, negated, cell) => {
                if let Some((open, closed, number)) = contact(*seat) {
                    let opcode = if *negated { closed } else { open };
                    self.pen.numbered(opcode, number, Some(*cell));
                }
                self.changes();
            }
            Bit::Test(op, a, b) => {
                self.compare(*op, a, b);
                self.changes();
            }
            Bit::And(parts) => parts.iter().for_each(|part| self.series(part)),
            Bit::Is(false) | Bit::Or(_) | Bit::Xor(..) => self.block(Opcode::OpenAnd, bit),
        }
    }

    /// A comparison of two numbers, in series.
    fn compare(&mut self, op: Compare, a: &Expr, b: &Expr) {
        if a.base.is_real() {
            self.compare_reals(op, a, b);
            return;
        }
        let unsigned = self.is_unsigned(a) || self.is_unsigned(b);
        if self.operand(b).is_none() && self.operand(a).is_some() {
            let exchanged = match op {
                Compare::Less => Compare::Greater,
                Compare::LessEqual => Compare::GreaterEqual,
                Compare::Greater => Compare::Less,
                Compare::GreaterEqual => Compare::LessEqual,
                same => same,
            };
            return self.compare(exchanged, b, a);
        }
        if unsigned {
            self.compare_unsigned(op, a, b);
            return;
        }
        let operand = self.pair(a, b);
        self.comparison(opcode(op), operand, b);
    }

    fn comparison(&mut self, opcode: Opcode, operand: Operand, b: &Expr) {
        let cell = self.named_operand(operand, b);
        let holds = self.pen.holds;
        self.pen.operation(opcode, operand, cell);
        // A comparison leaves value as it is, but for one with what was pushed.
        if operand != Operand::Popped {
            self.pen.holds = holds;
        }
    }

    fn compare_unsigned(&mut self, op: Compare, a: &Expr, b: &Expr) {
        let (opcode, turned) = match op {
            Compare::Equal => (Opcode::Equal, false),
            Compare::NotEqual => (Opcode::NotEqual, false),
            Compare::Less => (Opcode::UnsignedLess, false),
            Compare::GreaterEqual => (Opcode::UnsignedGreaterOrEqual, false),
            Compare::Greater => (Opcode::UnsignedLess, true),
            Compare::LessEqual => (Opcode::UnsignedGreaterOrEqual, true),
        };
        if !turned {
            let operand = self.pair(a, b);
            return self.comparison(opcode, operand, b);
        }
        if let ExprKind::Constant(value) = &b.kind {
            // a > n is a >= n + 1, and a <= n is a < n + 1.
            let number = value.int() as u32;
            if number == u32::MAX {
                // Never, or always.
                self.value(a);
                let opcode = match op {
                    Compare::Greater => Opcode::UnsignedLess,
                    _ => Opcode::UnsignedGreaterOrEqual,
                };
                return self.comparison(opcode, Operand::Constant(0), b);
            }
            self.value(a);
            let opcode = match op {
                Compare::Greater => Opcode::UnsignedGreaterOrEqual,
                _ => Opcode::UnsignedLess,
            };
            let next = number.wrapping_add(1).cast_signed();
            return self.comparison(opcode, Operand::Constant(next), b);
        }
        // The other way round.
        let operand = self.pair(b, a);
        self.comparison(opcode, operand, a);
    }

    fn compare_reals(&mut self, op: Compare, a: &Expr, b: &Expr) {
        if let ExprKind::Constant(value) = &b.kind {
            self.value(a);
            self.pen.changes_value(Opcode::RealComparable);
            let bits = (value.real() as f32).to_bits().cast_signed();
            let operand = Operand::Constant(unoclp_core::real::comparable(bits));
            return self.comparison(opcode(op), operand, b);
        }
        self.value(a);
        self.pen.changes_value(Opcode::RealComparable);
        self.pen.plain(Opcode::Push);
        self.value(b);
        self.pen.changes_value(Opcode::RealComparable);
        self.comparison(opcode(op), Operand::Popped, b);
    }
}

fn is_block(part: &Bit) -> bool {
    matches!(part, Bit::Or(_) | Bit::Xor(..) | Bit::Is(false))
}

/// Whether this logic begins with a contact of that bit, brought to its front.
fn begins(bit: &mut Bit, held: Seat) -> bool {
    let is = |part: &Bit| matches!(part, Bit::Contact(seat, false, _) if *seat == held);
    match bit {
        Bit::And(parts) | Bit::Or(parts) => match parts.iter().position(is) {
            Some(at) => {
                parts.swap(0, at);
                true
            }
            None => false,
        },
        other => is(other),
    }
}

fn opcode(op: Compare) -> Opcode {
    match op {
        Compare::Equal => Opcode::Equal,
        Compare::NotEqual => Opcode::NotEqual,
        Compare::Less => Opcode::Less,
        Compare::LessEqual => Opcode::LessOrEqual,
        Compare::Greater => Opcode::Greater,
        Compare::GreaterEqual => Opcode::GreaterOrEqual,
    }
}
