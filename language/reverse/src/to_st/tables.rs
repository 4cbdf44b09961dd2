//! Tables of registers, which are arrays.
//!
//! Owns their subscripts. Must not know what is done with an element.

use super::expr::{Expr, binary, compare, or, whole};
use super::machine::{Machine, Number};
use unoclp_core::isa::Operand;

impl Machine<'_, '_> {
    /// The subscript of an array for this index of a table, and the array.
    pub fn subscript(&mut self, index: Number, first: u8, length: u8) -> (u8, Expr) {
        let tables = &self.body.registers.tables;
        let of = tables
            .iter()
            .find(|(from, to)| (*from..=*to).contains(&first));
        let (from, to) = of.copied().unwrap_or((first, first + length - 1));
        let index = match index.0 {
            // A constant subscript must be within.
            Expr::Constant(number, _) if !(0..i32::from(length)).contains(&number) => {
                self.number_aside(index)
            }
            _ => index,
        };
        if (from, to) == (first, first + length - 1) {
            return (from, self.dint(index));
        }
        let index = match index.0.is_simple() {
            true => index,
            false => self.number_aside(index),
        };
        let index = self.dint(index);
        let shifted = binary("+", index.clone(), whole((first - from).into()));
        if let Expr::Constant(number, _) = index {
            return (from, whole(number + i32::from(first - from)));
        }
        // Outside of its own table it is outside of the array.
        let below = compare("<", index.clone(), whole(0));
        let outside = or(below, compare(">=", index, whole(length.into())));
        (from, Expr::Call("SEL", vec![outside, shifted, whole(-1)]))
    }

    pub fn element(&mut self, index: Number, operand: Operand<'_>) -> Number {
        let Operand::Table { first, length } = operand else {
            return index;
        };
        let (table, at) = self.subscript(index, first, length);
        let ty = self.register(table).1;
        Number(Expr::Element(table, Box::new(at)), ty)
    }
}
