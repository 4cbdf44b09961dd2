//! A program without calls: what the typed tree becomes on its way to the board.
//!
//! Owns its statements, whose places are all counted from the program's first cell, and a walk over them. Must not
//! know registers, markers and instructions.

use std::collections::HashSet;
use unoclp_text::diagnostics::Span;
use unoclp_tree::{
    Base, Binary, Cell, Compare, Expr, ExprKind, Order, Place, Root, Standard, Store, TypeId,
    Unary, Value,
};

/// Cells from this number on are temporaries; an odd one holds a value that is not narrowed to its type.
pub(super) const TEMPORARY: u32 = 1 << 30;

/// A program without calls.
#[derive(Debug, Default)]
pub(super) struct Flat {
    /// Those of the tree, and after them those of each call.
    pub cells: Vec<Cell>,
    pub body: Vec<Step>,
    /// How many labels there are.
    pub labels: u32,
    /// The labels where the program ends, which RETURN leads to.
    pub leaves: HashSet<u32>,
    pub loops: Vec<Turns>,
    /// The cell that reads as the time stamp of the scan, ms, where something asks for it.
    pub now: Option<u32>,
    /// Where the cells of each call begin, in their order, and the unit that is called.
    pub calls: Vec<(u32, u32)>,
}

/// A loop: how often it turns each time it is reached, and the loop around it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turns {
    pub jumps: Option<u128>,
    pub outer: Option<usize>,
    pub at: Span,
}

#[derive(Clone, Debug)]
pub(super) struct Step {
    pub does: Does,
    pub at: Span,
    /// Whether it is a statement of the text, whose line shows what it does.
    pub shown: bool,
}

/// An arm of CASE.
pub(super) type Arm = (Vec<(i128, i128)>, Vec<Step>);

#[derive(Clone, Debug)]
pub(super) enum Does {
    Assign(Place, Expr, Store),
    Copy(Place, Place, u32),
    If(Expr, Vec<Step>, Vec<Step>),
    Case(Expr, Vec<Arm>, Vec<Step>),
    Label(u32),
    /// Where it holds; a jump back belongs to a loop.
    Jump(Option<Expr>, u32, Option<usize>),
    /// The block whose cells begin here; inputs that are used here alone, by their cells within it.
    Standard(Standard, u32, Vec<(u32, Expr)>),
    /// What is done to the timer or counter whose cells begin here, beside its calls.
    Order(Order, Standard, u32),
    /// An instruction as it is: acc before it, its codes, and the cell that acc goes to behind it.
    Codes(Option<Expr>, Vec<(i32, Span)>, Option<u32>),
    /// Sets S 04.
    Fail,
}

impl Flat {
    /// The cell that reads as the time stamp of the scan.
    pub(super) fn now(&mut self) -> u32 {
        let cells = &mut self.cells;
        *self.now.get_or_insert_with(|| {
            cells.push(Cell::own(Base::Time));
            cells.len() as u32 - 1
        })
    }
}

/// The place of one cell.
pub(super) fn place(cell: u32, at: Span) -> Place {
    Place {
        root: Root::Static,
        offset: cell,
        indices: Vec::new(),
        at,
    }
}

/// What a cell holds.
pub(super) fn read(cell: u32, base: Base, at: Span) -> Expr {
    expr(ExprKind::Read(Box::new(place(cell, at))), base, at)
}

pub(super) fn expr(kind: ExprKind, base: Base, at: Span) -> Expr {
    Expr {
        kind,
        base,
        ty: TypeId::of(base),
        at,
    }
}

pub(super) fn constant(value: Value, base: Base, at: Span) -> Expr {
    expr(ExprKind::Constant(value), base, at)
}

/// A whole number.
pub(super) fn whole(value: i128, base: Base, at: Span) -> Expr {
    constant(Value::Int(value), base, at)
}

/// A comparison of two.
pub(super) fn compare(op: Compare, a: Expr, b: Expr) -> Expr {
    let at = a.at;
    expr(
        ExprKind::Compare(op, Box::new(a), Box::new(b)),
        Base::Bool,
        at,
    )
}

/// Not so.
pub(super) fn not(condition: Expr) -> Expr {
    let at = condition.at;
    expr(
        ExprKind::Unary(Unary::Not, Box::new(condition)),
        Base::Bool,
        at,
    )
}

/// Both of them.
pub(super) fn both(op: Binary, a: Expr, b: Expr) -> Expr {
    let at = a.at;
    let base = a.base;
    expr(ExprKind::Binary(op, Box::new(a), Box::new(b)), base, at)
}

