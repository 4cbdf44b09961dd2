//! EN and ENO of a call (IEC 61131-3, 2.5.1.2): the call is made where EN is TRUE, and ENO tells whether it was.

use super::super::ast::{Arg, Node, NodeKind, Path, Statement, StatementKind};
use super::Parser;

/// What a call says of EN and ENO.
pub(super) type Enable = (Option<Node>, Option<Path>);

impl Parser<'_, '_> {
    /// Takes EN and ENO out of what a call gives; none where neither stands there, or a unit has such parameters of its own.
    pub(super) fn enable(&self, arguments: &mut Vec<Arg>) -> Option<Enable> {
        if self.declares_en || self.list {
            return None;
        }
        let en = take(arguments, |arg| is_named(arg, "EN") && !arg.out);
        let eno = take(arguments, |arg| {
            is_named(arg, "ENO") && arg.out && matches!(arg.node.kind, NodeKind::Path(_))
        });
        let eno = match eno.map(|arg| arg.node.kind) {
            Some(NodeKind::Path(path)) => Some(path),
            _ => None,
        };
        let en = en.map(|arg| arg.node);
        (en.is_some() || eno.is_some()).then_some((en, eno))
    }
}

fn is_named(arg: &Arg, name: &str) -> bool {
    let named = arg.name.as_ref();
    named.is_some_and(|named| named.text.eq_ignore_ascii_case(name))
}

/// The first such argument.
fn take(arguments: &mut Vec<Arg>, is: impl Fn(&Arg) -> bool) -> Option<Arg> {
    let at = arguments.iter().position(&is)?;
    Some(arguments.remove(at))
}

/// The statement, done where EN is TRUE.
pub(super) fn enabled(enable: Option<Enable>, statement: Statement) -> Statement {
    match enable {
        Some((en, eno)) => Statement {
            span: statement.span,
            kind: StatementKind::Enabled(en, eno, Box::new(statement)),
        },
        None => statement,
    }
}
