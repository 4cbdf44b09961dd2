//! What always holds of a finished tree: whoever runs or lowers it asks no question of types again.

use crate::typed;
use std::collections::BTreeMap;
use unoclp_lang::check;
use unoclp_lang::typed::{
    Base, Binary, Call, Convert, Expr, ExprKind, Extra, Input, Place, Stmt, StmtKind, Store, Tree,
    Unary,
};

/// What is wrong with an expression or what is within it.
fn expression(expr: &Expr, tree: &Tree, faults: &mut Vec<String>) {
    let mut no = |what: &str| faults.push(format!("{what}: {expr:?}"));
    if expr.base.is_any() {
        no("a number that is not settled");
    }
    if tree.types.base(expr.ty) != Some(expr.base) {
        no("the type has another base");
    }
    match &expr.kind {
        ExprKind::Wrong => no("wrong"),
        ExprKind::Now if expr.base != Base::Time => no("a time of another type"),
        ExprKind::Now => {}
        ExprKind::Constant(value) => {
            let reals = matches!(value, unoclp_lang::typed::Value::Real(_));
            let texts = matches!(value, unoclp_lang::typed::Value::Text(_));
            if reals != expr.base.is_real() || texts != expr.base.is_text() {
                no("a constant of another type");
            }
        }
        ExprKind::Read(of) => place(of, tree, faults),
        ExprKind::Convert(how, inner) => {
            let (from, to) = (inner.base, expr.base);
            let fits = match how {
                Convert::Float => !from.is_real() && to.is_real(),
                Convert::Round | Convert::Cut => from.is_real() && !to.is_real(),
                Convert::Single => from.is_real() && to == Base::Real,
                Convert::Test => to == Base::Bool,
                Convert::Keep => from.is_real() == to.is_real() && from.is_text() == to.is_text(),
                Convert::Fit => !from.is_real() && to.is_date(),
                Convert::Wrap => !from.is_real() && !to.is_real(),
                Convert::Write => to.is_text(),
                Convert::Parse => from.is_text(),
                Convert::Raw => !from.is_real() && to == Base::Real,
                Convert::Bits | Convert::Day | Convert::Clock | Convert::Midnight => true,
            };
            if !fits {
                no("a conversion that does not fit");
            }
            expression(inner, tree, faults);
        }
        ExprKind::Unary(op, inner) => {
            if inner.base != expr.base || *op == Unary::Not && expr.base.is_real() {
                no("an operand of another type");
            }
            expression(inner, tree, faults);
        }
        ExprKind::Binary(op, a, b) => {
            use Binary::{
                DateMinusDate, DtMinusDt, DtMinusTime, DtPlusTime, Power, RotateLeft, RotateRight,
                ShiftLeft, ShiftRight, Subtract, TodMinusTime, TodPlusTime,
            };
            let fits = match op {
                ShiftLeft | ShiftRight | RotateLeft | RotateRight | Power => {
                    a.base == expr.base && matches!(b.base, Base::Dint | Base::Int)
                }
                DtPlusTime | DtMinusTime | TodPlusTime | TodMinusTime => {
                    a.base == expr.base && b.base == Base::Time
                }
                DtMinusDt | DateMinusDate => a.base == b.base && expr.base == Base::Time,
                Subtract if a.base == Base::Tod => b.base == Base::Tod && expr.base == Base::Time,
                _ => a.base == b.base && a.base == expr.base,
            };
            if !fits {
                no("operands of other types");
            }
            expression(a, tree, faults);
            expression(b, tree, faults);
        }
        ExprKind::Compare(_, a, b) => {
            let texts = a.base.is_text() && b.base.is_text();
            if a.base != b.base && !texts || expr.base != Base::Bool {
                no("a comparison of two types");
            }
            expression(a, tree, faults);
            expression(b, tree, faults);
        }
        ExprKind::Ordered(_, all) => {
            if all.iter().any(|one| one.base != all[0].base) || all.len() < 3 {
                no("a comparison of two types");
            }
            all.iter().for_each(|one| expression(one, tree, faults));
        }
        ExprKind::Select(parts) => {
            if parts[0].base != Base::Bool
                || parts[1].base != expr.base
                || parts[2].base != expr.base
            {
                no("a choice among types");
            }
            parts.iter().for_each(|one| expression(one, tree, faults));
        }
        ExprKind::Mux(which, all) => {
            if which.base != Base::Dint || all.iter().any(|one| one.base != expr.base) {
                no("a choice among types");
            }
            expression(which, tree, faults);
            all.iter().for_each(|one| expression(one, tree, faults));
        }
        ExprKind::Extra(extra, all) => {
            if matches!(extra, Extra::Sin | Extra::Power) && !expr.base.is_real() {
                no("a function of reals");
            }
            all.iter().for_each(|one| expression(one, tree, faults));
        }
        ExprKind::Call(of) => call(of, tree, faults),
    }
}

