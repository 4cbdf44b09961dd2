//! Names, and what is stored where: from the syntax tree to the typed tree.
//!
//! `slots` says what names stand for, `values` and `kinds` what expressions come to, `coils` what `aciona` does.

use super::ast::{Kind, Name, Program, Statement, StatementKind};
use super::checker::{Cells, Checker, Shown, Slot, Written};
use super::values::{Val, place};
use std::collections::HashMap;
use unoclp_core::Board;
use unoclp_text::diagnostics::{Code, Found, Span};
use unoclp_tree::build::{Builder, Letters};
use unoclp_tree::{Base, Expr, ExprKind, Stmt, StmtKind, Store, Tree, UnitKind, Value};

pub(super) fn check(
    text: &str,
    program: &Program,
    board: Board,
    found: &mut Found,
) -> Option<Tree> {
    let mut checker = Checker {
        builder: Builder::new(text, Letters::Apart, board, found),
        names: HashMap::new(),
        variables: Vec::new(),
        shown: Vec::new(),
        asked: 0,
        coils: HashMap::new(),
        resets: 0,
    };
    checker.builder.divides_by_zero = true;
    let name = program.name.as_ref();
    let title = name.map_or("clp", |name| name.text.trim_matches(['"', '\'']));
    let at = name.map_or(program.span, |name| name.span);
    let unit = checker.builder.unit(title, UnitKind::Program, at);
    let before = checker.builder.enter(&unit);
    checker.builder.may_do_nothing();
    checker.aliases(program);
    checker.kinds(&program.body);
    let (body, _) = checker.statements(&program.body);
    let unit = checker.builder.close(unit);
    checker.builder.back(before);
    checker.builder.body(unit, body);
    let symbols = checker.symbols();
    let mut tree = checker.builder.finish()?;
    tree.symbols = symbols;
    Some(tree)
}

impl Checker<'_, '_> {
    /// The names that `var` gives.
    fn aliases(&mut self, program: &Program) {
        for alias in &program.aliases {
            let known = self.shown.len();
            let slot = self.slot(&alias.place);
            if matches!(slot, Some(Slot::Point(_))) {
                // A point that has a name is shown by that.
                self.shown.truncate(known);
            }
            let text = alias.name.text.clone();
            if self.names.contains_key(&text) {
                let words = [text.into()];
                self.builder.tell(Code::StNameTwice, alias.name.span, words);
                continue;
            }
            self.names.insert(text.clone(), slot);
            if let Some(slot) = slot {
                self.shown.push(Shown {
                    name: text,
                    slot,
                    at: alias.name.span,
                });
            }
        }
    }

    /// The types that each variable is written with, before any variable is read.
    fn kinds(&mut self, statements: &[Statement]) {
        for statement in statements {
            match &statement.kind {
                StatementKind::Assign(name, kind, ..) => self.note(name, Written::of(*kind)),
                StatementKind::Bit(_, name) => self.note(name, Written::Bit),
                StatementKind::If(_, then, otherwise) => {
                    self.kinds(then);
                    self.kinds(otherwise);
                }
            }
        }
    }

    /// The place that a command changes; none, with a message, where it cannot.
    pub(super) fn target(&mut self, name: &Name) -> Option<Slot> {
        let slot = self.slot(name)?;
        if let Slot::Point(point) = slot
            && !point.is_written()
        {
            let words = [name.text.as_str().into()];
            self.builder.tell(Code::LceInput, name.span, words);
            return None;
        }
        Some(slot)
    }

    /// `V1 R:= e`
    pub(super) fn assign(
        &mut self,
        name: &Name,
        kind: Option<Kind>,
        sign: Span,
        value: Val,
        at: Span,
        all: &mut Vec<Stmt>,
    ) {
        let sign = self.builder.written(sign);
        let taken = self.taken(value, kind.unwrap_or(Kind::D), &sign);
        let Some(slot) = self.target(name) else {
            return;
        };
        if matches!(taken.kind, ExprKind::Wrong) {
            return;
        }
        let value = match kind {
            Some(Kind::R) => Val::Real(taken),
            _ => Val::Whole(taken),
        };
        self.store(slot, value, name.span, at, all);
    }

    /// Stores a value with its own type.
    pub(super) fn store(
        &mut self,
        slot: Slot,
        value: Val,
        name: Span,
        at: Span,
        all: &mut Vec<Stmt>,
    ) {
        let cells = match slot {
            Slot::Point(point) => Cells::One(self.builder.point(point), Base::Bool),
            Slot::Variable(number) => self.cells(number),
        };
        let mut put = |cell: u32, expr: Expr| {
            let store = Store::Narrow(expr.base);
            let kind = StmtKind::Assign(place(cell, name), expr, store);
            all.push(Stmt { kind, at });
        };
        let (flag, real, whole) = match cells {
            Cells::One(cell, base) => {
                let expr = match base {
                    Base::Bool => self.as_bit(value),
                    Base::Real => self.taken(value, Kind::R, ""),
                    _ => self.taken(value, Kind::D, ""),
                };
                put(cell, expr);
                return;
            }
            Cells::Two { flag, real, whole } => (flag, real, whole),
        };
        let is_real = matches!(value, Val::Real(_));
        let truth = self
            .builder
            .literal(Base::Bool, Value::truth(is_real), name);
        if is_real {
            let expr = self.taken(value, Kind::R, "");
            put(real, expr);
        } else {
            let expr = self.taken(value, Kind::D, "");
            put(whole, expr);
            // What the REAL held is never taken as D again, which could not be done with all of its values.
            let zero = self.builder.literal(Base::Real, Value::Real(0.0), name);
            put(real, zero);
        }
        put(flag, truth);
    }
}
