//! BOOL expressions as logic whose negations stand at its contacts.
//!
//! Owns how logic is turned round and simplified. Must not know instructions.

use super::coder::Coder;
use super::fails::may_fail;
use super::flat::{constant, read};
use super::seats::Seat;
use unoclp_point::Address;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Binary, Compare, Convert, Expr, ExprKind, Unary, Value};

/// Logic whose negations stand at its contacts.
#[derive(Clone, Debug)]
pub(super) enum Bit {
    Is(bool),
    Contact(Contact),
    /// A comparison, and where it stands.
    Test(Compare, Expr, Expr, Span),
    And(Vec<Bit>),
    Or(Vec<Bit>),
    Xor(Vec<Bit>, bool),
}

/// A contact of a bit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    pub seat: Seat,
    pub negated: bool,
    /// The cell that it reads.
    pub cell: u32,
    /// Where it stands in the text.
    pub at: Span,
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
            Bit::And(inner) => parts.extend(inner),
            other => parts.push(other),
        }
    }
    only_what_matters(&mut parts, false);
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
            Bit::Or(inner) => parts.extend(inner),
            other => parts.push(other),
        }
    }
    only_what_matters(&mut parts, true);
    match parts.len() {
        0 => Bit::Is(false),
        1 => parts.swap_remove(0),
        _ => Bit::Or(parts),
    }
}

pub(super) fn is_block(part: &Bit) -> bool {
    matches!(part, Bit::Or(_) | Bit::Xor(..) | Bit::Is(false))
}

/// Whether this logic begins with a contact of that bit, brought to its front and to that of the parts there.
pub(super) fn begins(bit: &mut Bit, held: Seat) -> bool {
    match bit {
        Bit::And(parts) | Bit::Or(parts) | Bit::Xor(parts, _) => {
            let is =
                |part: &Bit| matches!(part, Bit::Contact(of) if of.seat == held && !of.negated);
            let at = parts.iter().position(is);
            let within = || parts.iter_mut().position(|part| begins(part, held));
            match at.or_else(within) {
                Some(at) => {
                    parts.swap(0, at);
                    true
                }
                None => false,
            }
        }
        Bit::Contact(of) => of.seat == held && !of.negated,
        Bit::Is(_) | Bit::Test(..) => false,
    }
}

/// Where a part is this constant, all of them come to it; the others matter if they may set S 04.
fn only_what_matters(parts: &mut Vec<Bit>, decides: bool) {
    let is = |part: &Bit| matches!(part, Bit::Is(is) if *is == decides);
    if parts.iter().any(is) {
        parts.retain(sets_error);
        parts.insert(0, Bit::Is(decides));
    }
}

fn sets_error(bit: &Bit) -> bool {
    match bit {
        Bit::Is(_) | Bit::Contact(..) => false,
        Bit::Test(_, a, b, _) => may_fail(a) || may_fail(b),
        Bit::And(parts) | Bit::Or(parts) | Bit::Xor(parts, _) => parts.iter().any(sets_error),
    }
}

impl Coder<'_, '_> {
    /// A prepared expression as logic.
    pub(super) fn logic(&self, from: &Expr, negated: bool) -> Bit {
        let test = |op: Compare, a: &Expr, b: &Expr| {
            let op = if negated { opposite(op) } else { op };
            Bit::Test(op, a.clone(), b.clone(), from.at)
        };
        let none = |e: &Expr| match e.base.is_real() {
            true => constant(Value::Real(0.0), e.base, e.at),
            false => constant(Value::Int(0), e.base, e.at),
        };
        match &from.kind {
            ExprKind::Constant(value) => Bit::Is(value.is_true() != negated),
            ExprKind::Read(place) if place.indices.is_empty() => {
                match self.seats.of.get(&place.offset) {
                    Some(Seat::At(Address::Register(_))) => {
                        let held = read(place.offset, Base::Dint, from.at);
                        test(Compare::NotEqual, &held, &none(&held))
                    }
                    Some(&seat) => Bit::Contact(Contact {
                        seat,
                        negated,
                        cell: place.offset,
                        at: from.at,
                    }),
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
                let low = super::flat::both(Binary::And, (**a).clone(), one);
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
}
