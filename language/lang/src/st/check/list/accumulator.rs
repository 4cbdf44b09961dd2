//! What the accumulator holds, as an expression of what it was made from, and what is put aside of it.
//!
//! An expression is read again at each use, so whatever may change what it reads has to find it put aside: in a
//! variable that is new at each call.

use super::walk::{Acc, Walk};
use crate::diagnostics::{Code, Span};
use crate::typed::build::{Section, Target, Traits};
use crate::typed::{Expr, ExprKind, Place, Root, Stmt, StmtKind, TypeId};

/// What a statement may change.
pub(super) enum Changes<'p> {
    /// These cells alone.
    Cells(&'p Place, u32),
    Anything,
}

impl Walk<'_, '_, '_, '_> {
    /// What the accumulator holds; told where it holds nothing.
    pub(super) fn take(&mut self, word: &str, at: Span) -> Option<Expr> {
        self.unused = None;
        match &self.acc {
            Acc::Value(expr) => Some(expr.clone()),
            Acc::Wrong => None,
            Acc::Empty => {
                self.tell(Code::NothingLoaded, at, [word.into()]);
                self.acc = Acc::Wrong;
                None
            }
            Acc::Whole(target) => {
                // It tells that it has no value as a whole.
                let target = target.clone();
                self.c.builder.read(Some(target), at);
                self.acc = Acc::Wrong;
                None
            }
        }
    }

    /// Puts a new value into the accumulator.
    pub(super) fn hold(&mut self, expr: Expr, links: u32) {
        self.links = links;
        self.acc = match expr.kind {
            ExprKind::Wrong => Acc::Wrong,
            _ => Acc::Value(expr),
        };
    }

    /// A variable of the compiler's own.
    pub(super) fn own(&mut self, ty: TypeId, section: Section, at: Span) -> Option<Target> {
        self.own += 1;
        let name = format!("#{}", self.own);
        let traits = Traits {
            unseen: true,
            ..Traits::default()
        };
        self.c.builder.declare(&name, at, ty, section, traits)?;
        self.c.builder.name(&name, at)
    }

    /// Stores a value in a variable of its own, and gives what reads it.
    fn aside(&mut self, expr: Expr) -> Expr {
        let expr = self.c.builder.settled(expr);
        let (at, ty) = (expr.at, self.plain(&expr));
        let Some(target) = self.own(ty, Section::Temp, at) else {
            return expr;
        };
        let statement = self.c.builder.assign(target.clone(), expr, at);
        statement.into_iter().for_each(|one| self.push(one));
        self.c.builder.read(Some(target), at)
    }

    /// The type of a variable that holds this: of a subrange its base, which every value of its arithmetic fits.
    pub(super) fn plain(&self, expr: &Expr) -> TypeId {
        match self.c.builder.tree.types.kind(expr.ty) {
            crate::typed::Kind::Enum(_) => expr.ty,
            _ => TypeId::of(expr.base),
        }
    }

    /// Before something changes: whatever is still needed and reads that is put aside.
    pub(super) fn before(&mut self, changes: &Changes, needed: bool) {
        let put = |acc: &Acc| matches!(acc, Acc::Value(expr) if may_read(expr, changes));
        for at in 0..self.frames.len() {
            if put(&self.frames[at].acc)
                && let Acc::Value(expr) = self.frames[at].acc.clone()
            {
                self.frames[at].acc = Acc::Value(self.aside(expr));
            }
        }
        for at in 0..self.kept.len() {
            if put(&self.kept[at])
                && let Acc::Value(expr) = self.kept[at].clone()
            {
                self.kept[at] = Acc::Value(self.aside(expr));
            }
        }
        if needed && put(&self.acc) {
            self.settle();
        }
    }

    /// Puts the accumulator aside.
    pub(super) fn settle(&mut self) {
        if let Acc::Value(expr) = self.acc.clone()
            && !matches!(expr.kind, ExprKind::Constant(_))
        {
            let held = self.aside(expr);
            self.hold(held, 0);
        }
    }

    /// Puts the accumulator aside where computing it twice would cost more than keeping it.
    pub(super) fn settle_costly(&mut self) {
        if self.links > 0 {
            self.settle();
        }
    }

    /// The accumulator as it goes into an operation, whose result it is to hold.
    pub(super) fn linked(&mut self, word: &str, at: Span) -> Option<Expr> {
        if self.links >= super::MOST_LINKS {
            self.settle();
        }
        match &self.acc {
            Acc::Value(_) => {}
            _ => return self.take(word, at),
        }
        self.unused = None;
        match std::mem::replace(&mut self.acc, Acc::Wrong) {
            Acc::Value(expr) => Some(expr),
            _ => None,
        }
    }

    /// A statement that stores in these cells.
    pub(super) fn store(&mut self, statement: Stmt, needed: bool) {
        match &statement.kind {
            StmtKind::Assign(place, ..) => self.before(&Changes::Cells(place, 1), needed),
            StmtKind::Copy(place, _, cells) => self.before(&Changes::Cells(place, *cells), needed),
            _ => self.before(&Changes::Anything, needed),
        }
        self.push(statement);
    }
}

/// Whether an expression may read what changes.
fn may_read(expr: &Expr, changes: &Changes) -> bool {
    let mut any = false;
    let mut rest = vec![expr];
    while let Some(expr) = rest.pop() {
        match &expr.kind {
            ExprKind::Constant(_) | ExprKind::Now | ExprKind::Wrong => {}
            ExprKind::Read(place) => {
                any |= match changes {
                    Changes::Anything => true,
                    Changes::Cells(to, cells) => may_meet(place, to, *cells),
                };
                rest.extend(place.indices.iter().map(|index| &index.subscript));
            }
            ExprKind::Convert(_, a) | ExprKind::Unary(_, a) => rest.push(a),
            ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => rest.extend([&**a, &**b]),
            ExprKind::Ordered(_, all) | ExprKind::Extra(_, all) => rest.extend(all),
            ExprKind::Select(all) => rest.extend(all.iter()),
            ExprKind::Mux(k, all) => {
                rest.push(k);
                rest.extend(all);
            }
            ExprKind::Call(_) => any = true,
        }
    }
    any
}

fn may_meet(place: &Place, to: &Place, cells: u32) -> bool {
    if place.root != to.root {
        // What is lent may be any cell but those of this call.
        return place.root != Root::Local && to.root != Root::Local;
    }
    if !place.indices.is_empty() || !to.indices.is_empty() {
        return true;
    }
    (to.offset..to.offset.saturating_add(cells)).contains(&place.offset)
}
