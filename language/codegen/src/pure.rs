//! What a unit of the typed tree changes.
//!
//! Owns questions about the body of a unit: what it stores to, and in which order. Must not know the board.

use super::uses::reach;
use unoclp_tree::{Expr, ExprKind, Input, Place, Root, Stmt, StmtKind, Tree, Unit};

/// The places that a statement changes, those of the statements within it too.
fn changed<'s>(statement: &'s Stmt, visit: &mut dyn FnMut(&'s Place)) {
    match &statement.kind {
        StmtKind::Assign(to, ..) | StmtKind::Copy(to, ..) => visit(to),
        StmtKind::Standard(_, instance) | StmtKind::Order(.., instance) => visit(instance),
        StmtKind::For(head) => visit(&head.variable),
        StmtKind::Codes(codes) => codes.behind.iter().for_each(&mut *visit),
        _ => {}
    }
    for call in calls(statement) {
        call.lent.iter().for_each(&mut *visit);
        call.outputs.iter().for_each(|output| visit(&output.to));
        call.instance.iter().for_each(&mut *visit);
    }
    for inner in within(statement) {
        changed(inner, visit);
    }
}

pub(super) fn within(statement: &Stmt) -> Vec<&Stmt> {
    match &statement.kind {
        StmtKind::If(arms, otherwise) => {
            let bodies = arms.iter().flat_map(|(_, body)| body);
            bodies.chain(otherwise).collect()
        }
        StmtKind::Case(_, arms, otherwise) => {
            let bodies = arms.iter().flat_map(|(_, body)| body);
            bodies.chain(otherwise).collect()
        }
        StmtKind::While(_, body) | StmtKind::Repeat(body, _) => body.iter().collect(),
        StmtKind::For(head) => head.body.iter().collect(),
        _ => Vec::new(),
    }
}

/// The expressions that a statement computes itself.
pub(super) fn expressions(statement: &Stmt) -> Vec<&Expr> {
    fn subscripts(place: &Place) -> impl Iterator<Item = &Expr> {
        place.indices.iter().map(|index| &index.subscript)
    }
    match &statement.kind {
        StmtKind::Assign(to, value, _) => subscripts(to).chain([value]).collect(),
        StmtKind::Copy(to, from, _) => subscripts(to).chain(subscripts(from)).collect(),
        StmtKind::If(arms, _) => arms.iter().map(|(condition, _)| condition).collect(),
        StmtKind::Case(value, ..)
        | StmtKind::While(value, _)
        | StmtKind::Repeat(_, value)
        | StmtKind::Print(_, value) => vec![value],
        StmtKind::For(head) => vec![&head.from, &head.to, &head.step],
        StmtKind::Jump(condition, _) => condition.iter().collect(),
        StmtKind::Call(call) => given(call),
        StmtKind::Codes(codes) => codes.before.iter().collect(),
        StmtKind::Order(order, ..) => order.value().into_iter().collect(),
        StmtKind::Exit | StmtKind::Continue | StmtKind::Return | StmtKind::Standard(..) => {
            Vec::new()
        }
    }
}

pub(super) fn given(call: &unoclp_tree::Call) -> Vec<&Expr> {
    let mut all = Vec::new();
    for input in &call.inputs {
        match input {
            Input::Value(_, value, _) => all.push(value),
            Input::Cells(_, place, _) => all.extend(place.indices.iter().map(|i| &i.subscript)),
        }
    }
    let places = call.lent.iter().chain(call.outputs.iter().map(|o| &o.to));
    all.extend(places.flat_map(|place| place.indices.iter().map(|i| &i.subscript)));
    all
}

/// Each expression within one, calls' inputs too.
fn each<'e>(expr: &'e Expr, visit: &mut dyn FnMut(&'e Expr)) {
    visit(expr);
    let parts = match &expr.kind {
        ExprKind::Call(call) => given(call),
        _ => super::flat::parts(expr),
    };
    for part in parts {
        each(part, visit);
    }
}

pub(super) fn calls(statement: &Stmt) -> Vec<&unoclp_tree::Call> {
    let mut all = Vec::new();
    if let StmtKind::Call(call) = &statement.kind {
        all.push(call);
    }
    for expr in expressions(statement) {
        each(expr, &mut |e| {
            if let ExprKind::Call(call) = &e.kind {
                all.push(call);
            }
        });
    }
    all
}

/// Of each unit whether a call of it changes nothing but its own locals.
pub(super) fn pure_units(tree: &Tree) -> Vec<bool> {
    let mut pure = Vec::with_capacity(tree.units.len());
    let mut called = Vec::with_capacity(tree.units.len());
    for unit in &tree.units {
        let (mut own, mut calls) = (true, Vec::new());
        for statement in &unit.body {
            changed(statement, &mut |place| own &= place.root == Root::Local);
            all_calls(statement, &mut calls);
        }
        pure.push(own);
        called.push(calls);
    }
    // What calls something that is not, is not: as far as that reaches.
    let mut goes_on = true;
    while goes_on {
        goes_on = false;
        for unit in 0..pure.len() {
            let is = |other: &u32| pure.get(*other as usize).copied().unwrap_or(true);
            if pure[unit] && !called[unit].iter().all(is) {
                pure[unit] = false;
                goes_on = true;
            }
        }
    }
    pure
}

