//! What the board lacks: types that are declared, and what expressions come to, wherever they stand.
//!
//! Owns that one rule: it looks at each declaration and each expression of all units that run, before anything is put in
//! the place of anything else. Must not know cells and registers.

use super::pure::{calls, expressions, given, within};
use std::collections::HashMap;
use unoclp_text::diagnostics::{Code, Found, Span, Word};
use unoclp_tree::{Base, Expr, ExprKind, Extra, Kind, Stmt, StmtKind, Tree, TypeId, Types};

/// Tells what the board lacks; whether there is any of it.
pub(super) fn told(tree: &Tree, found: &mut Found) -> bool {
    let runs = running(tree);
    types(tree, &runs, found);
    if !found.has_errors() {
        for (unit, _) in tree.units.iter().zip(&runs).filter(|(_, runs)| **runs) {
            statements(&unit.body, found);
        }
    }
    found.has_errors()
}

/// Of each unit, whether a program comes to it.
fn running(tree: &Tree) -> Vec<bool> {
    let mut runs = vec![false; tree.units.len()];
    let mut ahead = tree.programs.clone();
    while let Some(number) = ahead.pop() {
        let (Some(unit), Some(seen)) = (
            tree.units.get(number as usize),
            runs.get_mut(number as usize),
        ) else {
            continue;
        };
        if !std::mem::replace(seen, true) {
            called(&unit.body, &mut ahead);
        }
    }
    runs
}

fn called(body: &[Stmt], into: &mut Vec<u32>) {
    for statement in body {
        into.extend(calls(statement).into_iter().map(|call| call.unit));
        for inner in within(statement) {
            called(std::slice::from_ref(inner), into);
        }
    }
}

/// Variables of types that the board lacks, used or not.
fn types(tree: &Tree, runs: &[bool], found: &mut Found) {
    let mut known = HashMap::new();
    for declared in &tree.declared {
        let unit = declared.unit.map(|unit| unit as usize);
        if unit.is_some_and(|unit| runs.get(unit) == Some(&false)) {
            continue;
        }
        if let Some((part, base)) = lacking(&tree.types, declared.ty, &mut known) {
            let name = format!("{}{part}", declared.name);
            let words = [name.into(), base.name().into(), instead(base).into()];
            found.tell(Code::BoardType, declared.at, words);
        }
    }
}

/// A part of a type, by its members.
type Part = Option<(String, Base)>;

/// The first part of a type that the board lacks. What an instance has is declared in its block.
fn lacking(types: &Types, ty: TypeId, known: &mut HashMap<TypeId, Part>) -> Part {
    if let Some(part) = known.get(&ty) {
        return part.clone();
    }
    let part = match types.kind(ty) {
        Kind::Base(base) | Kind::Text { base, .. } | Kind::Range { base, .. } => {
            (!base.is_on_board()).then(|| (String::new(), *base))
        }
        Kind::Array { of, .. } => lacking(types, *of, known).map(|(_, base)| (String::new(), base)),
        Kind::Struct(members) => members.iter().find_map(|member| {
            let (part, base) = lacking(types, member.ty, known)?;
            Some((format!(".{}{part}", member.name), base))
        }),
        Kind::Enum(_) | Kind::Standard(_) | Kind::Block(_) => None,
    };
    known.insert(ty, part.clone());
    part
}

fn statements(body: &[Stmt], found: &mut Found) {
    for statement in body {
        // PRINT takes no code.
        if !matches!(statement.kind, StmtKind::Print(..)) {
            for one in expressions(statement) {
                expression(one, found);
            }
        }
        for inner in within(statement) {
            statements(std::slice::from_ref(inner), found);
        }
    }
}

/// Tells the outermost that the board lacks: one for each.
fn expression(expr: &Expr, found: &mut Found) {
    let base = expr.base;
    if let ExprKind::Extra(function, _) = expr.kind {
        return lacking_function(function, expr.at, found);
    }
    if !base.is_on_board() && !base.is_any() {
        let name = base.name();
        let words = [(name, name).into(), instead(base).into()];
        return found.tell(Code::BoardLacks, expr.at, words);
    }
    let parts = match &expr.kind {
        ExprKind::Call(call) => given(call),
        _ => super::flat::parts(expr),
    };
    for part in parts {
        expression(part, found);
    }
}

fn lacking_function(function: Extra, at: Span, found: &mut Found) {
    let what = match function {
        Extra::Power => Word::from((
            "a power with a REAL exponent",
            "uma potência com expoente REAL",
        )),
        _ => format!("{function:?}").to_uppercase().into(),
    };
    let is_text = matches!(function, Extra::Len | Extra::Find);
    let instead = match is_text {
        true => instead(Base::Str),
        false => (
            "it runs only on a PC, with unoclp run; on the board use a table of values or a linear interpolation between two points",
            "só roda no PC, com unoclp run; na placa, use uma tabela de valores ou uma interpolação linear entre dois pontos",
        ),
    };
    found.tell(Code::BoardLacks, at, [what, instead.into()]);
}

/// What to take in place of a type that the board lacks.
fn instead(base: Base) -> (&'static str, &'static str) {
    match base {
        Base::Lreal => ("use REAL", "use REAL"),
        Base::Lint => ("use DINT", "use DINT"),
        Base::Ulint => ("use UDINT", "use UDINT"),
        Base::Lword => ("use DWORD", "use DWORD"),
        _ => (
            "use numbers instead of strings, for example the values of an enumeration",
            "use números em vez de strings, por exemplo os valores de uma enumeração",
        ),
    }
}
