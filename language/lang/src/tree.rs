//! What the accumulator holds, as an expression of what it was made from.
//!
//! The compiler runs a program on expressions in place of values. Reading a point changes nothing, so an
//! expression is written out as codes only where something is done with it, in the order that takes fewest.

use crate::diagnostics::Span;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

/// A bit that can be read; the Q of a timer by its index among the names, since its number depends on its block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bit {
    At(Address),
    Timer(usize),
}

/// A number that can be read or written; those of a timer by its index likewise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Num {
    Const(i32),
    At(Address),
    Elapsed(usize),
    TimerPreset(usize),
}

/// A logic expression.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Expr {
    /// What the board's own accumulator holds at this moment.
    Live,
    Const(bool),
    Lit {
        bit: Bit,
        negated: bool,
        span: Span,
    },
    Compare {
        op: Opcode,
        left: Box<Number>,
        right: Box<Number>,
        span: Span,
    },
    Not(Box<Expr>),
    And(Vec<Expr>),
    Or(Vec<Expr>),
    Xor(Vec<Expr>),
}

/// A numeric expression.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Number {
    /// What the board's value holds at this moment.
    Live,
    Leaf(Num, Span),
    Binary(Opcode, Box<Number>, Box<Number>, Span),
    Unary(Opcode, Box<Number>, Span),
    Shift(Opcode, Box<Number>, u8, Span),
}

impl Expr {
    pub(crate) fn and(self, other: Expr) -> Expr {
        match (self, other) {
            (Expr::Const(true), other) | (other, Expr::Const(true)) => other,
            (Expr::Const(false), _) | (_, Expr::Const(false)) => Expr::Const(false),
            (Expr::And(mut list), Expr::And(more)) => {
                list.extend(more);
                Expr::And(list)
            }
            (Expr::And(mut list), other) => {
                list.push(other);
                Expr::And(list)
            }
            (one, Expr::And(more)) => Expr::And(std::iter::once(one).chain(more).collect()),
            (one, other) => Expr::And(vec![one, other]),
        }
    }

    pub(crate) fn or(self, other: Expr) -> Expr {
        match (self, other) {
            (Expr::Const(false), other) | (other, Expr::Const(false)) => other,
            (Expr::Const(true), _) | (_, Expr::Const(true)) => Expr::Const(true),
            (Expr::Or(mut list), Expr::Or(more)) => {
                list.extend(more);
                Expr::Or(list)
            }
            (Expr::Or(mut list), other) => {
                list.push(other);
                Expr::Or(list)
            }
            (one, Expr::Or(more)) => Expr::Or(std::iter::once(one).chain(more).collect()),
            (one, other) => Expr::Or(vec![one, other]),
        }
    }

    pub(crate) fn xor(self, other: Expr) -> Expr {
        match (self, other) {
            (Expr::Const(false), other) | (other, Expr::Const(false)) => other,
            (Expr::Const(true), other) | (other, Expr::Const(true)) => other.not(),
            (Expr::Xor(mut list), other) => {
                list.push(other);
                Expr::Xor(list)
            }
            (one, other) => Expr::Xor(vec![one, other]),
        }
    }

    pub(crate) fn not(self) -> Expr {
        match self {
            Expr::Not(inner) => *inner,
            Expr::Const(state) => Expr::Const(!state),
            Expr::Lit { bit, negated, span } => Expr::Lit {
                bit,
                negated: !negated,
                span,
            },
            other => Expr::Not(Box::new(other)),
        }
    }

    /// Whether the board's accumulator must not be touched before this is written out.
    pub(crate) fn has_live(&self) -> bool {
        match self {
            Expr::Live => true,
            Expr::Const(_) | Expr::Lit { .. } | Expr::Compare { .. } => false,
            Expr::Not(inner) => inner.has_live(),
            Expr::And(list) | Expr::Or(list) | Expr::Xor(list) => list.iter().any(Expr::has_live),
        }
    }

    /// Whether it must be written out first: it needs the accumulator or the value as they stand.
    pub(crate) fn is_first(&self) -> bool {
        match self {
            Expr::Live => true,
            Expr::Const(_) | Expr::Lit { .. } => false,
            Expr::Compare { left, right, .. } => left.has_live() || right.has_live(),
            Expr::Not(inner) => inner.is_first(),
            Expr::And(list) | Expr::Or(list) | Expr::Xor(list) => list.iter().any(Expr::is_first),
        }
    }

    /// Whether it reads this bit.
    pub(crate) fn reads(&self, wanted: &impl Fn(Bit) -> bool) -> bool {
        match self {
            Expr::Live | Expr::Const(_) => false,
            Expr::Lit { bit, .. } => wanted(*bit),
            // Which number it reads is not asked.
            Expr::Compare { .. } => true,
            Expr::Not(inner) => inner.reads(wanted),
            Expr::And(list) | Expr::Or(list) | Expr::Xor(list) => {
                list.iter().any(|part| part.reads(wanted))
            }
        }
    }

    /// Where its first part stands in the text.
    pub(crate) fn place(&self) -> Option<Span> {
        match self {
            Expr::Live | Expr::Const(_) => None,
            Expr::Lit { span, .. } | Expr::Compare { span, .. } => Some(*span),
            Expr::Not(inner) => inner.place(),
            Expr::And(list) | Expr::Or(list) | Expr::Xor(list) => list.iter().find_map(Expr::place),
        }
    }

