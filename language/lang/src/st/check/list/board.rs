//! The board's own words: CODE, PUSH and POP, tables.

use super::super::super::ast::{Arg, Instruction, Line, NodeKind, Path};
use super::super::Checker;
use super::walk::Walk;
use crate::diagnostics::Code;
use crate::list::{Accumulator, Machine, Stack, Tables, Verbatim, row};
use crate::operators::Op;
use crate::typed::{Base, Expr, ExprKind, TypeId};
use unoclp_core::isa::Opcode;
use unoclp_point::{Address, Maker, read};

impl Walk<'_, '_, '_, '_> {
    /// CODE
    pub(super) fn code(&mut self, one: &Instruction) {
        let mut codes = Vec::new();
        for arg in &one.operands {
            let (at, expr) = (arg.node.span, self.c.expr(&arg.node, None));
            let code = whole(&expr).and_then(|code| i32::try_from(code).ok());
            match (code, &expr.kind) {
                (Some(code), _) => codes.push((code, at)),
                (None, ExprKind::Wrong) => {}
                (None, _) => {
                    let written = self.c.builder.written(at);
                    let range = ("a numeric code", "um código numérico");
                    self.tell(Code::BadValue, at, [written.into(), range.into()]);
                }
            }
        }
        self.c.builder.may_do_nothing();
        self.codes(codes, one.span);
    }

    /// Whether an operand is what was pushed last: `SUB POP`.
    pub(super) fn is_popped(&self, one: &Instruction) -> bool {
        let numbers = matches!(
            one.spelling.map(|spelling| spelling.op),
            Some(Op::Number(_) | Op::Compare(_))
        );
        let pop = |path: &Path| path.parts.is_empty() && path.name.text.eq_ignore_ascii_case("POP");
        match one.operands.as_slice() {
            [arg] if numbers && self.c.builder.find("POP").is_none() => {
                matches!(&arg.node.kind, NodeKind::Path(path) if pop(path))
            }
            _ => false,
        }
    }

    /// PUSH
    pub(super) fn push_line(&mut self, one: &Instruction) {
        if let Some(number) = self.take(&one.word.text, one.word.span) {
            self.push_number(number, one.span);
        }
    }

    /// TABLE_LD, TABLE_ST
    pub(super) fn table_line(&mut self, one: &Instruction, opcode: Opcode) {
        let table = self.table_operands(one);
        let expr = self.take(&one.word.text, one.word.span);
        let number = expr.map(|expr| self.c.builder.coerce(expr, TypeId::of(Base::Dint)));
        let number = number.filter(|number| !matches!(number.kind, ExprKind::Wrong));
        if opcode == Opcode::StoreTable {
            self.c.builder.may_do_nothing();
        }
        if let (Some(table), Some(number)) = (table, number) {
            self.table(table, number, opcode == Opcode::StoreTable, one.span);
        }
    }

    fn table_operands(&mut self, one: &Instruction) -> Option<(u8, u8)> {
        let [first, length] = one.operands.as_slice() else {
            self.no_table(&one.word.text, one.word.span);
            return None;
        };
        let register = self.c.register(first);
        let count = self.c.expr(&length.node, None);
        if matches!(count.kind, ExprKind::Wrong) {
            return None;
        }
        let from = [first.node.span, length.node.span];
        self.table_of(register, whole(&count), from)
    }
}

impl Checker<'_, '_, '_> {
    /// The registers of the text's tables, which stand in rows.
    pub(in super::super) fn rows(&mut self, lines: &[Line]) {
        let mut tables = Vec::new();
        for line in lines {
            if let Line::Does(one) = line
                && matches!(one.spelling.map(|spelling| spelling.op), Some(Op::Table(_)))
                && let [first, length] = one.operands.as_slice()
                && let Some(register) = self.register(first)
                && let NodeKind::Literal(_, count) = &length.node.kind
            {
                tables.extend(row(register, i64::try_from(count.int()).ok()));
            }
        }
        self.builder.rows(&tables);
    }

    /// The register of the board that this names.
    fn register(&self, arg: &Arg) -> Option<u8> {
        let NodeKind::Path(path) = &arg.node.kind else {
            return None;
        };
        let key = path.name.text.to_uppercase();
        let plain = path.parts.is_empty() && self.builder.find(&key).is_none();
        let written = read(&key, Maker::Iec).filter(|_| plain)?;
        match written.address? {
            Address::Register(register) => Some(register),
            _ => None,
        }
    }
}

/// The number that stands in the text.
fn whole(expr: &Expr) -> Option<i64> {
    match &expr.kind {
        ExprKind::Constant(value) if expr.base.is_int() || expr.base == Base::AnyInt => {
            i64::try_from(value.int()).ok()
        }
        _ => None,
    }
}
