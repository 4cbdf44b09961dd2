//! Expressions and statements as a chart needs them.

use unoclp_text::diagnostics::Span;
use unoclp_tree::{
    Base, Binary, Expr, ExprKind, Place, Standard, Stmt, StmtKind, Store, TypeId, Unary, Value,
};

fn expr(kind: ExprKind, base: Base, at: Span) -> Expr {
    Expr {
        kind,
        base,
        ty: TypeId::of(base),
        at,
    }
}

/// A place, so many cells further on, as it is used there.
pub(crate) fn part(place: &Place, by: u32, at: Span) -> Place {
    let mut place = place.clone();
    place.offset += by;
    place.at = at;
    place
}

pub(crate) fn read(place: Place, base: Base) -> Expr {
    let at = place.at;
    expr(ExprKind::Read(Box::new(place)), base, at)
}

pub(crate) fn bit(place: &Place, at: Span) -> Expr {
    read(part(place, 0, at), Base::Bool)
}

pub(crate) fn truth(is: bool, at: Span) -> Expr {
    expr(ExprKind::Constant(Value::truth(is)), Base::Bool, at)
}

pub(crate) fn time(ms: i128, at: Span) -> Expr {
    expr(ExprKind::Constant(Value::Int(ms)), Base::Time, at)
}

pub(crate) fn now(at: Span) -> Expr {
    expr(ExprKind::Now, Base::Time, at)
}

pub(crate) fn not(a: Expr) -> Expr {
    let at = a.at;
    expr(ExprKind::Unary(Unary::Not, Box::new(a)), Base::Bool, at)
}

pub(crate) fn both(op: Binary, a: Expr, b: Expr) -> Expr {
    let (base, at) = (a.base, a.at);
    expr(ExprKind::Binary(op, Box::new(a), Box::new(b)), base, at)
}

/// All of them; none of none.
pub(crate) fn joined(op: Binary, all: impl IntoIterator<Item = Expr>) -> Option<Expr> {
    // Balanced, so that many go no deeper than a few.
    let mut all: Vec<Expr> = all.into_iter().collect();
    while all.len() > 1 {
        let mut pairs = Vec::with_capacity(all.len().div_ceil(2));
        let mut rest = all.into_iter();
        while let Some(a) = rest.next() {
            pairs.push(match rest.next() {
                Some(b) => both(op, a, b),
                None => a,
            });
        }
        all = pairs;
    }
    all.pop()
}

pub(crate) fn assign(place: Place, value: Expr) -> Stmt {
    let (at, base) = (place.at, value.base);
    let kind = StmtKind::Assign(place, value, Store::Narrow(base));
    Stmt { kind, at }
}

pub(crate) fn when(condition: Expr, then: Vec<Stmt>, at: Span) -> Stmt {
    let kind = StmtKind::If(vec![(condition, then)], Vec::new());
    Stmt { kind, at }
}

/// Sets a bit, or resets it.
pub(crate) fn puts(condition: Expr, place: &Place, is: bool, at: Span) -> Stmt {
    let stores = assign(part(place, 0, at), truth(is, at));
    when(condition, vec![stores], at)
}

/// A call of a block of the standard, whose cells stand there; the inputs by their numbers.
pub(crate) fn call(
    block: Standard,
    instance: &Place,
    inputs: Vec<(u32, Expr)>,
    at: Span,
) -> impl Iterator<Item = Stmt> {
    let place = part(instance, 0, at);
    let input = move |(number, value): (u32, Expr)| assign(part(&place, number, at), value);
    let calls = Stmt {
        kind: StmtKind::Standard(block, part(instance, 0, at)),
        at,
    };
    inputs.into_iter().map(input).chain([calls])
}

/// An output of such a block.
pub(crate) fn output(instance: &Place, number: u32, at: Span) -> Expr {
    read(part(instance, number, at), Base::Bool)
}
