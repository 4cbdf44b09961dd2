//! Which cells statements read and write.
//!
//! Owns which actions have to do with each other, so that the order in which they are done matters.

use std::collections::{HashMap, HashSet};
use unoclp_tree::build::Builder;
use unoclp_tree::{Call, Expr, ExprKind, Input, Order, Place, Root, Stmt, StmtKind};

/// A row of more cells than this may be any of them.
const MOST_CELLS: u32 = 1_000;

/// A cell, and from where it is counted.
pub(crate) type Cell = (Root, u32);

/// What statements read and write.
#[derive(Debug, Default)]
pub(crate) struct Touched {
    /// Each cell, and whether it is written.
    pub cells: HashMap<Cell, bool>,
    /// Any other as well.
    pub any: bool,
    /// They are the body of a unit that is called; what that calls is not looked at.
    is_called: bool,
}

/// The places in an expression, to be changed.
pub(crate) fn places_of(expr: &mut Expr, of: &mut dyn FnMut(&mut Place)) {
    let mut all = |exprs: &mut [Expr]| {
        for expr in exprs {
            places_of(expr, of);
        }
    };
    match &mut expr.kind {
        ExprKind::Constant(_) | ExprKind::Now | ExprKind::Wrong => {}
        ExprKind::Read(place) => {
            for index in &mut place.indices {
                places_of(&mut index.subscript, of);
            }
            of(place);
        }
        ExprKind::Convert(_, a) | ExprKind::Unary(_, a) => places_of(a, of),
        ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => {
            places_of(a, of);
            places_of(b, of);
        }
        ExprKind::Ordered(_, exprs) | ExprKind::Extra(_, exprs) => all(exprs),
        ExprKind::Select(exprs) => all(&mut **exprs),
        ExprKind::Mux(which, exprs) => {
            places_of(which, of);
            for expr in exprs {
                places_of(expr, of);
            }
        }
        ExprKind::Call(call) => {
            for input in &mut call.inputs {
                match input {
                    Input::Value(_, value, _) => places_of(value, of),
                    Input::Cells(_, place, _) => of(place),
                }
            }
        }
    }
}

impl Touched {
    /// What an expression reads.
    pub(crate) fn expr(&mut self, expr: &Expr, builder: &Builder<'_, '_>) {
        match &expr.kind {
            ExprKind::Constant(_) | ExprKind::Now | ExprKind::Wrong => {}
            ExprKind::Read(place) => self.place(place, 1, false, builder),
            ExprKind::Convert(_, a) | ExprKind::Unary(_, a) => self.expr(a, builder),
            ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => {
                self.expr(a, builder);
                self.expr(b, builder);
            }
            ExprKind::Ordered(_, all) | ExprKind::Extra(_, all) => {
                all.iter().for_each(|one| self.expr(one, builder));
            }
            ExprKind::Select(all) => all.iter().for_each(|one| self.expr(one, builder)),
            ExprKind::Mux(which, all) => {
                self.expr(which, builder);
                all.iter().for_each(|one| self.expr(one, builder));
            }
            ExprKind::Call(call) => self.call(call, builder),
        }
    }

    fn place(&mut self, place: &Place, cells: u32, writes: bool, builder: &Builder<'_, '_>) {
        let mut end = u64::from(place.offset) + u64::from(cells);
        for index in &place.indices {
            self.expr(&index.subscript, builder);
            end += u64::from(index.count.saturating_sub(1)) * u64::from(index.stride);
        }
        if end > u64::from(place.offset) + u64::from(MOST_CELLS) {
            self.any = true;
            return;
        }
        for cell in u64::from(place.offset)..end {
            *self.cells.entry((place.root, cell as u32)).or_default() |= writes;
        }
    }

