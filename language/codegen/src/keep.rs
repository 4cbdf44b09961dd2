//! What is put aside in a temporary until its statement ends.
//!
//! Owns temporaries and what is stored in them where a condition holds.

use super::coder::Coder;
use super::flat::{place, read};
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Expr, ExprKind, Place, Store};

impl Coder<'_, '_> {
    /// A temporary for values of this type, narrowed to it.
    pub(super) fn temporary(&mut self, base: Base, at: Span) -> (Place, Expr) {
        self.temporary_for(base, at, false)
    }

    pub(super) fn temporary_for(&mut self, base: Base, at: Span, wide: bool) -> (Place, Expr) {
        let cell = self.seats.temporary(base == Base::Bool, wide);
        (place(cell, at), read(cell, base, at))
    }

    /// A prepared value in a temporary.
    pub(super) fn keep(&mut self, value: Expr) -> Expr {
        let wide = !self.is_within(&value, value.base);
        let (to, held) = self.temporary_for(value.base, value.at, wide);
        self.put(&to, &value);
        Expr {
            ty: value.ty,
            ..held
        }
    }

    /// Stores a prepared value as it is.
    pub(super) fn put(&mut self, to: &Place, value: &Expr) {
        self.assign_prepared(to, value, Store::Narrow(Base::Dint));
    }

    /// The same value by what is simple.
    pub(super) fn simple(&mut self, value: Expr) -> Expr {
        match self.operand(&value) {
            Some(_) => value,
            None => self.keep(value),
        }
    }

    /// Stores a prepared value where a prepared condition holds. The value is computed either way.
    pub(super) fn guarded(&mut self, condition: &Expr, to: &Place, value: &Expr) {
        self.bit(condition, false);
        self.value(value);
        self.store(to.offset);
    }

    /// What a register holds becomes 0, and S 04 is set, where this holds.
    pub(super) fn zero_where(&mut self, wrong: &Expr, held: &Expr) {
        self.bit(wrong, false);
        self.pen.border(Opcode::If);
        self.fail();
        if let ExprKind::Read(place) = &held.kind {
            self.store(place.offset);
        }
        self.pen.border(Opcode::EndIf);
        self.pen.holds = None;
    }
}
