//! The accumulator over a label: jumps may come with it, so all ways leave it in one place.

use super::{Acc, Lower};
use crate::ast::Stmt;
use crate::diagnostics::{Code, Span};
use crate::operators::Op;
use crate::tree::{Bit, Expr, Num, Number};
use std::collections::HashSet;
use unoclp_core::Target;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;

/// Where the ways to a label leave the accumulator.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Carry {
    Marker(u8),
    Register(u8),
}

/// The labels after which the accumulator is used before anything is loaded.
pub(super) fn needs(body: &[Stmt]) -> HashSet<String> {
    let mut needs = HashSet::new();
    let mut used = false;
    for stmt in body.iter().rev() {
        match stmt {
            Stmt::Label(word) => {
                if used {
                    needs.insert(word.text.clone());
                }
            }
            Stmt::Close(_) => used = true,
            Stmt::Wrong { .. } => used = false,
            Stmt::Instr(instr) => {
                used = match instr.op {
                    _ if instr.conditional => true,
                    // Of a label further up it is not known yet, and taken as not.
                    Op::Jump => {
                        let target = instr.operands.first().and_then(|operand| operand.name());
                        target.is_some_and(|target| needs.contains(target))
                    }
                    Op::Load
                    | Op::Recall
                    | Op::Release
                    | Op::Call
                    | Op::Function
                    | Op::Return
                    | Op::End
                    | Op::Code => false,
                    Op::Block | Op::OutBlock | Op::EndBlock => false,
                    _ => true,
                };
            }
        }
    }
    needs
}

impl Lower<'_, '_> {
    /// Leaves the accumulator where the way from the label on takes it from.
    pub(super) fn carry_to(&mut self, label: usize, name: &str, span: Span) {
        self.unused = None;
        let carry = self.labels[label].carry;
        let acc = match (std::mem::replace(&mut self.acc, Acc::Unknown), carry) {
            // The constants 0 and 1 are both bit and number.
            (Acc::Number(number), Some(Carry::Marker(_)))
                if matches!(number.constant(), Some(0..=1)) =>
            {
                Acc::Bit(Expr::Const(number.constant() == Some(1)))
            }
            (acc, _) => acc,
        };
        match (acc, carry) {
            (Acc::Empty, _) => self.found.tell(Code::NothingLoaded, span, [name.into()]),
            (Acc::Unknown, _) => {}
            (Acc::Bit(_), Some(Carry::Register(_))) => {
                self.wrong_type(
                    super::ACCUMULATOR.to_owned(),
                    span,
                    super::BOOL,
                    super::NUMBER,
                );
            }
            (Acc::Number(_), Some(Carry::Marker(_))) => {
                self.wrong_type(
                    super::ACCUMULATOR.to_owned(),
                    span,
                    super::NUMBER,
                    super::BOOL,
                );
            }
            (Acc::Bit(expr), _) => {
                let marker = match carry {
                    Some(Carry::Marker(marker)) => marker,
                    _ => self.rungs.temps.lasting_marker(),
                };
                self.labels[label].carry = Some(Carry::Marker(marker));
                self.bring(expr, span);
                self.rungs.coil(Target::Marker(marker), false, span);
            }
            (Acc::Number(number), _) => {
                let register = match carry {
                    Some(Carry::Register(register)) => register,
                    _ => self.rungs.temps.lasting_register(),
                };
                self.labels[label].carry = Some(Carry::Register(register));
                self.freeze(span);
                self.rungs.fresh(span);
                self.rungs.number(&number);
                self.write(Opcode::Store, register, span);
                self.acc = Acc::Number(Number::Leaf(Num::At(Address::Register(register)), span));
            }
        }
    }

    /// The accumulator after a label that needs it. Where no way above leads there, it is taken for a bit.
    pub(super) fn carried(&mut self, label: usize, span: Span) -> Acc {
        let carry = match self.labels[label].carry {
            Some(carry) => carry,
            None => Carry::Marker(self.rungs.temps.lasting_marker()),
        };
        self.labels[label].carry = Some(carry);
        match carry {
            Carry::Marker(marker) => super::timers::lit(Bit::At(Address::Marker(marker)), span),
            Carry::Register(register) => {
                Acc::Number(Number::Leaf(Num::At(Address::Register(register)), span))
            }
        }
    }
}
