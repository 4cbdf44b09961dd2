//! Loops, as labels and jumps.
//!
//! Owns how often each loop turns, where that is known. Must not know what a jump costs.

use super::flat::{Does, Turns, both, compare, constant, expr, not};
use super::inline::{Frame, Inliner, Inner};
use unoclp_text::diagnostics::Span;
use unoclp_tree::{Base, Binary, Compare, Expr, ExprKind, For, Place, Stmt, Store, Value, Width};

impl Inliner<'_, '_> {
    fn begin_loop(&mut self, jumps: Option<u128>, at: Span) -> (usize, Option<usize>) {
        let outer = self.inner;
        self.flat.loops.push(Turns { jumps, outer, at });
        let number = self.flat.loops.len() - 1;
        self.inner = Some(number);
        self.loops.push(Inner::default());
        (number, outer)
    }

    fn end_loop(&mut self, outer: Option<usize>, at: Span) {
        self.inner = outer;
        if let Some(exit) = self.loops.pop().and_then(|inner| inner.exit) {
            self.push(Does::Label(exit), at);
        }
    }

    fn next_turn(&mut self, at: Span) {
        if let Some(next) = self.loops.last().and_then(|inner| inner.next) {
            self.push(Does::Label(next), at);
        }
    }

    pub(super) fn while_loop(
        &mut self,
        condition: &Expr,
        body: &[Stmt],
        at: Span,
        frame: &mut Frame,
    ) {
        let (number, outer) = self.begin_loop(None, at);
        let again = self.label();
        if let Some(inner) = self.loops.last_mut() {
            inner.next = Some(again);
        }
        self.push(Does::Label(again), at);
        let condition = self.expr(condition, frame);
        let then = self.apart(|this| {
            this.statements(body, frame);
            this.push(Does::Jump(None, again, Some(number)), at);
        });
        self.show(Does::If(condition, then, Vec::new()), at);
        self.end_loop(outer, at);
    }

    pub(super) fn repeat(&mut self, body: &[Stmt], until: &Expr, at: Span, frame: &mut Frame) {
        let (number, outer) = self.begin_loop(None, at);
        let again = self.label();
        self.push(Does::Label(again), at);
        self.statements(body, frame);
        self.next_turn(at);
        let until = self.expr(until, frame);
        self.show(Does::Jump(Some(not(until)), again, Some(number)), at);
        self.end_loop(outer, at);
    }

    pub(super) fn counting(&mut self, head: &For, at: Span, frame: &mut Frame) {
        let from = self.expr(&head.from, frame);
        let to = self.expr(&head.to, frame);
        let step = self.expr(&head.step, frame);
        let variable = self.place(&head.variable, frame);
        let known = |e: &Expr| match &e.kind {
            ExprKind::Constant(value) => Some(value.int()),
            _ => None,
        };
        let (first, last, by) = (known(&from), known(&to), known(&step));
        if by == Some(0) {
            self.push(Does::Fail, at);
            return;
        }
        let (least, most) = head.base.range().unwrap_or((0, 0));
        let turns = match (first, last, by) {
            (Some(first), Some(last), Some(by)) => Some(count(first, last, by, least, most)),
            _ => None,
        };
        let lasting = |this: &mut Self, value: Expr| match known(&value) {
            Some(_) => value,
            None => this.aside(value),
        };
        let (to, step) = (lasting(self, to), lasting(self, step));
        if by.is_none() {
            let none = constant(Value::Int(0), step.base, at);
            let never = compare(Compare::Equal, step.clone(), none);
            let fail = self.apart(|this| this.push(Does::Fail, at));
            let counts =
                self.apart(|this| this.turns(head, &variable, from, to, step, turns, at, frame));
            self.push(Does::If(never, fail, counts), at);
            return;
        }
        self.turns(head, &variable, from, to, step, turns, at, frame);
    }

