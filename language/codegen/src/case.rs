//! CASE: the arms in the ELSE of one another, or one after another.
//!
//! Owns how a number is found among bounds.

use super::choice::MOST_IFS;
use super::coder::Coder;
use super::flat::{Arm, Step};
use super::operand::bits;
use super::pen::Acc;
use unoclp_core::isa::{Opcode, Value as Taken};
use unoclp_tree::{Base, Expr, ExprKind, Value};

/// The cell of a number that is read as it stands.
fn cell_of(number: &Expr) -> Option<u32> {
    match &number.kind {
        ExprKind::Read(place) => Some(place.offset),
        _ => None,
    }
}

impl Coder<'_, '_> {
    pub(super) fn case(&mut self, selector: &Expr, arms: &[Arm], otherwise: &[Step]) {
        let (at, base, cell) = (self.pen.at, selector.base, cell_of(selector));
        let selector = self.prepare(selector.clone());
        if arms.is_empty() {
            return self.steps(otherwise);
        }
        let room = MOST_IFS.saturating_sub(self.deep) as usize;
        if arms.len() <= room {
            self.pen.fresh();
            self.value(&selector);
            self.tests_number(at, base, cell);
            return self.arms(&selector, arms, otherwise);
        }
        // More than IFs can stand in one another: one after another, by a copy of the number.
        let held = self.keep(selector);
        for (number, (bounds, body)) in arms.iter().enumerate() {
            self.pen.fresh();
            self.value(&held);
            if number == 0 {
                self.tests_number(at, base, cell);
            }
            self.one_of(bounds, self.is_unsigned(&held));
            self.parts(|this| this.steps(body), &[]);
        }
        if otherwise.is_empty() {
            return;
        }
        self.pen.fresh();
        self.value(&held);
        let mut first = true;
        for (bounds, _) in arms {
            for bound in bounds {
                if !first {
                    self.pen.plain(Opcode::OpenBranch);
                }
                self.between(*bound, self.is_unsigned(&held));
                if !first {
                    self.pen.plain(Opcode::CloseBranch);
                }
                first = false;
            }
        }
        self.pen.plain(Opcode::Not);
        self.pen.acc = Acc::Other;
        self.parts(|this| this.steps(otherwise), &[]);
    }

    /// The arms one in the ELSE of another; value is the selector, which nothing on that way changes.
    fn arms(&mut self, selector: &Expr, arms: &[Arm], otherwise: &[Step]) {
        let Some(((bounds, body), rest)) = arms.split_first() else {
            return self.steps(otherwise);
        };
        let holds = self.pen.holds;
        self.one_of(bounds, self.is_unsigned(selector));
        if rest.is_empty() && otherwise.is_empty() && self.is_plain(body) {
            return self.conditional(body);
        }
        self.deep += 1;
        self.pen.border(Opcode::If);
        self.steps(body);
        if !rest.is_empty() || !otherwise.is_empty() {
            self.pen.border(Opcode::Else);
            self.pen.holds = holds;
            self.arms(selector, rest, otherwise);
        }
        self.pen.border(Opcode::EndIf);
        self.pen.holds = None;
        self.deep -= 1;
    }

    /// acc := whether value is within one of these bounds.
    fn one_of(&mut self, bounds: &[(i128, i128)], unsigned: bool) {
        for (at, bound) in bounds.iter().enumerate() {
            if at > 0 {
                self.pen.plain(Opcode::OpenBranch);
            }
            self.between(*bound, unsigned);
            if at > 0 {
                self.pen.plain(Opcode::CloseBranch);
            }
        }
        self.pen.acc = Acc::Other;
    }

    fn between(&mut self, (low, high): (i128, i128), unsigned: bool) {
        let holds = self.pen.holds;
        let number = |number: i128| Taken::Constant(bits(&Value::Int(number), Base::Dint));
        if low == high {
            self.pen.operation(Opcode::Equal, number(low), None);
        } else if unsigned {
            self.pen
                .operation(Opcode::UnsignedGreaterOrEqual, number(low), None);
            if high < i128::from(u32::MAX) {
                self.pen
                    .operation(Opcode::UnsignedLess, number(high + 1), None);
            }
        } else {
            self.pen
                .operation(Opcode::GreaterOrEqual, number(low), None);
            self.pen.operation(Opcode::LessOrEqual, number(high), None);
        }
        self.pen.holds = holds;
        self.pen.acc = Acc::Other;
    }
}
