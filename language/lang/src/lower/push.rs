//! PUSH, and what works on the number that it has pushed; tables, which need it.
//!
//! Here the board's own stack is used as the text says, so numbers are worked out at once.

use super::said::name;
use super::{ACCUMULATOR, Acc, Lower};
use crate::ast::Instr;
use crate::diagnostics::{Code, Span};
use crate::names::Place;
use crate::rung::Written;
use crate::tree::{Expr, Num, Number};
use unoclp_core::isa::{Class, Opcode, REGISTERS, Value};
use unoclp_point::Address;

impl Lower<'_, '_> {
    /// PUSH: the number waits on the board's stack, and stays where it is.
    pub(super) fn push(&mut self, instr: &Instr) {
        if self.live_number("PUSH", instr.span).is_none() {
            return;
        }
        self.rungs.write(Written::Plain(Opcode::Push), instr.whole);
        self.pushed = self.pushed.saturating_add(1);
        // Nothing needs to be done with it but to take it again.
        self.unused = None;
    }

    /// An operation of the number that was pushed last with the accumulator.
    pub(super) fn pop(&mut self, instr: &Instr, opcode: Opcode, acc: Acc) {
        let span = instr.whole;
        let Some(number) = self.as_number(acc, ACCUMULATOR, span) else {
            return;
        };
        self.pushed = self.pushed.saturating_sub(1);
        if opcode.class() != Class::Comparison {
            self.rungs.number(&number);
            self.rungs
                .write(Written::Value(opcode, Value::Popped), span);
            self.acc = Acc::Number(Number::Live);
            return;
        }
        self.freeze(span);
        self.rungs.number(&number);
        self.rungs
            .changes(Written::Value(opcode, Value::Popped), span);
        self.acc = Acc::Bit(Expr::Live);
    }

    /// TABLE_LD, TABLE_ST.
    pub(super) fn table(&mut self, instr: &Instr, opcode: Opcode) {
        let span = instr.whole;
        let what = name(instr.op);
        let stores = opcode == Opcode::StoreTable;
        self.writes |= stores;
        let Some((first, length)) = self.table_operands(instr, what) else {
            self.take_acc(what, instr.span);
            return;
        };
        if self.live_number(what, instr.span).is_none() {
            return;
        }
        if stores {
            self.pushed = self.pushed.saturating_sub(1);
        }
        self.rungs
            .write(Written::Table(opcode, first, length), span);
    }

    /// The first register of a table, and how many it has.
    fn table_operands(&mut self, instr: &Instr, what: &str) -> Option<(u8, u8)> {
        let [first, length, ..] = &instr.operands[..] else {
            let example = ("D1, 8", "D1, 8");
            let words = [what.into(), example.into()];
            self.found.tell(Code::OperandMissing, instr.span, words);
            return None;
        };
        self.only(instr, 2);
        let register = match self.place(first) {
            Place::Number(Num::At(Address::Register(register))) => Some(register),
            Place::Unknown => return None,
            _ => None,
        };
        let Some(register) = register else {
            let text = self.spelled(first);
            let range = ("a register", "um registrador");
            let words = [text.into(), range.into()];
            self.found.tell(Code::BadValue, first.span, words);
            return None;
        };
        let most = REGISTERS + 1 - register;
        let fits = |length: &u8| (1..=most).contains(length);
        let count = length.number().and_then(|count| u8::try_from(count).ok());
        let Some(count) = count.filter(fits) else {
            let text = self.spelled(length);
            let range = (
                format!("a number from 1 to {most}"),
                format!("um número de 1 a {most}"),
            );
            let words = [text.into(), range.into()];
            self.found.tell(Code::BadValue, length.span, words);
            return None;
        };
        Some((register, count))
    }

    /// Brings the accumulator, which must be a number, into the board's value. What changes something begins in a
    /// rung where the board's accumulator is 1.
    fn live_number(&mut self, what: &str, span: Span) -> Option<()> {
        let acc = self.take_acc(what, span);
        let number = self.as_number(acc, ACCUMULATOR, span)?;
        if self.pushed == 0 {
            self.freeze(span);
            if self.frames.is_empty() && !number.has_live() {
                self.rungs.fresh(span);
            }
        }
        self.rungs.number(&number);
        self.acc = Acc::Number(Number::Live);
        Some(())
    }
}
