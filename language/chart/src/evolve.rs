//! From one situation to the next: transitions as statements.
//!
//! Owns that all of them are judged on the steps as they were when the scan began.

use crate::cells::{Cells, TIME, passing};
use crate::control::EDGE_Q;
use crate::net::Net;
use crate::order::order;
use crate::touched::places_of;
use crate::write::{
    assign, bit, both, call, joined, not, now, output, part, read, time, truth, when,
};
use std::collections::{BTreeSet, HashMap, HashSet};
use unoclp_tree::build::{Builder, Section, Traits};
use unoclp_tree::{Base, Binary, Compare, Expr, ExprKind, Place, Root, Standard, Stmt, TypeId};

/// The statements that judge the transitions, by their conditions. The steps that are given measure their time.
pub(crate) fn evolve(
    net: &Net,
    cells: &Cells,
    mut conditions: Vec<Option<Expr>>,
    timed: &BTreeSet<u32>,
    builder: &mut Builder<'_, '_>,
) -> Vec<Stmt> {
    let mut all = clocks(net, cells, timed, builder);
    pictures(net, cells, &mut conditions, builder, &mut all);
    let held = holds(net, builder, &mut all);
    let order = order(net);
    let mut then = Vec::new();
    for turn in order.turns {
        let arc = &net.transitions[turn as usize];
        let Some(condition) = conditions.get_mut(turn as usize).and_then(Option::take) else {
            continue;
        };
        let at = arc.at;
        let place = |step: &u32| &cells.steps[*step as usize];
        let active = arc.from.iter().map(|step| bit(place(step), at));
        let free = arc.from.iter().filter_map(|step| held.get(step));
        let free = free.map(|held| not(bit(held, at)));
        let Some(ready) = joined(Binary::And, active.chain(free).chain([condition])) else {
            continue;
        };
        let leaves = arc.leaves.iter();
        let leaves = leaves.map(|step| assign(part(place(step), 0, at), truth(false, at)));
        let stays = arc.from.iter().filter_map(|step| held.get(step));
        let stays = stays.filter(|_| arc.leaves.len() < arc.from.len());
        let stays = stays.map(|held| assign(part(held, 0, at), truth(true, at)));
        let enters = arc.enters.iter();
        let enters = enters.map(|step| assign(part(place(step), 0, at), truth(true, at)));
        let mut fires: Vec<Stmt> = leaves.chain(stays).collect();
        if !order.late[turn as usize] {
            fires.extend(enters);
            if !fires.is_empty() {
                all.push(when(ready, fires, at));
            }
            continue;
        }
        let fired = passing(builder, &format!("#fires{turn}"), at);
        all.push(assign(part(&fired, 0, at), ready));
        if !fires.is_empty() {
            all.push(when(bit(&fired, at), fires, at));
        }
        then.push(when(bit(&fired, at), enters.collect(), at));
    }
    all.extend(then);
    for &step in timed {
        let (at, rises) = (
            net.steps[step as usize].name.at,
            &cells.rises[step as usize],
        );
        let active = &cells.steps[step as usize];
        all.extend(call(Standard::RTrig, rises, vec![(0, bit(active, at))], at));
        let begins = assign(part(active, TIME, at), time(0, at));
        all.push(when(output(rises, EDGE_Q, at), vec![begins], at));
    }
    all
}

/// The time of steps goes on.
fn clocks(
    net: &Net,
    cells: &Cells,
    timed: &BTreeSet<u32>,
    builder: &mut Builder<'_, '_>,
) -> Vec<Stmt> {
    let mut all = Vec::new();
    let Some(first) = timed.first() else {
        return all;
    };
    let at = net.steps[*first as usize].name.at;
    let traits = Traits {
        unseen: true,
        ..Traits::default()
    };
    let ty = TypeId::of(Base::Time);
    let Some(passed) = builder.declare("#passed", at, ty, Section::Temp, traits) else {
        return all;
    };
    let passed = passed.place(at);
    if timed.iter().any(|step| net.steps[*step as usize].initial) {
        // Its time begins with the first scan.
        let begins = vec![
            assign(part(&cells.before, 0, at), now(at)),
            assign(part(&cells.begun, 0, at), truth(true, at)),
        ];
        all.push(when(not(bit(&cells.begun, at)), begins, at));
    }
    let before = read(part(&cells.before, 0, at), Base::Time);
    all.push(assign(
        part(&passed, 0, at),
        both(Binary::Subtract, now(at), before),
    ));
    all.push(assign(part(&cells.before, 0, at), now(at)));
    for &step in timed {
        let at = net.steps[step as usize].name.at;
        let active = &cells.steps[step as usize];
        let t = part(active, TIME, at);
        let more = both(
            Binary::Add,
            read(t.clone(), Base::Time),
            read(part(&passed, 0, at), Base::Time),
        );
        // It stays at the longest time.
        let kind = ExprKind::Compare(
            Compare::GreaterEqual,
            Box::new(more.clone()),
            Box::new(time(0, at)),
        );
        let fits = Expr {
            kind,
            base: Base::Bool,
            ty: TypeId::BOOL,
            at,
        };
        let goes = both(Binary::And, bit(active, at), fits);
        all.push(when(goes, vec![assign(t, more)], at));
    }
    all
}

/// What a condition says of a step that its transition does not leave is asked of the step as it was.
fn pictures(
    net: &Net,
    cells: &Cells,
    conditions: &mut [Option<Expr>],
    builder: &mut Builder<'_, '_>,
    all: &mut Vec<Stmt>,
) {
    let steps = (0_u32..).zip(&cells.steps);
    let steps: HashMap<(Root, u32), u32> = steps
        .map(|(step, place)| ((place.root, place.offset), step))
        .collect();
    let mut pictures: HashMap<u32, Place> = HashMap::new();
    for (arc, condition) in net.transitions.iter().zip(conditions) {
        let Some(condition) = condition else { continue };
        let own: HashSet<u32> = arc.from.iter().copied().collect();
        places_of(condition, &mut |place| {
            let Some(&step) = steps.get(&(place.root, place.offset)) else {
                return;
            };
            if own.contains(&step) {
                return;
            }
            let (of, at) = (&cells.steps[step as usize], place.at);
            let picture = pictures.entry(step).or_insert_with(|| {
                let picture = passing(builder, &format!("#was{step}"), at);
                all.push(assign(part(&picture, 0, at), bit(of, at)));
                picture
            });
            *place = part(picture, 0, at);
        });
    }
}

/// For each step that a transition leaves and enters, before another that leaves it: that one of them has fired.
fn holds(net: &Net, builder: &mut Builder<'_, '_>, all: &mut Vec<Stmt>) -> HashMap<u32, Place> {
    let mut held = HashMap::new();
    for (number, step) in (0..).zip(&net.steps) {
        let but_last = step.leave.split_last().map_or(&[][..], |(_, all)| all);
        let stays = |turn: &&u32| {
            let arc = &net.transitions[**turn as usize];
            arc.leaves.len() < arc.from.len() && !arc.leaves.contains(&number)
        };
        if let Some(turn) = but_last.iter().find(stays) {
            let at = net.transitions[*turn as usize].at;
            let place = passing(builder, &format!("#holds{number}"), at);
            all.push(assign(part(&place, 0, at), truth(false, at)));
            held.insert(number, place);
        }
    }
    held
}