fn all_calls(statement: &Stmt, into: &mut Vec<u32>) {
    let numbers = calls(statement).into_iter().map(|call| call.unit);
    for number in numbers {
        if !into.contains(&number) {
            into.push(number);
        }
    }
    for inner in within(statement) {
        all_calls(inner, into);
    }
}

/// Whether computing this may change what another expression reads.
pub(super) fn may_change(pure: &[bool], expr: &Expr) -> bool {
    let mut may = false;
    each(expr, &mut |e| {
        if let ExprKind::Call(call) = &e.kind {
            may |=
                !call.outputs.is_empty() || !pure.get(call.unit as usize).copied().unwrap_or(true);
        }
    });
    may
}

/// Whether the body stores to this local, or may.
pub(super) fn is_written(unit: &Unit, local: u32) -> bool {
    let mut written = false;
    for statement in &unit.body {
        changed(statement, &mut |place| {
            let near = place.offset == local || !place.indices.is_empty();
            written |= place.root == Root::Local && near;
        });
        // A copy stores to several.
        written |= matches!(&statement.kind, StmtKind::Copy(to, ..) if to.root == Root::Local);
    }
    written
}

/// Whether the body stores to this local before anything reads it.
pub(super) fn is_stored_first(unit: &Unit, local: u32) -> bool {
    let reads = |statement: &Stmt| {
        let mut reads = false;
        mentions(statement, &mut |place, cells| {
            let range = place.offset..place.offset.saturating_add(cells.max(1));
            reads |=
                place.root == Root::Local && (range.contains(&local) || !place.indices.is_empty());
        });
        reads
    };
    for statement in &unit.body {
        if let StmtKind::Assign(to, value, unoclp_tree::Store::Narrow(_)) = &statement.kind
            && to.root == Root::Local
            && to.offset == local
            && to.indices.is_empty()
        {
            let mut read = false;
            each(value, &mut |e| {
                if let ExprKind::Read(place) = &e.kind {
                    let near = place.offset == local || !place.indices.is_empty();
                    read |= place.root == Root::Local && near;
                }
            });
            return !read;
        }
        if reads(statement) || leaves(statement) {
            return false;
        }
    }
    false
}

/// Whether something in it may leave the body, so that what follows it is not reached.
fn leaves(statement: &Stmt) -> bool {
    matches!(statement.kind, StmtKind::Return | StmtKind::Jump(..))
        || within(statement).into_iter().any(leaves)
}

/// Every place that a statement reads or changes, with how many cells.
fn mentions<'s>(statement: &'s Stmt, visit: &mut dyn FnMut(&'s Place, u32)) {
    match &statement.kind {
        StmtKind::Copy(to, from, cells) => {
            visit(to, *cells);
            visit(from, *cells);
        }
        StmtKind::Assign(to, ..) => visit(to, 1),
        StmtKind::Standard(block, instance) | StmtKind::Order(_, block, instance) => {
            visit(instance, block.cells());
        }
        StmtKind::For(head) => visit(&head.variable, 1),
        StmtKind::Codes(codes) => codes.behind.iter().for_each(|to| visit(to, 1)),
        _ => {}
    }
    for expr in expressions(statement) {
        each(expr, &mut |e| {
            if let ExprKind::Read(place) = &e.kind {
                visit(place, 1);
            }
        });
    }
    for call in calls(statement) {
        // What is lent may be as large as it likes.
        call.lent.iter().for_each(|place| visit(place, 100_000));
        for output in &call.outputs {
            visit(&output.to, output.cells);
        }
        for input in &call.inputs {
            if let Input::Cells(_, place, cells) = input {
                visit(place, *cells);
            }
        }
    }
    for inner in within(statement) {
        mentions(inner, visit);
    }
}

/// The statements of a body that jumps name.
pub(super) fn targets(unit: &Unit) -> Vec<u32> {
    let jumps = unit
        .body
        .iter()
        .filter_map(|statement| match statement.kind {
            StmtKind::Jump(_, to) => Some(to),
            _ => None,
        });
    let mut all: Vec<u32> = jumps.collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Whether one of these statements stores to what may be this place.
pub(super) fn stores_to(statements: &[Stmt], place: &Place) -> bool {
    let mut stores = false;
    for statement in statements {
        stores |= leaves_open(statement);
        changed(statement, &mut |to| {
            let near = to.root != place.root
                || to.offset <= place.offset.saturating_add(reach(place))
                    && place.offset <= to.offset.saturating_add(reach(to));
            stores |= near && may_meet(to.root, place.root);
        });
    }
    stores
}

/// Places that are counted from different roots may be the same cell, but for those of a call.
fn may_meet(a: Root, b: Root) -> bool {
    a == b || a != Root::Local && b != Root::Local
}

/// Whether it calls or copies, so that what it stores to is not told by a place alone.
fn leaves_open(statement: &Stmt) -> bool {
    let wide = matches!(statement.kind, StmtKind::Copy(..));
    wide || !calls(statement).is_empty() || within(statement).into_iter().any(leaves_open)
}