fn place(of: &Place, tree: &Tree, faults: &mut Vec<String>) {
    for index in &of.indices {
        if !index.subscript.base.is_int() || index.count == 0 || index.stride == 0 {
            faults.push(format!("a subscript: {index:?}"));
        }
        expression(&index.subscript, tree, faults);
    }
}

fn call(of: &Call, tree: &Tree, faults: &mut Vec<String>) {
    let Some(unit) = tree.units.get(of.unit as usize) else {
        faults.push(format!("no unit: {of:?}"));
        return;
    };
    if of.lent.len() as u32 != unit.references {
        faults.push(format!("{} places are lent: {of:?}", of.lent.len()));
    }
    of.lent
        .iter()
        .chain(&of.instance)
        .for_each(|one| place(one, tree, faults));
    for input in &of.inputs {
        match input {
            Input::Value(_, value, store) => stored(value, *store, tree, faults),
            Input::Cells(_, from, _) => place(from, tree, faults),
        }
    }
    of.outputs
        .iter()
        .for_each(|one| place(&one.to, tree, faults));
}

fn stored(value: &Expr, store: Store, tree: &Tree, faults: &mut Vec<String>) {
    let fits = match store {
        Store::Narrow(base) | Store::Within(base, ..) => value.base == base,
        Store::Text(_) => value.base.is_text(),
    };
    if !fits {
        faults.push(format!("stored as {store:?}: {value:?}"));
    }
    expression(value, tree, faults);
}

fn statements(all: &[Stmt], tree: &Tree, faults: &mut Vec<String>) {
    for one in all {
        match &one.kind {
            StmtKind::Assign(to, value, store) => {
                place(to, tree, faults);
                stored(value, *store, tree, faults);
            }
            StmtKind::Copy(to, from, _) => {
                place(to, tree, faults);
                place(from, tree, faults);
            }
            StmtKind::If(arms, otherwise) => {
                for (condition, body) in arms {
                    bit(condition, tree, faults);
                    statements(body, tree, faults);
                }
                statements(otherwise, tree, faults);
            }
            StmtKind::Case(selector, arms, otherwise) => {
                expression(selector, tree, faults);
                arms.iter().for_each(|arm| statements(&arm.1, tree, faults));
                statements(otherwise, tree, faults);
            }
            StmtKind::While(condition, body) | StmtKind::Repeat(body, condition) => {
                bit(condition, tree, faults);
                statements(body, tree, faults);
            }
            StmtKind::For(head) => {
                place(&head.variable, tree, faults);
                for expr in [&head.from, &head.to] {
                    expression(expr, tree, faults);
                    if expr.base != head.base {
                        faults.push(format!("FOR in two types: {expr:?}"));
                    }
                }
                expression(&head.step, tree, faults);
                statements(&head.body, tree, faults);
            }
            StmtKind::Call(of) => call(of, tree, faults),
            StmtKind::Standard(_, of) => place(of, tree, faults),
            StmtKind::Codes(codes) => {
                codes.before.iter().for_each(|of| bit(of, tree, faults));
                codes.behind.iter().for_each(|of| place(of, tree, faults));
            }
            StmtKind::Order(order, _, of) => {
                order
                    .value()
                    .into_iter()
                    .for_each(|of| expression(of, tree, faults));
                place(of, tree, faults);
            }
            StmtKind::Print(_, value) => expression(value, tree, faults),
            StmtKind::Jump(condition, _) => {
                condition
                    .iter()
                    .for_each(|condition| bit(condition, tree, faults));
            }
            StmtKind::Exit | StmtKind::Continue | StmtKind::Return => {}
        }
    }
}

fn bit(condition: &Expr, tree: &Tree, faults: &mut Vec<String>) {
    if condition.base != Base::Bool {
        faults.push(format!("a condition: {condition:?}"));
    }
    expression(condition, tree, faults);
}

/// What is wrong with a tree.
pub fn faults(tree: &Tree) -> Vec<String> {
    let mut faults = Vec::new();
    for unit in &tree.units {
        statements(&unit.body, tree, &mut faults);
    }
    let cells = tree
        .units
        .iter()
        .flat_map(|unit| unit.own.iter().chain(&unit.locals));
    for cell in cells.chain(&tree.cells) {
        let reals = matches!(cell.initial, unoclp_lang::typed::Value::Real(_));
        if reals != cell.base.is_real() || cell.base.is_any() {
            faults.push(format!("a cell: {cell:?}"));
        }
    }
    faults
}

#[test]
fn the_trees_of_all_cases_are_settled() {
    let mut trees = BTreeMap::new();
    for (file, case) in typed::all() {
        let (text, language) = case.text().expect("one text");
        if let Some(tree) = check(text, language, unoclp_core::Board::UNO).tree {
            assert_eq!(faults(&tree), [""; 0], "{file}: {}\n{text}", case.name);
            *trees.entry(language.name()).or_insert(0) += 1;
        }
    }
    assert!(trees.len() == 5 && trees["st"] > 100, "{trees:?}");
}
