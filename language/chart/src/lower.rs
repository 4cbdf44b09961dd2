//! A chart as statements of its unit.

use crate::actions::actions;
use crate::cells::{Cells, TIME};
use crate::control::Times;
use crate::evolve::evolve;
use crate::net::Net;
use crate::touched::Touched;
use std::collections::BTreeSet;
use unoclp_tree::build::Builder;
use unoclp_tree::{Expr, Stmt};

/// What the conditions, times and bodies of a chart have come to.
#[derive(Debug, Default)]
pub struct Parts {
    /// Of each transition, a BOOL; none of one that is wrong.
    pub conditions: Vec<Option<Expr>>,
    /// A TIME each, by the step and the number of the action there.
    pub times: Times,
    /// Of each action of the chart.
    pub bodies: Vec<Vec<Stmt>>,
}

/// The statements of a chart, in the unit that the builder is in.
pub fn lower(net: &Net, cells: &Cells, parts: Parts, builder: &mut Builder<'_, '_>) -> Vec<Stmt> {
    let mut touched = Touched::default();
    let conditions = parts.conditions.iter().flatten();
    for expr in conditions.chain(parts.times.values()) {
        touched.expr(expr, builder);
    }
    for body in &parts.bodies {
        touched.stmts(body, builder);
    }
    let steps = (0..).zip(&cells.steps);
    let asked = steps.filter(|(_, step)| {
        let time = (step.root, step.offset + TIME);
        touched.cells.contains_key(&time)
    });
    let timed: BTreeSet<u32> = asked.map(|(step, _)| step).collect();
    builder.may_do_nothing();
    let mut all = evolve(net, cells, parts.conditions, &timed, builder);
    all.extend(actions(net, cells, &parts.times, parts.bodies, builder));
    all
}
