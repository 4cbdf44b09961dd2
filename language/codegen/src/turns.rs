//! Loops that would cost more than a scan can spend, written once for each turn, where their bounds are known.
//!
//! Owns what a body comes to where its variable has a value. Must not know what a loop costs.

use std::collections::HashSet;
use unoclp_text::diagnostics::Span;
use unoclp_tree::build::{leaves, turns};
use unoclp_tree::ops;
use unoclp_tree::{
    Expr, ExprKind, For, Index, Order, Place, Root, Stmt, StmtKind, Store, Tree, Value,
};

/// The variable of a loop, and its value in a turn.
struct Turn {
    root: Root,
    offset: u32,
    value: i128,
}

/// A tree whose loops at these places are written out; none where one of them has to stay.
pub(super) fn written_out(tree: &Tree, loops: &HashSet<Span>) -> Option<Tree> {
    let mut tree = tree.clone();
    let mut left = loops.clone();
    for unit in &mut tree.units {
        // Jumps count the statements of a body.
        let is_plain = |stmt: &Stmt| !matches!(stmt.kind, StmtKind::Jump(..) | StmtKind::Codes(_));
        if unit.body.iter().all(is_plain) {
            let body = std::mem::take(&mut unit.body);
            unit.body = outside(body, loops, &mut left);
        }
    }
    left.is_empty().then_some(tree)
}

/// Statements that stand in no loop which is written out.
fn outside(statements: Vec<Stmt>, loops: &HashSet<Span>, left: &mut HashSet<Span>) -> Vec<Stmt> {
    let mut all = Vec::with_capacity(statements.len());
    for mut statement in statements {
        let mut inner = |body: &mut Vec<Stmt>| *body = outside(std::mem::take(body), loops, left);
        match &mut statement.kind {
            StmtKind::If(arms, otherwise) => {
                arms.iter_mut().for_each(|(_, body)| inner(body));
                inner(otherwise);
            }
            StmtKind::Case(_, arms, otherwise) => {
                arms.iter_mut().for_each(|(_, body)| inner(body));
                inner(otherwise);
            }
            StmtKind::While(_, body) | StmtKind::Repeat(body, _) => inner(body),
            StmtKind::For(head) => {
                inner(&mut head.body);
                if loops.contains(&statement.at)
                    && let Some(turns) = turns_of(head, statement.at)
                {
                    left.remove(&statement.at);
                    all.extend(turns);
                    continue;
                }
            }
            _ => {}
        }
        all.push(statement);
    }
    all
}

/// All turns of a loop; none where its bounds are computed, or something in it changes its variable or leaves it.
fn turns_of(head: &For, at: Span) -> Option<Vec<Stmt>> {
    let values = turns(head);
    let Place { root, offset, .. } = head.variable;
    if values.is_empty() || leaves(&head.body) || super::pure::stores_to(&head.body, &head.variable)
    {
        return None;
    }
    let mut all = Vec::new();
    for value in &values {
        let turn = Turn {
            root,
            offset,
            value: *value,
        };
        turn.body(&head.body, &mut all);
    }
    let ExprKind::Constant(step) = &head.step.kind else {
        return None;
    };
    // Afterwards it is the last value and the step, or the last one where its type ends.
    let last = values.last()?;
    let behind = last + step.int();
    let range = head.base.range();
    let fits = range.is_none_or(|(least, most)| (least..=most).contains(&behind));
    let value = head.from.with(ExprKind::Constant(Value::Int(if fits {
        behind
    } else {
        *last
    })));
    let kind = StmtKind::Assign(head.variable.clone(), value, Store::Narrow(head.base));
    all.push(Stmt { kind, at });
    Some(all)
}

impl Turn {
    fn body(&self, statements: &[Stmt], all: &mut Vec<Stmt>) {
        for statement in statements {
            self.statement(statement, all);
        }
    }

    fn apart(&self, statements: &[Stmt]) -> Vec<Stmt> {
        let mut all = Vec::with_capacity(statements.len());
        self.body(statements, &mut all);
        all
    }

