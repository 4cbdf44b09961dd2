//! A bit of a number by its place: `word.3`.
//!
//! Owns which numbers have bits, and what reading and storing one comes to.

use super::builder::Builder;
use super::places::Target;
use super::words::both;
use crate::{Base, Binary, Compare, Expr, ExprKind, Generic, Stmt, StmtKind, TypeId, Value};
use unoclp_text::diagnostics::{Code, Span};

/// How many bits the values of this type have; none of what has no bits by their places.
fn width(base: Base) -> Option<u32> {
    let has =
        base.is_on_board() && (base.is_int() || base.is_of(Generic::Bit) && base != Base::Bool);
    match has {
        true => base.range().map(|(least, most)| (most - least + 1).ilog2()),
        false => None,
    }
}

/// The number whose bit at this place alone is 1, as this type holds it.
fn mask(base: Base, place: u32) -> Value {
    let bit = 1_i128 << place;
    let most = base.range().map_or(bit, |(_, most)| most);
    Value::Int(if bit > most { -bit } else { bit })
}

impl Builder<'_, '_> {
    /// Whether the bit at this place is 1: `number.3` as a value.
    pub fn bit(&mut self, number: Option<Target>, place: &str, at: Span) -> Expr {
        let number = self.read(number, at);
        let Some((base, place)) = self.bit_at(&number, place, at) else {
            return self.wrong(at);
        };
        let mask = self.literal(base, mask(base, place), at);
        let zero = self.literal(base, Value::Int(0), at);
        let alone = self.binary(Binary::And, base, TypeId::of(base), number, mask, at);
        self.compare(Compare::NotEqual, alone, zero, at)
    }

    /// `number.3 := value`
    pub fn assign_bit(
        &mut self,
        number: Target,
        place: &str,
        value: Expr,
        place_at: Span,
        at: Span,
    ) -> Option<Stmt> {
        let before = self.read(Some(number.clone()), number.at);
        let found = self.bit_at(&before, place, place_at);
        let value = self.coerce(value, TypeId::BOOL);
        let (base, place) = found?;
        if matches!(value.kind, ExprKind::Wrong) {
            return None;
        }
        let ty = TypeId::of(base);
        let bit = mask(base, place);
        let others = match base.range() {
            Some((0, most)) => Value::Int(most - bit.int()),
            _ => Value::Int(-1 - bit.int()),
        };
        let (bit, others) = (self.literal(base, bit, at), self.literal(base, others, at));
        let set = self.binary(Binary::Or, base, ty, before.clone(), bit, at);
        let clear = self.binary(Binary::And, base, ty, before, others, at);
        let set = self.assign(number.clone(), set, at)?;
        let clear = self.assign(number, clear, at)?;
        Some(match value.kind {
            ExprKind::Constant(ref value) if value.int() != 0 => set,
            ExprKind::Constant(_) => clear,
            _ => Stmt {
                kind: StmtKind::If(vec![(value, vec![set])], vec![clear]),
                at,
            },
        })
    }

    /// The type of a number and the place of a bit that it has; one that it has not is told.
    fn bit_at(&mut self, number: &Expr, place: &str, at: Span) -> Option<(Base, u32)> {
        if matches!(number.kind, ExprKind::Wrong) {
            return None;
        }
        let bits = width(number.base).filter(|_| !self.is_enum(number.ty));
        let known = place.parse().ok();
        if let (Some(bits), Some(place)) = (bits, known)
            && place < bits
        {
            return Some((number.base, place));
        }
        let is = self.type_of(number);
        let help = match bits {
            Some(bits) => both(
                format!("it has bits 0 to {}", bits - 1),
                format!("ele tem os bits 0 a {}", bits - 1),
            ),
            None => both(
                "only INT, WORD and similar types have numbered bits",
                "só INT, WORD e tipos semelhantes têm bits numerados",
            ),
        };
        self.tell(Code::StNoMember, at, [is, place.into(), help]);
        None
    }
}
