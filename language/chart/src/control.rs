//! When an action is done, as the standard's ACTION_CONTROL says (2.6.4.5).
//!
//! Owns what each qualifier means. Must not know what an action does.

use crate::Qualifier;
use crate::cells::{Cells, OfAction, passing};
use crate::net::{Cause, Control};
use crate::write::{assign, bit, both, call, joined, not, output, part, puts};
use std::collections::HashMap;
use unoclp_tree::build::Builder;
use unoclp_tree::{Base, Binary, Expr, ExprKind, Standard, Stmt};

/// Q of a timer and of an edge.
const TIMER_Q: u32 = 2;
pub(crate) const EDGE_Q: u32 = 1;

/// The times of the steps' actions, by the step and the number of the action there.
pub type Times = HashMap<(u32, usize), Expr>;

/// When an action is done.
pub(crate) struct When {
    /// What stores and times it, before anything is done.
    pub before: Vec<Stmt>,
    /// While this holds; none: for pulses alone.
    pub lasts: Option<Expr>,
    /// The edges for which it is done, with Q or without.
    pub pulses: Vec<(Vec<Stmt>, Expr, bool)>,
    /// A variable that is only set and reset keeps itself.
    pub keeps: bool,
}

fn active(cells: &Cells, cause: &Cause) -> Expr {
    bit(&cells.steps[cause.step as usize], cause.at)
}

/// When an action is done.
pub(crate) fn control(
    control: &Control,
    own: &OfAction,
    cells: &Cells,
    times: &Times,
    builder: &mut Builder<'_, '_>,
) -> When {
    use Qualifier::*;
    let is = |cause: &&Cause, qualifier| cause.qualifier == qualifier;
    let resets = control.does.iter().filter(|cause| is(cause, R));
    let mut reset = joined(Binary::Or, resets.map(|cause| active(cells, cause)));
    let keeps = control.body.is_none()
        && control
            .does
            .iter()
            .all(|cause| matches!(cause.qualifier, S | R));
    let stored = if keeps { &own.q } else { &own.stored };
    let mut when = When {
        before: Vec::new(),
        lasts: None,
        pulses: Vec::new(),
        keeps,
    };
    if let Some(all) = reset.take_if(|reset| !is_bit(reset)) {
        let at = control.name.at;
        let once = passing(builder, &format!("#{}.R", control.name.text), at);
        when.before.push(assign(part(&once, 0, at), all));
        reset = Some(bit(&once, at));
    }
    let mut lasts: Vec<Expr> = Vec::new();
    let mut is_stored = false;
    for (cause, of) in control.does.iter().zip(&own.causes) {
        let at = cause.at;
        let x = active(cells, cause);
        let timer = |on: Expr| {
            let time = times.get(&(cause.step, cause.nth)).cloned();
            let inputs = [(0, on)].into_iter().chain(time.map(|time| (1, time)));
            call(Standard::Ton, &of.block, inputs.collect(), at)
        };
        let over = || output(&of.block, TIMER_Q, at);
        let sets = |on: Expr| puts(on, &of.stored, true, at);
        let ends = || {
            reset
                .clone()
                .map(|reset| puts(reset, &of.stored, false, at))
        };
        let held = || bit(&of.stored, at);
        match cause.qualifier {
            N => lasts.push(x),
            R => {}
            S => {
                when.before.push(puts(x, stored, true, at));
                is_stored = true;
            }
            L => {
                when.before.extend(timer(x.clone()));
                lasts.push(both(Binary::And, x, not(over())));
            }
            D => {
                when.before.extend(timer(x));
                lasts.push(over());
            }
            SD => {
                when.before.extend([sets(x)].into_iter().chain(ends()));
                when.before.extend(timer(held()));
                lasts.push(over());
            }
            DS => {
                when.before.extend(timer(x));
                when.before.extend([sets(over())].into_iter().chain(ends()));
                lasts.push(held());
            }
            SL => {
                when.before.extend([sets(x)].into_iter().chain(ends()));
                when.before.extend(timer(held()));
                lasts.push(both(Binary::And, held(), not(over())));
            }
            P | P1 | P0 => {
                let edge = match cause.qualifier {
                    P0 => Standard::FTrig,
                    _ => Standard::RTrig,
                };
                let calls = call(edge, &of.block, vec![(0, x)], at).collect();
                let q = output(&of.block, EDGE_Q, at);
                let q = match (&reset, cause.qualifier) {
                    (Some(reset), P) => both(Binary::And, q, not(reset.clone())),
                    _ => q,
                };
                when.pulses.push((calls, q, cause.qualifier == P));
            }
        }
    }
    let at = control.name.at;
    if is_stored || keeps {
        let ends = reset.clone().map(|reset| puts(reset, stored, false, at));
        when.before.extend(ends);
    }
    if is_stored && !keeps {
        lasts.push(bit(stored, at));
    }
    let lasts = joined(Binary::Or, lasts);
    when.lasts = match (lasts, reset) {
        // A bit that is stored has been reset.
        (Some(lasts), Some(reset)) if !(is_stored && is_bit(&lasts)) => {
            Some(both(Binary::And, lasts, not(reset)))
        }
        (lasts, _) => lasts,
    };
    when
}

/// Whether an expression is one bit.
pub(crate) fn is_bit(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Read(place) if place.indices.is_empty())
        && expr.base == Base::Bool
}