    fn statement(&self, statement: &Stmt, all: &mut Vec<Stmt>) {
        let kind = match &statement.kind {
            StmtKind::Assign(to, value, store) => {
                StmtKind::Assign(self.place(to), self.expr(value), *store)
            }
            StmtKind::Copy(to, from, cells) => {
                StmtKind::Copy(self.place(to), self.place(from), *cells)
            }
            StmtKind::If(arms, otherwise) => {
                let mut made = Vec::with_capacity(arms.len());
                let mut rest = otherwise;
                for (condition, body) in arms {
                    let condition = self.expr(condition);
                    match known(&condition).map(Value::is_true) {
                        Some(true) => {
                            rest = body;
                            break;
                        }
                        Some(false) => {}
                        None => made.push((condition, self.apart(body))),
                    }
                }
                if made.is_empty() {
                    return self.body(rest, all);
                }
                StmtKind::If(made, self.apart(rest))
            }
            StmtKind::Case(selector, arms, otherwise) => {
                let selector = self.expr(selector);
                if let Some(value) = known(&selector).map(Value::int) {
                    let has = |(low, high): &(i128, i128)| (*low..=*high).contains(&value);
                    let mut arms = arms.iter();
                    let arm = arms.find(|(bounds, _)| bounds.iter().any(has));
                    return self.body(arm.map_or(otherwise, |(_, body)| body), all);
                }
                let arms = arms.iter();
                let arms = arms.map(|(bounds, body)| (bounds.clone(), self.apart(body)));
                StmtKind::Case(selector, arms.collect(), self.apart(otherwise))
            }
            StmtKind::While(condition, body) => {
                StmtKind::While(self.expr(condition), self.apart(body))
            }
            StmtKind::Repeat(body, until) => StmtKind::Repeat(self.apart(body), self.expr(until)),
            StmtKind::For(head) => StmtKind::For(Box::new(For {
                variable: head.variable.clone(),
                base: head.base,
                from: self.expr(&head.from),
                to: self.expr(&head.to),
                step: self.expr(&head.step),
                body: self.apart(&head.body),
            })),
            StmtKind::Order(order, block, instance) => {
                let order = match order {
                    Order::Preset(value) => Order::Preset(self.expr(value)),
                    Order::Number(value) => Order::Number(self.expr(value)),
                    other => other.clone(),
                };
                StmtKind::Order(order, *block, self.place(instance))
            }
            StmtKind::Standard(block, instance) => StmtKind::Standard(*block, self.place(instance)),
            StmtKind::Print(name, value) => StmtKind::Print(name.clone(), self.expr(value)),
            // Calls may store anywhere, so no loop with one comes here.
            other => other.clone(),
        };
        let at = statement.at;
        all.push(Stmt { kind, at });
    }

    /// A place whose known subscripts are in its offset.
    fn place(&self, place: &Place) -> Place {
        let mut made = Place {
            indices: Vec::with_capacity(place.indices.len()),
            ..place.clone()
        };
        for index in &place.indices {
            let subscript = self.expr(&index.subscript);
            let within = known(&subscript).map(|value| value.int() - i128::from(index.low));
            let within = within.and_then(|within| u32::try_from(within).ok());
            match within.filter(|within| *within < index.count) {
                Some(within) => made.offset += within * index.stride,
                None => made.indices.push(Index {
                    subscript,
                    ..index.clone()
                }),
            }
        }
        made
    }

    fn is_variable(&self, place: &Place) -> bool {
        place.root == self.root && place.offset == self.offset && place.indices.is_empty()
    }

    fn all(&self, all: &[Expr]) -> Vec<Expr> {
        all.iter().map(|one| self.expr(one)).collect()
    }

    fn expr(&self, expr: &Expr) -> Expr {
        let kind = match &expr.kind {
            ExprKind::Read(place) if self.is_variable(place) => {
                ExprKind::Constant(Value::Int(self.value))
            }
            ExprKind::Read(place) => ExprKind::Read(Box::new(self.place(place))),
            ExprKind::Convert(how, of) => {
                let of = self.expr(of);
                let value = known(&of).map(|value| ops::convert(*how, of.base, expr.base, value));
                computed(value, || ExprKind::Convert(*how, Box::new(of)))
            }
            ExprKind::Unary(op, of) => {
                let of = self.expr(of);
                let value = known(&of).map(|value| ops::unary(*op, expr.base, value));
                computed(value, || ExprKind::Unary(*op, Box::new(of)))
            }
            ExprKind::Binary(op, a, b) => {
                let (a, b) = (self.expr(a), self.expr(b));
                let both = known(&a).zip(known(&b));
                let value = both.map(|(x, y)| ops::binary(*op, a.base, x, y));
                computed(value, || ExprKind::Binary(*op, Box::new(a), Box::new(b)))
            }
            ExprKind::Compare(op, a, b) => {
                let (a, b) = (self.expr(a), self.expr(b));
                let both = known(&a).zip(known(&b));
                let value = both.map(|(x, y)| (Value::truth(ops::compare(*op, x, y)), false));
                computed(value, || ExprKind::Compare(*op, Box::new(a), Box::new(b)))
            }
            ExprKind::Ordered(op, all) => ExprKind::Ordered(*op, self.all(all)),
            ExprKind::Extra(what, all) => ExprKind::Extra(*what, self.all(all)),
            ExprKind::Select(three) => {
                ExprKind::Select(Box::new(std::array::from_fn(|at| self.expr(&three[at]))))
            }
            ExprKind::Mux(which, all) => ExprKind::Mux(Box::new(self.expr(which)), self.all(all)),
            other => other.clone(),
        };
        expr.with(kind)
    }
}

fn known(expr: &Expr) -> Option<&Value> {
    match &expr.kind {
        ExprKind::Constant(value) => Some(value),
        _ => None,
    }
}

/// The value, where it is known and nothing has failed; else what computes it.
fn computed(value: Option<(Value, bool)>, other: impl FnOnce() -> ExprKind) -> ExprKind {
    match value {
        Some((value, false)) => ExprKind::Constant(value),
        _ => other(),
    }
}
