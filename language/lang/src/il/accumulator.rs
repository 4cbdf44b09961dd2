//! What the accumulator holds, as an expression of what it was made from, and what is put aside of it.
//!
//! An expression is read again at each use, so whatever may change what it reads has to find it put aside: in a
//! variable that is new at each call.

use super::walk::{Acc, Walk};
use crate::diagnostics::{Code, Span};
use crate::typed::build::{Section, Target, Traits};
use crate::typed::{Base, Expr, ExprKind, Place, Root, Stmt, StmtKind, TypeId};

/// Operations in one expression, before a part of it is put aside.
const MOST_LINKS: u32 = 40;

/// What a statement may change.
pub(super) enum Changes<'p> {
    /// So many cells from this one on.
    Cells(&'p Place, u32),
    Anything,
}

impl Walk<'_, '_, '_> {
    /// The accumulator, for an instruction that uses it; told where it holds nothing.
    pub(super) fn take(&mut self, what: &str, span: Span) -> Option<Expr> {
        self.unused = None;
        match std::mem::replace(&mut self.acc, Acc::Wrong) {
            Acc::Value(expr) => Some(expr),
            Acc::Wrong => None,
            Acc::Empty => {
                self.tell(Code::NothingLoaded, span, [what.into()]);
                None
            }
        }
    }

    /// The accumulator as a bit.
    pub(super) fn take_bit(&mut self, what: &str, span: Span) -> Option<Expr> {
        let expr = self.take(what, span)?;
        self.as_bit(expr, super::operands::ACCUMULATOR, span)
    }

    /// Puts a new value into the accumulator.
    pub(super) fn hold(&mut self, expr: Option<Expr>) {
        self.acc = match expr {
            Some(expr) if !matches!(expr.kind, ExprKind::Wrong) => Acc::Value(expr),
            _ => Acc::Wrong,
        };
    }

    /// One operation more in the accumulator's expression.
    pub(super) fn link(&mut self) {
        self.links += 1;
        if self.links >= MOST_LINKS {
            self.settle();
        }
    }

    /// A variable of the compiler's own.
    pub(super) fn own(&mut self, base: Base, at: Span) -> Option<Target> {
        self.own += 1;
        let name = format!("#{}", self.own);
        let traits = Traits {
            unseen: true,
            ..Traits::default()
        };
        let ty = TypeId::of(base);
        let builder = &mut self.front.builder;
        builder.declare(&name, at, ty, Section::Temp, traits)?;
        builder.name(&name, at)
    }

    /// Stores a value in a variable of its own, and gives what reads it.
    pub(super) fn aside(&mut self, expr: Expr) -> Expr {
        if matches!(expr.kind, ExprKind::Constant(_) | ExprKind::Wrong) {
            return expr;
        }
        let at = expr.at;
        let Some(target) = self.own(expr.base, at) else {
            return expr;
        };
        let builder = &mut self.front.builder;
        let statement = builder.assign(target.clone(), expr, at);
        statement.into_iter().for_each(|one| self.push(one));
        self.front.builder.read(Some(target), at)
    }

    /// Puts the accumulator aside.
    pub(super) fn settle(&mut self) {
        if let Acc::Value(expr) = self.acc.clone() {
            let held = self.aside(expr);
            self.hold(Some(held));
        }
        self.links = 0;
    }

    /// Puts the accumulator aside where computing it twice would cost more than keeping it.
    pub(super) fn settle_costly(&mut self) {
        if self.links > 0 {
            self.settle();
        }
    }

    /// Before something changes: whatever is still needed and reads that is put aside.
    pub(super) fn before(&mut self, changes: &Changes, needed: bool) {
        for at in 0..self.frames.len() {
            let acc = self.frames.get(at).map(|frame| frame.acc.clone());
            if let Some(expr) = self.changed(acc, changes) {
                let held = Acc::Value(self.aside(expr));
                if let Some(frame) = self.frames.get_mut(at) {
                    frame.acc = held;
                }
            }
        }
        for at in 0..self.kept.len() {
            let acc = self.kept.get(at).map(|(acc, _)| acc.clone());
            if let Some(expr) = self.changed(acc, changes) {
                let held = Acc::Value(self.aside(expr));
                if let Some((acc, _)) = self.kept.get_mut(at) {
                    *acc = held;
                }
            }
        }
        self.before_block(changes);
        if needed && self.changed(Some(self.acc.clone()), changes).is_some() {
            self.settle();
        }
    }

    /// What a result reads that changes.
    fn changed(&self, acc: Option<Acc>, changes: &Changes) -> Option<Expr> {
        match acc {
            Some(Acc::Value(expr)) if self.may_read(&expr, changes) => Some(expr),
            _ => None,
        }
    }

    /// A statement that changes something.
    pub(super) fn does(&mut self, statement: Stmt, needed: bool) {
        match &statement.kind {
            StmtKind::Assign(place, ..) => self.before(&Changes::Cells(place, 1), needed),
            _ => self.before(&Changes::Anything, needed),
        }
        self.push(statement);
    }

    /// Statements that are done where the condition holds.
    pub(super) fn conditional(&mut self, condition: Expr, body: Vec<Stmt>, at: Span, needed: bool) {
        match body.as_slice() {
            [
                Stmt {
                    kind: StmtKind::Assign(place, ..),
                    ..
                },
            ] => {
                let place = place.clone();
                self.before(&Changes::Cells(&place, 1), needed);
            }
            _ => self.before(&Changes::Anything, needed),
        }
        let kind = StmtKind::If(vec![(condition, body)], Vec::new());
        self.push(Stmt { kind, at });
    }

    /// Whether an expression may read what changes. Inputs stay what they are throughout a scan.
    pub(super) fn may_read(&self, expr: &Expr, changes: &Changes) -> bool {
        let mut any = false;
        let mut rest = vec![expr];
        while let Some(expr) = rest.pop() {
            match &expr.kind {
                ExprKind::Constant(_) | ExprKind::Wrong => {}
                ExprKind::Read(place) => {
                    any |= match changes {
                        Changes::Anything => !self.is_steady(place),
                        Changes::Cells(to, cells) => may_meet(place, to, *cells),
                    };
                }
                ExprKind::Convert(_, a) | ExprKind::Unary(_, a) => rest.push(a),
                ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => rest.extend([&**a, &**b]),
                // Instruction List makes none of the others.
                _ => any = true,
            }
        }
        any
    }

    /// Whether this is an input, or what nothing but this body has.
    fn is_steady(&self, place: &Place) -> bool {
        let mut points = self.front.builder.tree.points.iter();
        place.root == Root::Local
            || place.root == Root::Static
                && points.any(|(cell, point)| *cell == place.offset && !point.is_written())
    }
}

fn may_meet(place: &Place, to: &Place, cells: u32) -> bool {
    match place.root == to.root {
        true => (to.offset..to.offset.saturating_add(cells)).contains(&place.offset),
        // What is lent may be any cell but those of this call.
        false => place.root != Root::Local && to.root != Root::Local,
    }
}
