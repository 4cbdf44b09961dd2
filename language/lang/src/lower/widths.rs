//! Numbers in the bits of what they are stored in, and between which bounds they are, so that nothing is cut that fits.

use super::{Lower, numbered};
use crate::diagnostics::Span;
use crate::names::kept;
use crate::tree::{Num, Number};
use crate::typed::Base;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

/// The least and the greatest value.
type Bounds = (i64, i64);

const ALL: Bounds = (i32::MIN as i64, i32::MAX as i64);

/// What an analogue input reads at most.
const ANALOGUE: i64 = 1023;

/// The instruction that keeps the bits of a type.
fn cut(base: Base) -> Opcode {
    match base.is_signed() {
        true => Opcode::ExtendSign,
        false => Opcode::ExtendZero,
    }
}

fn fits((low, high): Bounds, base: Base) -> bool {
    let range = base.range();
    range.is_some_and(|(least, most)| least <= low.into() && i128::from(high) <= most)
}

impl Lower<'_, '_> {
    /// A number as a variable of this type keeps it.
    pub(super) fn narrowed(&mut self, number: Number, to: Option<Base>, span: Span) -> Number {
        let Some(base) = to.filter(|base| !fits(self.bounds(&number), *base)) else {
            return number;
        };
        match number.constant() {
            Some(constant) => Number::Leaf(Num::Const(kept(to, constant)), span),
            None => Number::Shift(cut(base), Box::new(number), base.bits() as u8, span),
        }
    }

    /// Cuts what the board's value holds, which is this number or its inverse; whether there was something to cut.
    pub(super) fn narrow(
        &mut self,
        number: &Number,
        negated: bool,
        to: Option<Base>,
        span: Span,
    ) -> bool {
        let (low, high) = self.bounds(number);
        let bounds = match negated {
            true => (!high, !low),
            false => (low, high),
        };
        let to = to.filter(|base| !fits(bounds, *base));
        if let Some(base) = to {
            self.rungs
                .write(numbered(cut(base), base.bits() as u8), span);
        }
        to.is_some()
    }

    fn bounds(&self, number: &Number) -> Bounds {
        let of_type = |base: Base| {
            let range = base.range();
            range.map_or(ALL, |(low, high)| (low as i64, high as i64))
        };
        let within = |(low, high): Bounds| match ALL.0 <= low && high <= ALL.1 {
            true => (low, high),
            false => ALL,
        };
        match number {
            Number::Leaf(Num::Const(number), _) => ((*number).into(), (*number).into()),
            Number::Leaf(Num::At(Address::Register(register)), _) => {
                self.names.register_width(*register).map_or(ALL, of_type)
            }
            Number::Leaf(Num::At(Address::Analogue(_)), _) => (0, ANALOGUE),
            Number::Leaf(Num::At(Address::Group(_)), _) => (0, 255),
            Number::Shift(Opcode::ExtendSign, _, bits @ 1..=31, _) => {
                let most = 1_i64 << (bits - 1);
                (-most, most - 1)
            }
            Number::Shift(Opcode::ExtendZero, _, bits @ 1..=31, _) => (0, (1_i64 << bits) - 1),
            Number::Binary(op, left, right, _) => {
                let ((a, b), (c, d)) = (self.bounds(left), self.bounds(right));
                match op {
                    Opcode::Add => within((a + c, b + d)),
                    Opcode::Subtract => within((a - d, b - c)),
                    Opcode::Multiply => {
                        let all = [a * c, a * d, b * c, b * d];
                        let least = all.into_iter().min().unwrap_or(ALL.0);
                        within((least, all.into_iter().max().unwrap_or(ALL.1)))
                    }
                    // A division by 0 gives 0.
                    Opcode::Divide if c >= 0 => (a.min(0), b.max(0)),
                    Opcode::Modulo if c >= 0 && d > 0 => {
                        ((1 - d).max(a.min(0)), (d - 1).min(b.max(0)))
                    }
                    Opcode::AndWord if a >= 0 => (0, b),
                    Opcode::AndWord if c >= 0 => (0, d),
                    _ => ALL,
                }
            }
            _ => ALL,
        }
    }
}
