//! What is done after the transitions: the actions of the steps that are active.
//!
//! Owns that an action whose cause has gone is done once more, before those that go on, and that a variable takes its Q.

use crate::cells::Cells;
use crate::control::{EDGE_Q, Times, When, control, is_bit};
use crate::net::Net;
use crate::touched::{Touched, together};
use crate::write::{assign, bit, both, call, joined, not, output, part, truth, when};
use unoclp_tree::build::Builder;
use unoclp_tree::{Binary, Expr, Standard, Stmt};

/// An action with a body.
struct Done {
    number: usize,
    body: Vec<Stmt>,
    /// That it is done now; the edges that this takes.
    edges: Vec<Stmt>,
    runs: Vec<Expr>,
    /// While this holds it goes on.
    lasts: Option<Expr>,
    /// That it is done because of an edge.
    pulse: Option<Expr>,
    touched: Touched,
}

/// The statements that do actions.
pub(crate) fn actions(
    net: &Net,
    cells: &Cells,
    times: &Times,
    mut bodies: Vec<Vec<Stmt>>,
    builder: &mut Builder<'_, '_>,
) -> Vec<Stmt> {
    let mut all = Vec::new();
    let mut done: Vec<Done> = Vec::new();
    for (number, of) in net.actions.iter().enumerate() {
        let own = &cells.actions[number];
        let When {
            before,
            lasts,
            pulses,
            keeps,
        } = control(of, own, cells, times, builder);
        all.extend(before);
        let at = of.name.at;
        let (mut edges, mut with, mut without) = (Vec::new(), Vec::new(), Vec::new());
        for (calls, q, is_q) in pulses {
            edges.extend(calls);
            if is_q { &mut with } else { &mut without }.push(q);
        }
        let Some(body) = of.body else {
            let causes = lasts.into_iter().chain(with).chain(without);
            if !keeps {
                all.extend(edges);
                let q = joined(Binary::Or, causes).unwrap_or_else(|| truth(false, at));
                all.push(assign(part(&own.q, 0, at), q));
            }
            continue;
        };
        let body = bodies.get_mut(body).map(std::mem::take).unwrap_or_default();
        let mut touched = Touched::default();
        touched.stmts(&body, builder);
        let q = (own.q.root, own.q.offset);
        let mut lasts = lasts;
        // The edges are asked here where Q says what they say.
        let is_read = touched.cells.contains_key(&q);
        if is_read {
            all.append(&mut edges);
            let causes = lasts.clone().into_iter().chain(with.clone());
            let value = joined(Binary::Or, causes).unwrap_or_else(|| truth(false, at));
            all.push(assign(part(&own.q, 0, at), value));
            if with.is_empty() && lasts.is_some() {
                lasts = Some(bit(&own.q, at));
            }
        } else if let Some(one) = lasts.as_ref().filter(|one| !is_bit(one)) {
            all.push(assign(part(&own.q, 0, at), one.clone()));
            lasts = Some(bit(&own.q, at));
        }
        let pulses: Vec<Expr> = with.into_iter().chain(without).collect();
        done.push(Done {
            number,
            body,
            edges,
            runs: lasts.clone().into_iter().chain(pulses.clone()).collect(),
            lasts,
            pulse: joined(Binary::Or, pulses),
            touched,
        });
    }
    let touched: Vec<Touched> = done
        .iter_mut()
        .map(|one| std::mem::take(&mut one.touched))
        .collect();
    let together = together(&touched);
    let ends = |one: &Done| {
        let (own, at) = (&cells.actions[one.number], net.actions[one.number].name.at);
        let lasts = one.lasts.clone()?;
        let calls = call(Standard::FTrig, &own.ends, vec![(0, lasts)], at);
        Some((calls, output(&own.ends, EDGE_Q, at)))
    };
    for (one, _) in done.iter_mut().zip(&together).filter(|(_, is)| **is) {
        let at = net.actions[one.number].name.at;
        if let Some((calls, over)) = ends(one) {
            all.append(&mut one.edges);
            all.extend(calls);
            let over = match &one.pulse {
                Some(pulse) => both(Binary::And, over, not(pulse.clone())),
                None => over,
            };
            all.push(when(over, one.body.clone(), at));
        }
    }
    for (one, apart) in done.into_iter().zip(together) {
        let at = net.actions[one.number].name.at;
        all.extend(one.edges.iter().cloned());
        let mut runs = one.runs.clone();
        if let Some((calls, over)) = ends(&one).filter(|_| !apart) {
            all.extend(calls);
            runs.insert(0, over);
        }
        if let Some(runs) = joined(Binary::Or, runs) {
            all.push(when(runs, one.body, at));
        }
    }
    all
}