    /// How many codes write it out, where the accumulator is 1 before; or in series with what it holds.
    pub(crate) fn cost(&self, series: bool) -> usize {
        match self {
            Expr::Live => 0,
            Expr::Const(true) => 0,
            Expr::Const(false) => 1 + 2 * usize::from(series),
            Expr::Lit { .. } => 1,
            Expr::Compare { left, right, .. } => 1 + left.cost() + right.cost(),
            Expr::Not(inner) => inner.cost(false) + 1 + 2 * usize::from(series),
            Expr::And(list) => {
                let all: usize = list.iter().map(|part| part.cost(true)).sum();
                let saved = list.iter().any(|part| part.brackets());
                all - if saved && !series { 2 } else { 0 }
            }
            Expr::Or(list) => {
                let all: usize = list.iter().map(|part| part.cost(false) + 2).sum();
                all - if series { 0 } else { 2 }
            }
            Expr::Xor(list) => {
                let all: usize = list
                    .iter()
                    .map(|part| part.cost(false) + if part.is_xor_point() { 0 } else { 2 })
                    .sum();
                let first_is_free = list.iter().any(|part| !part.is_xor_point());
                all + 2 * usize::from(series) - if first_is_free { 2 } else { 0 }
            }
        }
    }

    /// Whether it takes brackets to be in series.
    pub(crate) fn brackets(&self) -> bool {
        matches!(self, Expr::Or(_) | Expr::Xor(_) | Expr::Not(_))
    }

    /// Whether there is a code for XOR with it.
    pub(crate) fn is_xor_point(&self) -> bool {
        matches!(self, Expr::Lit { bit: Bit::At(point), .. } if point.xor(false).is_some())
    }

    /// The same, with each NOT where it takes fewest codes.
    pub(crate) fn settled(self) -> Expr {
        let all = |list: Vec<Expr>| list.into_iter().map(Expr::settled).collect();
        match self {
            Expr::And(list) => Expr::And(all(list)),
            Expr::Or(list) => Expr::Or(all(list)),
            Expr::Xor(list) => Expr::Xor(all(list)),
            Expr::Not(inner) => {
                let inner = inner.settled();
                let inverted = inner.inverted();
                if inverted.cost(true) <= inner.cost(false) + 1 {
                    inverted
                } else {
                    Expr::Not(Box::new(inner))
                }
            }
            other => other,
        }
    }

    /// The opposite, with NOT at the leaves.
    fn inverted(&self) -> Expr {
        let all = |list: &[Expr]| list.iter().map(Expr::inverted).collect();
        match self {
            Expr::Compare {
                op,
                left,
                right,
                span,
            } => Expr::Compare {
                op: opposite(*op),
                left: left.clone(),
                right: right.clone(),
                span: *span,
            },
            Expr::And(list) => Expr::Or(all(list)),
            Expr::Or(list) => Expr::And(all(list)),
            Expr::Xor(list) => {
                let leaf = |part: &Expr| matches!(part, Expr::Lit { .. });
                let at = list.iter().position(leaf).unwrap_or(0);
                let inverted = |(index, part): (usize, &Expr)| match index == at {
                    true => part.clone().not(),
                    false => part.clone(),
                };
                Expr::Xor(list.iter().enumerate().map(inverted).collect())
            }
            other => other.clone().not(),
        }
    }
}

impl Number {
    pub(crate) fn has_live(&self) -> bool {
        match self {
            Number::Live => true,
            Number::Leaf(..) => false,
            Number::Binary(_, left, right, _) => left.has_live() || right.has_live(),
            Number::Unary(_, inner, _) | Number::Shift(_, inner, ..) => inner.has_live(),
        }
    }

    fn cost(&self) -> usize {
        match self {
            Number::Live => 0,
            Number::Leaf(..) => 1,
            Number::Binary(_, left, right, _) => left.cost() + right.cost(),
            Number::Unary(_, inner, _) | Number::Shift(_, inner, ..) => inner.cost() + 1,
        }
    }

    /// The number that it is for certain.
    pub(crate) fn constant(&self) -> Option<i32> {
        match self {
            Number::Leaf(Num::Const(number), _) => Some(*number),
            _ => None,
        }
    }
}

/// The comparison that holds where this one does not.
fn opposite(op: Opcode) -> Opcode {
    partner(op, &OPPOSITES)
}

/// The comparison that holds where this one holds of the operands exchanged.
pub(crate) fn exchanged(op: Opcode) -> Option<Opcode> {
    // Of those without signs there are only two.
    let unsigned = [Opcode::UnsignedGreaterOrEqual, Opcode::UnsignedLess].contains(&op);
    (!unsigned).then(|| partner(op, &EXCHANGED))
}

const OPPOSITES: [(Opcode, Opcode); 4] = [
    (Opcode::Greater, Opcode::LessOrEqual),
    (Opcode::GreaterOrEqual, Opcode::Less),
    (Opcode::Equal, Opcode::NotEqual),
    (Opcode::UnsignedGreaterOrEqual, Opcode::UnsignedLess),
];

/// The others are their own.
const EXCHANGED: [(Opcode, Opcode); 2] = [
    (Opcode::Greater, Opcode::Less),
    (Opcode::GreaterOrEqual, Opcode::LessOrEqual),
];

/// The other of the pair that a comparison stands in; itself where it stands in none.
fn partner(op: Opcode, pairs: &[(Opcode, Opcode)]) -> Opcode {
    let other = |&(one, other): &(Opcode, Opcode)| match op {
        _ if op == one => Some(other),
        _ if op == other => Some(one),
        _ => None,
    };
    pairs.iter().find_map(other).unwrap_or(op)
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_core::isa::Class;

    #[test]
    fn every_comparison_has_an_opposite() {
        for &op in Opcode::ALL {
            if op.class() == Class::Comparison {
                assert_ne!(opposite(op), op, "{op:?}: add it to OPPOSITES");
                assert_eq!(opposite(opposite(op)), op);
            }
        }
    }
}
