//! PUSH, and what works on the number that it has pushed; tables, which need it.

use super::bits::name;
use super::front::Front;
use super::said::ACCUMULATOR;
use super::walk::Walk;
use crate::ast::{Instr, Operand, Stmt};
use crate::diagnostics::{Code, Span};
use crate::list::{Acc, Accumulator, Changes, Machine};
use crate::names::Place;
use crate::operators::Op;
use crate::points;
use crate::tree::Num;
use crate::typed::{Base, Expr, ExprKind, Stmt as Made, StmtKind, Store};
use unoclp_core::Cause;
use unoclp_core::isa::{DEEPEST, Opcode, REGISTERS};
use unoclp_point::Address;

impl Walk<'_, '_, '_> {
    /// PUSH: the number waits, and stays where it is.
    pub(super) fn push_number(&mut self, instr: &Instr) {
        let expr = self.take("PUSH", instr.span);
        let number = expr.and_then(|expr| self.as_number(expr, ACCUMULATOR, instr.span));
        let Some(number) = number else { return };
        if self.run.pushed.len() >= usize::from(DEEPEST) {
            return self.refused(Cause::PushedTooDeep, instr.whole);
        }
        self.hold(Some(number));
        if self.needed() {
            self.settle_costly();
        }
        if let Acc::Value(held) = self.run.acc.clone() {
            self.run.pushed.push((held, instr.whole));
        }
        // Nothing needs to be done with it but to take it again.
        self.run.unused = None;
    }

    /// The number that was pushed last; told where there is none.
    pub(super) fn popped_number(&mut self, span: Span) -> Option<Expr> {
        let popped = self.run.pushed.pop();
        if popped.is_none() {
            self.refused(Cause::NothingPushed, span);
        }
        popped.map(|(expr, _)| expr)
    }

    /// What is left pushed where the body ends.
    pub(super) fn end_of_pushed(&mut self) {
        if let Some((_, span)) = self.run.pushed.pop() {
            self.refused(Cause::ValueLeftPushed, span);
        }
    }

    fn refused(&mut self, cause: Cause, span: Span) {
        let words = [cause.number().to_string().into(), cause.text().into()];
        self.tell(Code::Refused, span, words);
    }

    /// TABLE_LD, TABLE_ST.
    pub(super) fn table(&mut self, instr: &Instr, opcode: Opcode) {
        let span = instr.whole;
        let what = name(instr.op);
        let stores = opcode == Opcode::StoreTable;
        self.front.writes |= stores;
        let Some(table) = self.table_operands(instr, what) else {
            self.take(what, instr.span);
            return;
        };
        let expr = self.take(what, instr.span);
        let number = expr.and_then(|expr| self.as_number(expr, ACCUMULATOR, instr.span));
        let Some(number) = number else { return };
        if !stores {
            let place = self.front.builder.in_table(table, number, span);
            let expr = place.map(|place| Expr {
                kind: ExprKind::Read(Box::new(place)),
                base: Base::Dint,
                ty: crate::typed::TypeId::of(Base::Dint),
                at: span,
            });
            self.hold(expr);
            self.run.links = 0;
            return self.link();
        }
        let Some(subscript) = self.popped_number(span) else {
            return;
        };
        self.hold(Some(number));
        if self.needed() {
            self.settle_costly();
        }
        let Acc::Value(number) = self.run.acc.clone() else {
            return;
        };
        if let Some(place) = self.front.builder.in_table(table, subscript, span) {
            self.before(&Changes::Cells(&place, 1), true);
            let kind = StmtKind::Assign(place, number, Store::Narrow(Base::Dint));
            self.push(Made { kind, at: span });
        }
    }

    /// The first register of a table, and how many it has.
    fn table_operands(&mut self, instr: &Instr, what: &str) -> Option<(u8, u8)> {
        let [first, length, ..] = &instr.operands[..] else {
            let example = ("D1, 8", "D1, 8");
            let words = [what.into(), example.into()];
            self.tell(Code::OperandMissing, instr.span, words);
            return None;
        };
        self.only(instr, 2);
        let instance = Some(self.instance);
        let found = &mut *self.front.builder.found;
        let register = match self.front.names.place(first, instance, found) {
            Place::Number(Num::At(Address::Register(register))) => Some(register),
            Place::Unknown => return None,
            _ => None,
        };
        let Some(register) = register else {
            let text = self.spelled(first);
            let range = ("a register", "um registrador");
            self.tell(Code::BadValue, first.span, [text.into(), range.into()]);
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
            self.tell(Code::BadValue, length.span, [text.into(), range.into()]);
            return None;
        };
        Some((register, count))
    }
}

impl Front<'_, '_> {
    /// The registers of the text's tables, which stand in rows.
    pub(super) fn rows(&mut self) {
        let mut tables = Vec::new();
        for (index, unit) in self.units.iter().enumerate() {
            for stmt in &unit.body {
                if let Stmt::Instr(instr) = stmt
                    && matches!(instr.op, Op::Table(_))
                    && let [first, length, ..] = &instr.operands[..]
                    && let Some(register) = self.register(first, index)
                {
                    let count = length.number().and_then(|count| u8::try_from(count).ok());
                    let count = count.filter(|count| *count <= REGISTERS + 1 - register);
                    tables.extend(count.map(|count| (register, count)));
                }
            }
        }
        self.builder.rows(&tables);
    }

    fn register(&self, operand: &Operand, unit: usize) -> Option<u8> {
        let name = operand.name()?;
        let instance = self.names.instances.get(self.instances[unit]);
        let local = instance.and_then(|instance| instance.names.get(name));
        if let Some(place) = local.copied().or_else(|| self.names.shared(name)) {
            return match place {
                Place::Number(Num::At(Address::Register(register))) => Some(register),
                _ => None,
            };
        }
        match points::variable(name, self.names.dialect.maker(), self.names.board)? {
            (Address::Register(register), _) => Some(register),
            _ => None,
        }
    }
}
