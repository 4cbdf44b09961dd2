//! In which order transitions are judged, so that each finds the steps as they were when the scan began.
//!
//! Owns that most of them can change the steps at once: one that leaves a step is judged before those that enter it, and of
//! those that share a step the first one goes first. In a circle one of them enters its steps after all others.

use crate::net::Net;

/// An order of the transitions, and which of them enter their steps after all others.
pub(crate) struct Order {
    pub turns: Vec<u32>,
    pub late: Vec<bool>,
}

/// The order in which the transitions of a net are judged.
pub(crate) fn order(net: &Net) -> Order {
    let count = net.transitions.len();
    let mut late = backwards(net);
    // Of each transition: for how many others and steps it waits; of each step: for how many transitions.
    let mut waits = vec![0_usize; count];
    let mut leaving: Vec<usize> = net.steps.iter().map(|step| step.leave.len()).collect();
    let mut enter: Vec<Vec<u32>> = vec![Vec::new(); net.steps.len()];
    for (turn, arc) in (0..).zip(&net.transitions) {
        for &step in arc.enters.iter().filter(|_| !late[turn as usize]) {
            enter[step as usize].push(turn);
            waits[turn as usize] += usize::from(leaving[step as usize] > 0);
        }
    }
    let mut after: Vec<Vec<u32>> = vec![Vec::new(); count];
    for step in &net.steps {
        for pair in step.leave.windows(2) {
            after[pair[0] as usize].push(pair[1]);
            waits[pair[1] as usize] += 1;
        }
    }
    let ready = net.turns.iter().copied();
    let mut ready: Vec<u32> = ready.filter(|turn| waits[*turn as usize] == 0).collect();
    ready.reverse();
    let mut done = vec![false; count];
    let mut turns = Vec::with_capacity(count);
    let mut first = net.turns.iter().copied();
    loop {
        let turn = match ready.pop() {
            Some(turn) => turn,
            // All wait: the first one enters its steps later, for which alone it waits.
            None => match first.find(|turn| !done[*turn as usize]) {
                Some(turn) => {
                    late[turn as usize] = true;
                    turn
                }
                None => break,
            },
        };
        if std::mem::replace(&mut done[turn as usize], true) {
            continue;
        }
        turns.push(turn);
        let mut free = |turn: u32| {
            let waits = &mut waits[turn as usize];
            *waits = waits.saturating_sub(1);
            if *waits == 0 && !done[turn as usize] {
                ready.push(turn);
            }
        };
        after[turn as usize].iter().copied().for_each(&mut free);
        for &step in &net.transitions[turn as usize].from {
            leaving[step as usize] -= 1;
            if leaving[step as usize] == 0 {
                enter[step as usize].iter().copied().for_each(&mut free);
            }
        }
    }
    Order { turns, late }
}

/// The transitions that lead back to a step on the way to them.
fn backwards(net: &Net) -> Vec<bool> {
    let mut back = vec![false; net.transitions.len()];
    // 0: not seen, 1: on the way, 2: done.
    let mut state = vec![0_u8; net.steps.len()];
    let initial = (0..net.steps.len()).filter(|step| net.steps[*step].initial);
    let all: Vec<usize> = initial.chain(0..net.steps.len()).collect();
    for first in all {
        if state[first] != 0 {
            continue;
        }
        state[first] = 1;
        // A step, and how far its transitions and their steps have been followed.
        let mut way = vec![(first, 0_usize, 0_usize)];
        while let Some((step, nth, end)) = way.pop() {
            let Some(&turn) = net.steps[step].leave.get(nth) else {
                state[step] = 2;
                continue;
            };
            let Some(&to) = net.transitions[turn as usize].enters.get(end) else {
                way.push((step, nth + 1, 0));
                continue;
            };
            way.push((step, nth, end + 1));
            match state[to as usize] {
                0 => {
                    state[to as usize] = 1;
                    way.push((to as usize, 0, 0));
                }
                1 => back[turn as usize] = true,
                _ => {}
            }
        }
    }
    back
}