/// The parts of an expression.
pub(super) fn parts(expr: &Expr) -> Vec<&Expr> {
    match &expr.kind {
        ExprKind::Constant(_) | ExprKind::Call(_) | ExprKind::Now | ExprKind::Wrong => Vec::new(),
        ExprKind::Read(place) => place.indices.iter().map(|i| &i.subscript).collect(),
        ExprKind::Convert(_, a) | ExprKind::Unary(_, a) => vec![a],
        ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => vec![a, b],
        ExprKind::Ordered(_, all) | ExprKind::Extra(_, all) => all.iter().collect(),
        ExprKind::Select(three) => three.iter().collect(),
        ExprKind::Mux(which, all) => std::iter::once(&**which).chain(all).collect(),
    }
}

/// The same, to change them.
pub(super) fn parts_mut(expr: &mut Expr) -> Vec<&mut Expr> {
    match &mut expr.kind {
        ExprKind::Constant(_) | ExprKind::Call(_) | ExprKind::Now | ExprKind::Wrong => Vec::new(),
        ExprKind::Read(place) => place.indices.iter_mut().map(|i| &mut i.subscript).collect(),
        ExprKind::Convert(_, a) | ExprKind::Unary(_, a) => vec![a],
        ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => vec![a, b],
        ExprKind::Ordered(_, all) | ExprKind::Extra(_, all) => all.iter_mut().collect(),
        ExprKind::Select(three) => three.iter_mut().collect(),
        ExprKind::Mux(which, all) => std::iter::once(&mut **which).chain(all).collect(),
    }
}

/// Calls it with each expression in this one, and with itself.
pub(super) fn each<'e>(expr: &'e Expr, visit: &mut dyn FnMut(&'e Expr)) {
    visit(expr);
    for part in parts(expr) {
        each(part, visit);
    }
}

/// The expressions that a step computes itself, those of its places among them.
pub(super) fn own_expressions(does: &Does) -> Vec<&Expr> {
    fn subscripts(place: &Place) -> impl Iterator<Item = &Expr> {
        place.indices.iter().map(|index| &index.subscript)
    }
    match does {
        Does::Assign(to, value, _) => subscripts(to).chain([value]).collect(),
        Does::Copy(to, from, _) => subscripts(to).chain(subscripts(from)).collect(),
        Does::If(condition, ..) | Does::Case(condition, ..) => vec![condition],
        Does::Jump(condition, ..) | Does::Codes(condition, ..) => condition.iter().collect(),
        Does::Standard(_, _, inputs) => inputs.iter().map(|(_, e)| e).collect(),
        Does::Order(order, ..) => order.value().into_iter().collect(),
        Does::Label(_) | Does::Fail => Vec::new(),
    }
}

/// The same, to change them.
pub(super) fn own_expressions_mut(does: &mut Does) -> Vec<&mut Expr> {
    fn subscripts(place: &mut Place) -> impl Iterator<Item = &mut Expr> {
        place.indices.iter_mut().map(|index| &mut index.subscript)
    }
    match does {
        Does::Assign(to, value, _) => subscripts(to).chain([value]).collect(),
        Does::Copy(to, from, _) => subscripts(to).chain(subscripts(from)).collect(),
        Does::If(condition, ..) | Does::Case(condition, ..) => vec![condition],
        Does::Jump(condition, ..) | Does::Codes(condition, ..) => condition.iter_mut().collect(),
        Does::Standard(_, _, inputs) => inputs.iter_mut().map(|(_, e)| e).collect(),
        Does::Order(Order::Preset(value) | Order::Number(value), ..) => vec![value],
        Does::Order(..) => Vec::new(),
        Does::Label(_) | Does::Fail => Vec::new(),
    }
}

impl Does {
    /// The same with the steps within it rewritten.
    pub(super) fn with_inner(self, rewrite: &mut dyn FnMut(Vec<Step>) -> Vec<Step>) -> Does {
        match self {
            Does::If(condition, then, otherwise) => {
                Does::If(condition, rewrite(then), rewrite(otherwise))
            }
            Does::Case(selector, arms, otherwise) => {
                let arms = arms.into_iter();
                let arms = arms.map(|(bounds, body)| (bounds, rewrite(body))).collect();
                Does::Case(selector, arms, rewrite(otherwise))
            }
            other => other,
        }
    }
}

/// The steps within a step.
pub(super) fn within(does: &Does) -> Vec<&[Step]> {
    match does {
        Does::If(_, then, otherwise) => vec![then, otherwise],
        Does::Case(_, arms, otherwise) => {
            let arms = arms.iter().map(|(_, body)| body.as_slice());
            arms.chain([otherwise.as_slice()]).collect()
        }
        _ => Vec::new(),
    }
}