    #[allow(clippy::too_many_arguments)]
    fn turns(
        &mut self,
        head: &For,
        variable: &Place,
        from: Expr,
        to: Expr,
        step: Expr,
        turns: Option<u128>,
        at: Span,
        frame: &mut Frame,
    ) {
        let base = head.base;
        self.show(
            Does::Assign(variable.clone(), from, Store::Narrow(base)),
            at,
        );
        if turns == Some(0) {
            return;
        }
        let held = || Expr {
            at,
            ..expr(ExprKind::Read(Box::new(variable.clone())), base, at)
        };
        let known = |e: &Expr| match &e.kind {
            ExprKind::Constant(value) => Some(value.int()),
            _ => None,
        };
        let (least, most) = base.range().unwrap_or((0, 0));
        let goes_on = self.goes_on(held(), &to, &step, at);
        // What it is next, and whether its type still has that.
        let next = both(Binary::Add, held(), step.clone());
        let reach = known(&to).zip(known(&step)).map(|(to, by)| to + by);
        let fits = reach.is_some_and(|reach| (least..=most).contains(&reach));
        let fits = fits && !is_written(&head.body, &head.variable);
        let within = (!fits).then(|| self.within(&next, held(), &step, base, at));
        // It is stored only where the type has it, so it needs no narrowing.
        let kept = match base.width() {
            Width::Signed => Base::Dint,
            _ => base,
        };
        let store = || Does::Assign(variable.clone(), next.clone(), Store::Narrow(kept));
        let (number, outer) = self.begin_loop(turns, at);
        let again = self.label();
        self.push(Does::Label(again), at);
        if turns.is_some() && within.is_none() {
            // At least one turn, so it is asked after it.
            if let Some(turns) = self.flat.loops.get_mut(number) {
                turns.jumps = turns.jumps.map(|jumps| jumps - 1);
            }
            self.statements(&head.body, frame);
            self.next_turn(at);
            self.show(store(), at);
            self.push(Does::Jump(Some(goes_on), again, Some(number)), at);
            self.end_loop(outer, at);
            return;
        }
        let then = self.apart(|this| {
            this.statements(&head.body, frame);
            this.next_turn(at);
            let jump = Does::Jump(None, again, Some(number));
            match within {
                None => {
                    this.show(store(), at);
                    this.push(jump, at);
                }
                Some(within) => {
                    let go_on = this.apart(|this| {
                        this.show(store(), at);
                        this.push(jump, at);
                    });
                    this.push(Does::If(within, go_on, Vec::new()), at);
                }
            }
        });
        self.push(Does::If(goes_on, then, Vec::new()), at);
        self.end_loop(outer, at);
    }

    /// Whether the variable has not passed its last value.
    fn goes_on(&mut self, held: Expr, to: &Expr, step: &Expr, at: Span) -> Expr {
        let up = compare(Compare::LessEqual, held.clone(), to.clone());
        let down = compare(Compare::GreaterEqual, held, to.clone());
        match direction(step) {
            Some(true) => up,
            Some(false) => down,
            None => by_direction(step, up, down, at),
        }
    }

    /// Whether the type has the next value.
    fn within(&mut self, next: &Expr, held: Expr, step: &Expr, base: Base, at: Span) -> Expr {
        let (least, most) = base.range().unwrap_or((0, 0));
        if base.bits() == 32 && base != Base::Tod {
            // It has passed an end where it has gone the other way.
            let up = compare(Compare::Greater, next.clone(), held.clone());
            let down = compare(Compare::Less, next.clone(), held);
            return match direction(step) {
                Some(true) => up,
                Some(false) => down,
                None => by_direction(step, up, down, at),
            };
        }
        let bound = |value| constant(Value::Int(value), base, at);
        let up = compare(Compare::LessEqual, next.clone(), bound(most));
        let down = compare(Compare::GreaterEqual, next.clone(), bound(least));
        match direction(step) {
            Some(true) => up,
            Some(false) => down,
            None => both(Binary::And, up, down),
        }
    }
}

/// Whether it counts up, if that is known.
fn direction(step: &Expr) -> Option<bool> {
    match &step.kind {
        ExprKind::Constant(value) => Some(value.int() > 0),
        _ if step.base.width() == Width::Unsigned => Some(true),
        _ => None,
    }
}

fn by_direction(step: &Expr, up: Expr, down: Expr, at: Span) -> Expr {
    let none = || constant(Value::Int(0), step.base, at);
    let rises = compare(Compare::Greater, step.clone(), none());
    let falls = compare(Compare::Less, step.clone(), none());
    let up = both(Binary::And, rises, up);
    both(Binary::Or, up, both(Binary::And, falls, down))
}

/// How often a loop turns; its variable stops where its type ends.
fn count(first: i128, last: i128, by: i128, least: i128, most: i128) -> u128 {
    let last = match by > 0 {
        true => last.min(most),
        false => last.max(least),
    };
    let far = if by > 0 { last - first } else { first - last };
    match far < 0 {
        true => 0,
        false => (far / by.abs()) as u128 + 1,
    }
}

/// Whether something in the body stores to it, or may.
fn is_written(body: &[Stmt], variable: &Place) -> bool {
    super::pure::stores_to(body, variable)
}
