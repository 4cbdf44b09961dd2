//! From steps to instructions.
//!
//! Owns the order of statements and jumps. Must not know the text, nor the numbers of labels and timers.

use super::coder::Coder;
use super::flat::{Does, Step};
use super::pen::Acc;
use super::traces::Shows;
use unoclp_core::isa::Opcode;
use unoclp_text::diagnostics::Code;
use unoclp_tree::{Expr, ExprKind, Order, Unary};

/// Whether a negation of it costs as much as it does.
fn is_logic(inner: &Expr) -> bool {
    matches!(
        inner.kind,
        ExprKind::Binary(..) | ExprKind::Select(_) | ExprKind::Ordered(..)
    )
}

impl Coder<'_, '_> {
    pub(super) fn steps(&mut self, steps: &[Step]) {
        let mut rest = steps;
        while let Some((step, behind)) = rest.split_first() {
            rest = behind;
            self.pen.at = step.at;
            self.shown = step.shown;
            let mark = self.seats.mark();
            if let Does::Standard(block, cell, inputs) = &step.does {
                if self.standard(*block, *cell, inputs, behind.first()) {
                    rest = behind.get(1..).unwrap_or_default();
                }
            } else if let Does::Codes(before, codes, to) = &step.does {
                self.codes(before.as_ref(), codes, *to, behind.first());
            } else {
                self.step(step);
            }
            self.seats.release_to(mark);
            if self.seats.none_left && !self.found.has_errors() {
                let words = ("register or marker", "registrador ou memória");
                let what = (
                    "an intermediate value of this statement",
                    "um valor intermediário deste comando",
                );
                let words = [words.into(), ("98 and 56", "98 e 56").into(), what.into()];
                self.found.tell(Code::BoardNoneLeft, step.at, words);
            }
        }
    }

    fn step(&mut self, step: &Step) {
        match &step.does {
            Does::Assign(to, value, store) => self.assign(to, value, *store),
            Does::Copy(to, from, cells) => self.copy(to, from, *cells),
            Does::If(condition, then, otherwise) => self.choice(condition, then, otherwise),
            Does::Case(selector, arms, otherwise) => self.case(selector, arms, otherwise),
            Does::Label(label) => self.pen.label(*label),
            Does::Jump(condition, label, back) => match condition {
                None => {
                    self.pen.fresh();
                    self.pen.jump(Opcode::Jump, *label, *back);
                }
                Some(condition) => {
                    let at = condition.at;
                    let condition = self.prepare(condition.clone());
                    let (condition, opcode) = match condition.kind {
                        ExprKind::Unary(Unary::Not, inner) if is_logic(&inner) => {
                            (*inner, Opcode::JumpNot)
                        }
                        _ => (condition, Opcode::Jump),
                    };
                    self.bit(&condition, false);
                    // UNTIL jumps back where what it tests does not hold.
                    let inverted = (opcode == Opcode::JumpNot) != back.is_some();
                    self.tests(at, Shows::Power { inverted });
                    self.pen.jump(opcode, *label, *back);
                    // After it acc is known, but not 1.
                    self.pen.acc = Acc::Other;
                }
            },
            Does::Standard(..) | Does::Codes(..) => {}
            Does::Order(order, block, cell) => {
                let order = match order {
                    Order::Preset(value) => Order::Preset(self.prepare(value.clone())),
                    Order::Number(value) => Order::Number(self.prepare(value.clone())),
                    other => other.clone(),
                };
                self.pen.fresh();
                self.order(&order, *block, *cell);
            }
            Does::Fail => {
                self.fail();
            }
        }
    }
}
