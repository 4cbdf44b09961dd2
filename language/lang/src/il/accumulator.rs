//! What the accumulator holds, as an expression of what it was made from, and what is put aside of it.
//!
//! An expression is read again at each use, so whatever may change what it reads has to find it put aside: in a
//! variable that is new at each call.

use super::walk::{Acc, Walk};
use crate::diagnostics::{Code, Span};
use crate::typed::build::{Section, Target, Traits};
use crate::typed::{Base, Expr, ExprKind, Index, Place, Root, Stmt, StmtKind, TypeId};

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
        self.undecided();
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
        self.as_bit(expr, super::said::ACCUMULATOR, span)
    }

    /// Puts the condition of the IF that was made last aside, where it is used once more.
    pub(super) fn undecided(&mut self) {
        let Some(state) = self.decided.take() else {
            return;
        };
        let Some(Stmt {
            kind: StmtKind::If(arms, otherwise),
            ..
        }) = self.made.last().and_then(|made| made.last())
        else {
            return;
        };
        let Some((condition, _)) = arms.first() else {
            return;
        };
        let condition = condition.clone();
        let at = condition.at;
        // One contact that nothing of it changes is read again.
        let is_leaf = matches!(condition.kind, ExprKind::Constant(_) | ExprKind::Read(_));
        let changed = arms.iter().flat_map(|(_, body)| body).chain(otherwise);
        let is_kept = is_leaf
            && changed.into_iter().all(|one| match &one.kind {
                StmtKind::Assign(place, ..) => {
                    !self.may_read(&condition, &Changes::Cells(place, 1))
                }
                _ => false,
            });
        if is_kept {
            self.links = 0;
            let held = match state {
                true => condition,
                false => self.front.builder.not(condition, at),
            };
            return self.hold(Some(held));
        }
        let Some(target) = self.own(Base::Bool, at) else {
            return;
        };
        let Some(put) = self.assigned(&target, condition, at) else {
            return;
        };
        let held = self.read(target, at);
        if let Some(made) = self.made.last_mut() {
            if let Some(Stmt {
                kind: StmtKind::If(arms, _),
                ..
            }) = made.last_mut()
                && let Some((condition, _)) = arms.first_mut()
            {
                *condition = held.clone();
            }
            let before = made.len().saturating_sub(1);
            made.insert(before, put);
            if self.made.len() == 1 {
                self.labels.insert(before);
            }
        }
        self.links = 0;
        let held = match state {
            true => held,
            false => self.front.builder.not(held, at),
        };
        self.hold(Some(held));
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
        self.undecided();
        self.before_others(changes);
        if needed && self.changed(Some(self.acc.clone()), changes).is_some() {
            self.settle();
        }
    }

    /// The same of what waits, but for the accumulator.
    pub(super) fn before_others(&mut self, changes: &Changes) {
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
        for at in 0..self.pushed_numbers.len() {
            let held = self.pushed_numbers.get(at).cloned();
            if let Some((expr, span)) = held
                && self.may_read(&expr, changes)
            {
                let held = self.aside(expr);
                if let Some(pushed) = self.pushed_numbers.get_mut(at) {
                    *pushed = (held, span);
                }
            }
        }
        self.before_block(changes);
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
            StmtKind::Order(_, block, place) => {
                self.before(&Changes::Cells(place, block.cells()), needed);
            }
            _ => self.before(&Changes::Anything, needed),
        }
        self.push(statement);
    }

    /// Whether an expression may read what changes. Inputs stay what they are throughout a scan.
    pub(super) fn may_read(&self, expr: &Expr, changes: &Changes) -> bool {
        let mut any = false;
        let mut rest = vec![expr];
        while let Some(expr) = rest.pop() {
            match &expr.kind {
                ExprKind::Constant(_) | ExprKind::Wrong => {}
                ExprKind::Read(place) => {
                    rest.extend(place.indices.iter().map(|index| &index.subscript));
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
        true => {
            let reach = |index: &Index| index.count.saturating_sub(1).saturating_mul(index.stride);
            let last = place
                .indices
                .iter()
                .map(reach)
                .fold(place.offset, u32::saturating_add);
            to.offset <= last && place.offset < to.offset.saturating_add(cells)
        }
        // What is lent may be any cell but those of this call.
        false => place.root != Root::Local && to.root != Root::Local,
    }
}
