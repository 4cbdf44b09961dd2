//! `aciona`, `liga`, `desliga` and `se`: what is done with bits, and under which conditions.
//!
//! A coil becomes 1 where all `se` around it hold, and 0 where one does not, at its place in the text: so each half
//! of a `se` also turns off the coils of the other half.

use super::ast::{Bit, Name, Node, Statement, StatementKind};
use super::checker::{Checker, Slot};
use super::values::Val;
use std::collections::HashSet;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::{Base, Stmt, StmtKind, Value};

/// No program turns off more coils than this.
const MOST_RESETS: usize = 200_000;

/// A coil and its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coil {
    slot: Slot,
    name: Span,
    at: Span,
}

impl Checker<'_, '_> {
    /// Statements, and the coils among them, each once.
    pub(super) fn statements(&mut self, statements: &[Statement]) -> (Vec<Stmt>, Vec<Coil>) {
        let (mut all, mut coils) = (Vec::new(), Vec::new());
        for statement in statements {
            self.statement(statement, &mut all, &mut coils);
        }
        let mut seen = HashSet::new();
        coils.retain(|coil: &Coil| seen.insert(coil.slot));
        (all, coils)
    }

    fn statement(&mut self, statement: &Statement, all: &mut Vec<Stmt>, coils: &mut Vec<Coil>) {
        let at = statement.span;
        match &statement.kind {
            StatementKind::Assign(name, kind, sign, node) => {
                let value = self.value(node);
                self.assign(name, *kind, *sign, value, at, all);
            }
            StatementKind::Bit(bit, name) => {
                if let Some(slot) = self.target(name) {
                    let on = self.truth(*bit != Bit::Off, name.span);
                    self.store(slot, on, name.span, at, all);
                    if *bit == Bit::Coil {
                        coils.push(self.coil(slot, name, at));
                    }
                }
            }
            StatementKind::If(condition, then, otherwise) => {
                self.condition(condition, then, otherwise, at, all, coils);
            }
        }
    }

    fn truth(&mut self, truth: bool, at: Span) -> Val {
        Val::Bit(self.builder.literal(Base::Bool, Value::truth(truth), at))
    }

    fn coil(&mut self, slot: Slot, name: &Name, at: Span) -> Coil {
        if self.coils.insert(slot, name.span).is_some() {
            let words = [name.text.as_str().into()];
            self.builder.tell(Code::LceTwoCoils, name.span, words);
        }
        let name = name.span;
        Coil { slot, name, at }
    }

    fn condition(
        &mut self,
        condition: &Node,
        then: &[Statement],
        otherwise: &[Statement],
        at: Span,
        all: &mut Vec<Stmt>,
        coils: &mut Vec<Coil>,
    ) {
        let value = self.value(condition);
        let bit = self.as_bit(value);
        if let ([one], []) = (then, otherwise)
            && let StatementKind::Bit(Bit::Coil, name) = &one.kind
        {
            // One coil alone is what its condition is.
            if let Some(slot) = self.target(name) {
                self.store(slot, Val::Bit(bit), name.span, one.span, all);
                coils.push(self.coil(slot, name, one.span));
            }
            return;
        }
        let (mut then, within) = self.statements(then);
        let (rest, without) = self.statements(otherwise);
        self.turn_off(&without, at, &mut then);
        let mut otherwise = Vec::new();
        self.turn_off(&within, at, &mut otherwise);
        otherwise.extend(rest);
        coils.extend(within);
        coils.extend(without);
        let kind = StmtKind::If(vec![(bit, then)], otherwise);
        all.push(Stmt { kind, at });
    }

    /// Turns off the coils of what is not reached.
    fn turn_off(&mut self, coils: &[Coil], at: Span, all: &mut Vec<Stmt>) {
        if self.resets > MOST_RESETS {
            // Told.
            return;
        }
        self.resets += coils.len();
        if self.resets > MOST_RESETS {
            self.builder.tell(Code::StTooDeep, at, []);
            return;
        }
        for coil in coils {
            let off = self.truth(false, coil.name);
            self.store(coil.slot, off, coil.name, coil.at, all);
        }
    }
}
