//! A condition alone: an expression over names that somebody else gives, as a member of what has it is written: `tank.level`.

use super::super::ast::{File, Name, Node, NodeKind, Part, Path};
use super::Checker;
use std::collections::HashMap;
use unoclp_core::Board;
use unoclp_text::diagnostics::{Found, Span};
use unoclp_tree::build::{Builder, Letters, Section, Traits};
use unoclp_tree::{Base, Tree, TypeId, UnitKind};

/// What the condition comes to; no name of a text can be this.
const RESULT: &str = "#";

/// A condition: its tree, the names that it reads with the cell of each, and the cell of what it comes to.
pub(crate) type Asked = (Tree, Vec<(usize, u32)>, u32);

/// Checks a condition over these names.
pub(in super::super) fn condition(
    text: &str,
    mut node: Node,
    names: &[(String, Base)],
    board: Board,
    found: &mut Found,
) -> Option<Asked> {
    let numbers = names.iter().enumerate();
    let numbers: HashMap<String, usize> = numbers
        .map(|(number, (name, _))| (name.to_uppercase(), number))
        .collect();
    let mut used = Vec::new();
    join(&mut node, &numbers, &mut used);
    used.sort_unstable();
    used.dedup();
    let file = File::default();
    let mut builder = Builder::new(text, Letters::Alike, board, found);
    let at = Span::default();
    let unit = builder.unit("", UnitKind::Program, at);
    let before = builder.enter(&unit);
    let traits = || Traits {
        unseen: true,
        ..Traits::default()
    };
    let mut cells = Vec::new();
    for (number, (name, base)) in names.iter().enumerate() {
        let variable = builder.declare(name, at, TypeId::of(*base), Section::Var, traits())?;
        if used.binary_search(&number).is_ok() {
            cells.push((number, variable.offset));
        }
    }
    let result = builder.declare(RESULT, at, TypeId::of(Base::Bool), Section::Var, traits())?;
    let unit = builder.close(unit);
    let mut checker = Checker::new(builder, &file);
    let value = checker.expr(&node, None);
    let value = checker.builder.condition(value);
    let target = checker.builder.name(RESULT, at)?;
    let statement = checker.builder.assign(target, value, node.span);
    checker
        .builder
        .body(unit, statement.into_iter().collect::<Vec<_>>());
    checker.builder.back(before);
    let tree = checker.builder.finish()?;
    Some((tree, cells, result.offset))
}

/// Makes one name of each name with members that is given as one, and notes which are read.
fn join(node: &mut Node, numbers: &HashMap<String, usize>, used: &mut Vec<usize>) {
    match &mut node.kind {
        NodeKind::Literal(..) | NodeKind::Member(..) | NodeKind::Wrong => {}
        NodeKind::Path(path) => {
            join_path(path);
            used.extend(numbers.get(&path.name.text.to_uppercase()));
            for part in &mut path.parts {
                if let Part::Subscripts(nodes, _) = part {
                    nodes.iter_mut().for_each(|node| join(node, numbers, used));
                }
            }
        }
        NodeKind::Call(_, arguments) => {
            for argument in arguments {
                join(&mut argument.node, numbers, used);
            }
        }
        NodeKind::Negate(inner) | NodeKind::Not(inner) => join(inner, numbers, used),
        NodeKind::Binary(_, a, b) => {
            join(a, numbers, used);
            join(b, numbers, used);
        }
    }
}

fn join_path(path: &mut Path) {
    let mut text = path.name.text.clone();
    for part in &path.parts {
        let Part::Member(Name { text: member, .. }) = part else {
            return;
        };
        text.push('.');
        text.push_str(member);
    }
    path.name = Name {
        text,
        span: path.span,
    };
    path.parts.clear();
}
