//! TABLE_LD and TABLE_ST: registers in a row, of which a subscript chooses one.

use super::run::{Acc, Changes};
use super::walk::Walk;
use unoclp_core::isa::REGISTERS;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Base, Expr, ExprKind, Stmt, StmtKind, Store, TypeId};

/// So many registers stand in a row from this one on; none where the board has fewer.
pub(super) fn row(register: u8, count: Option<i64>) -> Option<(u8, u8)> {
    let count = count.and_then(|count| u8::try_from(count).ok())?;
    let most = (REGISTERS + 1).checked_sub(register)?;
    (1..=most).contains(&count).then_some((register, count))
}

impl Walk<'_, '_, '_> {
    /// Loads from a table or stores to it: the accumulator is the subscript, or the number whose subscript waits.
    pub(super) fn table(&mut self, table: (u8, u8), number: Expr, stores: bool, at: Span) {
        let (base, ty) = (Base::Dint, TypeId::of(Base::Dint));
        if !stores {
            let place = self.builder().in_table(table, number, at);
            let kind = place.map(|place| ExprKind::Read(Box::new(place)));
            let expr = kind.map(|kind| Expr { kind, base, ty, at });
            self.run.load(expr);
            return self.link();
        }
        let Some(subscript) = self.popped_number(at) else {
            return;
        };
        self.hold(Some(number));
        if self.needed() {
            self.settle_costly();
        }
        let Acc::Value(number) = self.run.acc.clone() else {
            return;
        };
        if let Some(place) = self.builder().in_table(table, subscript, at) {
            self.before(&Changes::Cells(&place, 1), true);
            let kind = StmtKind::Assign(place, number, Store::Narrow(base));
            self.push(Stmt { kind, at });
        }
    }

    /// The table that an instruction names by its first register and its length; told where it is none. `from` is where
    /// these stand.
    pub(super) fn table_of(
        &mut self,
        first: Option<u8>,
        count: Option<i64>,
        from: [Span; 2],
    ) -> Option<(u8, u8)> {
        let Some(register) = first else {
            let text = self.built().written(from[0]);
            let range = ("a register", "um registrador");
            self.tell(Code::BadValue, from[0], [text.into(), range.into()]);
            return None;
        };
        let table = row(register, count);
        if table.is_none() {
            let most = REGISTERS + 1 - register;
            let text = self.built().written(from[1]);
            let range = (
                format!("a number from 1 to {most}"),
                format!("um número de 1 a {most}"),
            );
            self.tell(Code::BadValue, from[1], [text.into(), range.into()]);
        }
        table
    }

    /// What is lacking is told.
    pub(super) fn no_table(&mut self, what: &str, at: Span) {
        let example = ("D1, 8", "D1, 8");
        self.tell(Code::OperandMissing, at, [what.into(), example.into()]);
    }
}
