//! What the accumulator holds, as an expression of what it was made from, and what is put aside of it.
//!
//! An expression is read again at each use, so whatever may change what it reads has to find it put aside: in a
//! variable that is new at each call.

use super::run::{Acc, Changes, Run};
use super::walk::Walk;
use unoclp_text::diagnostics::{Code, Span};
use unoclp_tree::build::{Argument, Given, Section, Target, Traits};
use unoclp_tree::{Expr, ExprKind, Index, Kind, Place, Root, Stmt, StmtKind, TypeId};

/// Operations in one expression, before a part of it is put aside.
const MOST_LINKS: u32 = 40;

impl Walk<'_, '_, '_> {
    /// The accumulator, for an instruction that uses it; told where it holds nothing.
    pub(super) fn take(&mut self, what: &str, at: Span) -> Option<Expr> {
        self.undecided();
        let run = &mut self.run;
        run.unused = None;
        match std::mem::replace(&mut run.acc, Acc::Wrong) {
            Acc::Value(expr) => Some(expr),
            Acc::Wrong => None,
            Acc::Empty => {
                self.tell(Code::NothingLoaded, at, [what.into()]);
                None
            }
            Acc::Whole(target) => {
                // It tells that it has no value as a whole.
                self.builder().read(Some(target), at);
                None
            }
        }
    }

    /// The same of an accumulator that stays what it is.
    pub(super) fn peek(&mut self, what: &str, at: Span) -> Option<Expr> {
        self.undecided();
        let acc = self.run.acc.clone();
        let expr = self.take(what, at)?;
        self.run.acc = acc;
        Some(expr)
    }

    /// Puts a new value into the accumulator.
    pub(super) fn hold(&mut self, expr: Option<Expr>) {
        self.run.hold(expr);
    }

    /// One operation more in the accumulator's expression.
    pub(super) fn link(&mut self) {
        self.run.links += 1;
        if self.run.links >= MOST_LINKS {
            self.settle();
        }
    }

    /// Adds a statement that changes nothing which the accumulator reads.
    pub(super) fn push(&mut self, statement: Stmt) {
        self.undecided();
        if let Some(made) = self.run.made.last_mut() {
            made.push(statement);
        }
    }

    pub(super) fn warn_unused(&mut self) {
        if let Some(span) = self.run.unused.take() {
            self.tell(Code::ResultUnused, span, []);
        }
    }

    /// Whether the accumulator is used after the line that is run.
    pub(super) fn needed(&self) -> bool {
        self.run.needed()
    }

    /// A variable of the compiler's own.
    pub(super) fn own(&mut self, ty: TypeId, at: Span) -> Option<Target> {
        self.run.own += 1;
        let name = format!("#{}", self.run.own);
        let traits = Traits {
            unseen: true,
            ..Traits::default()
        };
        let builder = self.builder();
        builder.declare(&name, at, ty, Section::Temp, traits)?;
        builder.name(&name, at)
    }

    /// The type of a variable that holds this: of a subrange its base, which every value of its arithmetic fits.
    pub(super) fn plain(&self, expr: &Expr) -> TypeId {
        match self.built().tree.types.kind(expr.ty) {
            Kind::Enum(_) => expr.ty,
            _ => TypeId::of(expr.base),
        }
    }

    /// Stores a value in a variable of its own, and gives what reads it.
    pub(super) fn aside(&mut self, expr: Expr) -> Expr {
        if matches!(expr.kind, ExprKind::Constant(_) | ExprKind::Wrong) {
            return expr;
        }
        let expr = self.builder().settled(expr);
        let (at, ty) = (expr.at, self.plain(&expr));
        let Some(target) = self.own(ty, at) else {
            return expr;
        };
        let statement = self.builder().assign(target.clone(), expr, at);
        statement.into_iter().for_each(|one| self.push(one));
        self.builder().read(Some(target), at)
    }

    /// Puts the accumulator aside.
    pub(super) fn settle(&mut self) {
        if let Acc::Value(expr) = self.run.acc.clone() {
            let held = self.aside(expr);
            self.hold(Some(held));
        }
        self.run.links = 0;
    }

    /// Puts the accumulator aside where computing it twice would cost more than keeping it.
    pub(super) fn settle_costly(&mut self) {
        if self.run.links > 0 {
            self.settle();
        }
    }

    /// Puts the condition of the IF that was made last aside, where it is used once more.
    pub(super) fn undecided(&mut self) {
        let Some(state) = self.run.decided.take() else {
            return;
        };
        let Some(Stmt {
            kind: StmtKind::If(arms, otherwise),
            ..
        }) = self.run.made.last().and_then(|made| made.last())
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
        let held = match is_kept {
            true => condition,
            false => match self.condition_aside(condition, at) {
                Some(held) => held,
                None => return,
            },
        };
        let held = match state {
            true => held,
            false => self.builder().not(held, at),
        };
        self.run.load(Some(held));
    }

    /// Puts the condition of the IF that was made last into a variable before it.
    fn condition_aside(&mut self, condition: Expr, at: Span) -> Option<Expr> {
        let target = self.own(TypeId::BOOL, at)?;
        let put = self.assigned(&target, condition, at)?;
        let held = self.builder().read(Some(target), at);
        let run = &mut self.run;
        let of_body = run.made.len() == 1;
        let made = run.made.last_mut()?;
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
        if of_body {
            run.labels.insert(before);
        }
        Some(held)
    }

    /// Before something changes: whatever is still needed and reads that is put aside.
    pub(super) fn before(&mut self, changes: &Changes, needed: bool) {
        self.undecided();
        self.before_others(changes);
        if needed && self.reads_changed(Some(&self.run.acc), changes) {
            self.settle();
        }
    }

    /// The same of what waits, but for the accumulator.
    pub(super) fn before_others(&mut self, changes: &Changes) {
        for at in 0..self.run.frames.len() {
            let acc = |run: &Run| run.frames.get(at).map(|frame| frame.acc.clone());
            if let Some(held) = self.changed(acc(&self.run), changes)
                && let Some(frame) = self.run.frames.get_mut(at)
            {
                frame.acc = held;
            }
        }
        for at in 0..self.run.kept.len() {
            let acc = |run: &Run| run.kept.get(at).map(|(acc, _)| acc.clone());
            if let Some(held) = self.changed(acc(&self.run), changes)
                && let Some((acc, _)) = self.run.kept.get_mut(at)
            {
                *acc = held;
            }
        }
        for at in 0..self.run.pushed.len() {
            let held = self.run.pushed.get(at).cloned();
            if let Some((expr, _)) = held
                && self.may_read(&expr, changes)
            {
                let held = self.aside(expr);
                if let Some((pushed, _)) = self.run.pushed.get_mut(at) {
                    *pushed = held;
                }
            }
        }
        self.before_block(changes);
    }

    fn reads_changed(&self, acc: Option<&Acc>, changes: &Changes) -> bool {
        matches!(acc, Some(Acc::Value(expr)) if self.may_read(expr, changes))
    }

    /// A result that reads what changes, put aside.
    fn changed(&mut self, acc: Option<Acc>, changes: &Changes) -> Option<Acc> {
        if !self.reads_changed(acc.as_ref(), changes) {
            return None;
        }
        match acc {
            Some(Acc::Value(expr)) => Some(Acc::Value(self.aside(expr))),
            _ => None,
        }
    }

    /// A statement that changes something.
    pub(super) fn does(&mut self, statement: Stmt, needed: bool) {
        match &statement.kind {
            StmtKind::Assign(place, ..) => self.before(&Changes::Cells(place, 1), needed),
            StmtKind::Copy(place, _, cells) => self.before(&Changes::Cells(place, *cells), needed),
            StmtKind::Order(_, block, place) => {
                self.before(&Changes::Cells(place, block.cells()), needed);
            }
            _ => self.before(&Changes::Anything, needed),
        }
        self.push(statement);
    }

    /// Before a call that is given this: it may change anything, what is lent to it too.
    pub(super) fn before_call(&mut self, given: &[Argument]) {
        for one in given {
            if let Given::Place(target) = &one.given {
                let cells = self.built().tree.types.get(target.ty).cells;
                self.before(&Changes::Cells(&target.place, cells), false);
            }
        }
        self.before(&Changes::Anything, false);
    }

    /// Whether an expression may read what changes. Inputs stay what they are throughout a scan.
    pub(super) fn may_read(&self, expr: &Expr, changes: &Changes) -> bool {
        let mut rest = vec![expr];
        while let Some(expr) = rest.pop() {
            let reads = match &expr.kind {
                ExprKind::Read(place) => match changes {
                    Changes::Anything => !self.is_steady(place),
                    Changes::Cells(to, cells) => may_meet(place, to, *cells),
                },
                ExprKind::Call(_) => true,
                _ => false,
            };
            if reads {
                return true;
            }
            match &expr.kind {
                ExprKind::Constant(_) | ExprKind::Now | ExprKind::Wrong | ExprKind::Call(_) => {}
                ExprKind::Read(place) => {
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
            }
        }
        false
    }

    /// Whether this is an input, or what nothing but this body has.
    fn is_steady(&self, place: &Place) -> bool {
        let mut points = self.built().tree.points.iter();
        place.root == Root::Local
            || place.root == Root::Static
                && place.indices.is_empty()
                && points.any(|(cell, point)| *cell == place.offset && !point.is_written())
    }
}

/// Whether a place may be one of so many cells from another on.
fn may_meet(place: &Place, to: &Place, cells: u32) -> bool {
    // What is lent may be any cell but those of this call.
    if place.root != to.root {
        return place.root != Root::Local && to.root != Root::Local;
    }
    let reach = |index: &Index| index.count.saturating_sub(1).saturating_mul(index.stride);
    let last = |place: &Place| {
        let reaches = place.indices.iter().map(reach);
        reaches.fold(place.offset, u32::saturating_add)
    };
    to.offset <= last(place) && place.offset < last(to).saturating_add(cells)
}
