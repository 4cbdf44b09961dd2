//! The types of numbers, and what goes between them.
//!
//! Owns which type a number is taken for. Must not know operations.

use super::expr::{Expr, Place, Type, View, binary, call, compare, whole};
use super::machine::{Machine, Number};

/// The bits of a REAL number but its sign.
const SIZE: i32 = i32::MAX;

impl Machine<'_, '_> {
    /// What a register holds.
    pub fn register(&self, register: u8) -> Number {
        let view = self.body.registers.view(register);
        let ty = match view {
            View::Real => Type::Real,
            View::Whole => Type::Dint,
        };
        match self.body.registers.table(register) {
            Some(table) => {
                let at = whole((register - table).into());
                Number(Expr::Element(table, Box::new(at)), ty)
            }
            None => Number(Expr::Place(Place::Register(register, view)), ty),
        }
    }

    /// The same bits as another type.
    fn seen_as(&mut self, number: Number, view: View) -> Expr {
        let place = match number.0 {
            Expr::Place(place) => Some(place),
            _ => None,
        };
        let other = match place {
            Some(Place::Register(register, _)) => Place::Register(register, view),
            Some(Place::Number(aside, _)) => Place::Number(aside, view),
            Some(Place::Value(_)) => Place::Value(view),
            _ => {
                let Number(Expr::Place(Place::Number(aside, _)), _) = self.number_aside(number)
                else {
                    return whole(0);
                };
                Place::Number(aside, view)
            }
        };
        Expr::Place(other)
    }

    pub fn dint(&mut self, number: Number) -> Expr {
        let number = self.resolved(number);
        match number {
            Number(expr, Type::Dint) => expr,
            Number(Expr::Constant(bits, _), _) => whole(bits),
            Number(expr, Type::Dword) => call("DWORD_TO_DINT", expr),
            Number(expr, Type::Udint) => call("UDINT_TO_DINT", expr),
            real => self.seen_as(real, View::Whole),
        }
    }

    pub fn dword(&mut self, number: Number) -> Expr {
        match number {
            Number(expr, Type::Dword) => expr,
            Number(Expr::Constant(bits, _), _) => Expr::Constant(bits, Type::Dword),
            other => call("DINT_TO_DWORD", self.dint(other)),
        }
    }

    pub fn udint(&mut self, number: Number) -> Expr {
        match number {
            Number(expr, Type::Udint) => expr,
            Number(Expr::Constant(bits, _), _) => Expr::Constant(bits, Type::Udint),
            other => call("DINT_TO_UDINT", self.dint(other)),
        }
    }

    pub fn real(&mut self, number: Number) -> Expr {
        match number {
            Number(expr, Type::Real) => expr,
            Number(Expr::Constant(bits, _), _) if is_finite(bits) => {
                Expr::Constant(bits, Type::Real)
            }
            other => {
                let expr = self.dint(other);
                self.seen_as(Number(expr, Type::Dint), View::Real)
            }
        }
    }

    /// A number of which the order of REAL numbers is computed, where it is not compared with another such.
    pub fn resolved(&mut self, number: Number) -> Number {
        let Number(Expr::Order(real), _) = number else {
            return number;
        };
        let bits = self.dint(Number(*real, Type::Real));
        let size = binary(
            "AND",
            call("DINT_TO_DWORD", bits.clone()),
            Expr::Constant(SIZE, Type::Dword),
        );
        let negative = Expr::Negate(Box::new(call("DWORD_TO_DINT", size)));
        let is_negative = compare("<", bits.clone(), whole(0));
        Number(
            Expr::Call("SEL", vec![is_negative, bits, negative]),
            Type::Dint,
        )
    }
}

pub(super) fn is_finite(bits: i32) -> bool {
    f32::from_bits(bits.cast_unsigned()).is_finite()
}
