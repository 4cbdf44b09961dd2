//! What an operation takes as it stands, and what is known of a value without computing it.
//!
//! Must not know instructions.

use super::coder::Coder;
use super::ranges::bounds;
use super::seats::Seat;
use unoclp_core::isa::Value as Taken;
use unoclp_point::Address;
use unoclp_tree::{Base, Binary, Convert, Expr, ExprKind, Value, Width};

/// A constant as a register holds it.
pub(super) fn bits(value: &Value, base: Base) -> i32 {
    match value {
        Value::Real(number) => (*number as f32).to_bits().cast_signed(),
        Value::Int(number) if base.is_real() => (*number as f32).to_bits().cast_signed(),
        other => other.int() as i32,
    }
}

impl Coder<'_, '_> {
    /// What an operation takes as it stands: a constant or a register.
    pub(super) fn operand(&self, expr: &Expr) -> Option<Taken> {
        match &expr.kind {
            ExprKind::Constant(value) => Some(Taken::Constant(bits(value, expr.base))),
            ExprKind::Read(place) if place.indices.is_empty() => {
                match self.seats.of.get(&place.offset) {
                    Some(Seat::At(Address::Register(register))) => Some(Taken::Register(*register)),
                    _ => None,
                }
            }
            ExprKind::Convert(Convert::Keep | Convert::Raw, a) if a.base != Base::Bool => {
                self.operand(a)
            }
            ExprKind::Convert(Convert::Wrap, a)
                if a.base != Base::Bool && self.is_within(a, expr.base) =>
            {
                self.operand(a)
            }
            _ => None,
        }
    }

    /// The cell that an operand names.
    pub(super) fn named_operand(&self, operand: Taken, expr: &Expr) -> Option<u32> {
        match (operand, &expr.kind) {
            (Taken::Register(_), ExprKind::Read(place)) => Some(place.offset),
            (Taken::Register(_), ExprKind::Convert(_, a)) => self.named_operand(operand, a),
            _ => None,
        }
    }

    /// Whether each value of it is one of this type.
    pub(super) fn is_within(&self, expr: &Expr, base: Base) -> bool {
        let Some((least, most)) = base.range() else {
            return true;
        };
        if base.bits() == 32 && !base.is_date() {
            return true;
        }
        let (low, high) = bounds(expr);
        least <= low && high <= most
    }

    pub(super) fn is_unsigned(&self, expr: &Expr) -> bool {
        expr.base.width() == Width::Unsigned
    }

    /// How many values wait at most while this is computed.
    pub(super) fn height(&self, expr: &Expr) -> u32 {
        let of = |e: &Expr| self.height(e);
        match &expr.kind {
            ExprKind::Binary(Binary::RotateLeft | Binary::RotateRight, ..) => 1,
            ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => match self.operand(b) {
                Some(_) => of(a),
                None => of(a).max(of(b) + 1),
            },
            ExprKind::Convert(_, a) | ExprKind::Unary(_, a) => of(a),
            ExprKind::Read(place) => place
                .indices
                .iter()
                .map(|i| of(&i.subscript))
                .max()
                .unwrap_or(0),
            _ => 0,
        }
    }
}
