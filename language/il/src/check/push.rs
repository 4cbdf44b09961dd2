//! PUSH, and what works on the number that it has pushed; tables, which need it.

use super::bits::name;
use super::front::Front;
use super::said::ACCUMULATOR;
use super::tables::row;
use super::walk::Walk;
use crate::ast::{Instr, Operand, Stmt};
use crate::names::Place;
use crate::operators::Op;
use crate::tree::Num;
use unoclp_core::isa::Opcode;
use unoclp_point::Address;
use unoclp_text::points;

impl Walk<'_, '_, '_> {
    /// PUSH
    pub(super) fn push_line(&mut self, instr: &Instr) {
        let expr = self.take("PUSH", instr.span);
        let number = expr.and_then(|expr| match self.is_plain(&expr) {
            true => self.as_number(expr, ACCUMULATOR, instr.span),
            false => Some(expr),
        });
        if let Some(number) = number {
            self.push_number(number, instr.whole);
        }
    }

    /// TABLE_LD, TABLE_ST.
    pub(super) fn table_line(&mut self, instr: &Instr, opcode: Opcode) {
        let what = name(instr.op);
        let stores = opcode == Opcode::StoreTable;
        self.front.writes |= stores;
        let table = self.table_operands(instr, what);
        let expr = self.take(what, instr.span);
        let number = expr.and_then(|expr| self.as_number(expr, ACCUMULATOR, instr.span));
        if let (Some(table), Some(number)) = (table, number) {
            self.table(table, number, stores, instr.whole);
        }
    }

    /// The first register of a table, and how many it has.
    fn table_operands(&mut self, instr: &Instr, what: &str) -> Option<(u8, u8)> {
        let [first, length, ..] = &instr.operands[..] else {
            self.no_table(what, instr.span);
            return None;
        };
        self.only(instr, 2);
        let instance = Some(self.instance);
        let found = &mut *self.front.c.builder.found;
        let register = match self.front.names.place(first, instance, found) {
            Place::Number(Num::At(Address::Register(register))) => Some(register),
            Place::Unknown => return None,
            _ => None,
        };
        let count = length.number().map(i64::from);
        self.table_of(register, count, [first.span, length.span])
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
                    tables.extend(row(register, length.number().map(i64::from)));
                }
            }
        }
        self.c.builder.rows(&tables);
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