    fn call(&mut self, call: &Call, builder: &Builder<'_, '_>) {
        for input in &call.inputs {
            match input {
                Input::Value(_, value, _) => self.expr(value, builder),
                Input::Cells(_, place, cells) => self.place(place, *cells, false, builder),
            }
        }
        // Which cells an instance has is not looked at.
        let is_known = !self.is_called && call.lent.is_empty() && call.instance.is_none();
        self.any |= !is_known || reaches_out(call.unit, builder);
        for output in &call.outputs {
            self.place(&output.to, output.cells, true, builder);
        }
    }

    /// What statements read and write.
    pub(crate) fn stmts(&mut self, stmts: &[Stmt], builder: &Builder<'_, '_>) {
        for stmt in stmts {
            match &stmt.kind {
                StmtKind::Assign(place, value, _) => {
                    self.expr(value, builder);
                    self.place(place, 1, true, builder);
                }
                StmtKind::Copy(to, from, cells) => {
                    self.place(from, *cells, false, builder);
                    self.place(to, *cells, true, builder);
                }
                StmtKind::If(arms, or) => {
                    for (condition, body) in arms {
                        self.expr(condition, builder);
                        self.stmts(body, builder);
                    }
                    self.stmts(or, builder);
                }
                StmtKind::Case(selector, arms, or) => {
                    self.expr(selector, builder);
                    arms.iter().for_each(|(_, body)| self.stmts(body, builder));
                    self.stmts(or, builder);
                }
                StmtKind::While(condition, body) | StmtKind::Repeat(body, condition) => {
                    self.expr(condition, builder);
                    self.stmts(body, builder);
                }
                StmtKind::For(turns) => {
                    for expr in [&turns.from, &turns.to, &turns.step] {
                        self.expr(expr, builder);
                    }
                    self.place(&turns.variable, 1, true, builder);
                    self.stmts(&turns.body, builder);
                }
                StmtKind::Exit | StmtKind::Continue | StmtKind::Return => {}
                StmtKind::Call(call) => self.call(call, builder),
                StmtKind::Standard(block, place) => {
                    self.place(place, block.cells(), true, builder);
                }
                StmtKind::Order(order, block, place) => {
                    if let Order::Preset(value) | Order::Number(value) = order {
                        self.expr(value, builder);
                    }
                    self.place(place, block.cells(), true, builder);
                }
                StmtKind::Print(_, value) => self.expr(value, builder),
                StmtKind::Codes(_) => self.any = true,
                StmtKind::Jump(condition, _) => {
                    condition.iter().for_each(|one| self.expr(one, builder));
                }
            }
        }
    }
}

/// Whether a unit may read or write what is not its own. One that calls others may, and one that has no body yet.
fn reaches_out(unit: u32, builder: &Builder<'_, '_>) -> bool {
    let body = builder.draft(unit).map(|draft| &draft.unit.body);
    let Some(body) = body.filter(|body| !body.is_empty()) else {
        return true;
    };
    let mut own = Touched {
        is_called: true,
        ..Touched::default()
    };
    own.stmts(body, builder);
    own.any || own.cells.keys().any(|(root, _)| *root == Root::Static)
}

/// Which of these have to do with others: one of them writes what another one reads or writes.
pub(crate) fn together(all: &[Touched]) -> Vec<bool> {
    if all.len() > 1 && all.iter().any(|one| one.any) {
        return vec![true; all.len()];
    }
    // Of each cell how many touch it, and whether one of them writes it.
    let mut cells: HashMap<Cell, (u32, bool)> = HashMap::new();
    for (cell, writes) in all.iter().flat_map(|one| &one.cells) {
        let of = cells.entry(*cell).or_default();
        *of = (of.0 + 1, of.1 | writes);
    }
    cells.retain(|_, (count, writes)| *count > 1 && *writes);
    let shared: HashSet<Cell> = cells.into_keys().collect();
    let shares = |one: &Touched| one.cells.keys().any(|cell| shared.contains(cell));
    all.iter().map(shares).collect()
}
