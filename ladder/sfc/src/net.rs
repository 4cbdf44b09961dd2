//! The names of a chart as numbers, and which transitions lead back.

use crate::document::{Document, key};
use std::collections::{HashMap, HashSet};

/// Which steps and transitions of a chart follow each other.
pub(crate) struct Net {
    /// Of each step, the transitions that leave it.
    pub leave: Vec<Vec<usize>>,
    /// Of each transition, the steps that it leaves.
    pub from: Vec<Vec<usize>>,
    /// Of each transition, the steps that it enters: none where no step has that name.
    pub to: Vec<Vec<Option<usize>>>,
    /// Of each step, how many transitions lead to it that do not lead back.
    pub enter: Vec<usize>,
    /// The transitions and steps that lead back: to a step from which the way has come.
    pub back: HashSet<(usize, usize)>,
}

impl Net {
    pub(crate) fn of(document: &Document) -> Net {
        let mut numbers: HashMap<String, usize> = HashMap::new();
        for (number, step) in document.steps.iter().enumerate() {
            numbers.entry(key(&step.name)).or_insert(number);
        }
        let mut net = Net {
            leave: vec![Vec::new(); document.steps.len()],
            from: Vec::with_capacity(document.transitions.len()),
            to: Vec::with_capacity(document.transitions.len()),
            enter: vec![0; document.steps.len()],
            back: HashSet::new(),
        };
        for (number, transition) in document.transitions.iter().enumerate() {
            let mut from: Vec<usize> = Vec::new();
            let mut known = HashSet::new();
            for name in &transition.from {
                let step = numbers.get(&key(name)).copied();
                from.extend(step.filter(|step| known.insert(*step)));
            }
            for step in &from {
                net.leave[*step].push(number);
            }
            let to = transition.to.iter();
            let to = to.map(|name| numbers.get(&key(name)).copied());
            net.to.push(to.collect());
            net.from.push(from);
        }
        net.look(document);
        net
    }

    /// Finds what leads back, and counts what does not.
    fn look(&mut self, document: &Document) {
        let count = document.steps.len();
        let initial = (0..count).filter(|step| document.steps[*step].initial);
        let starts: Vec<usize> = initial.chain(0..count).collect();
        // 0: not seen; 1: on the way; 2: done.
        let mut seen = vec![0_u8; count];
        let mut passed = vec![false; self.to.len()];
        for start in starts {
            if seen[start] != 0 {
                continue;
            }
            seen[start] = 1;
            // A step, and which of its transitions and of their steps comes next.
            let mut way = vec![(start, 0, 0)];
            while let Some((step, leave, to)) = way.last_mut() {
                let Some(&transition) = self.leave[*step].get(*leave) else {
                    seen[*step] = 2;
                    way.pop();
                    continue;
                };
                if *to == 0 && std::mem::replace(&mut passed[transition], true) {
                    *leave += 1;
                    continue;
                }
                let Some(next) = self.to[transition].get(*to).copied() else {
                    (*leave, *to) = (*leave + 1, 0);
                    continue;
                };
                *to += 1;
                let Some(next) = next else { continue };
                match seen[next] {
                    0 => {
                        seen[next] = 1;
                        way.push((next, 0, 0));
                    }
                    1 => drop(self.back.insert((transition, next))),
                    _ => {}
                }
            }
        }
        for (number, to) in self.to.iter().enumerate() {
            for step in to.iter().flatten() {
                self.enter[*step] += usize::from(!self.back.contains(&(number, *step)));
            }
        }
    }
}
