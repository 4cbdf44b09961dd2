//! The situations that a chart can come to: which steps are active at once, whatever its conditions are.
//!
//! Owns what is told of a net whose tokens are lost, doubled or stuck. A chart whose transitions each leave one step and
//! enter one needs no search; of others so many situations are looked at, and no more.

use crate::net::Net;
use std::collections::HashSet;
use unoclp_text::diagnostics::{Code, Found, Span};

/// So many situations are looked at,
const MOST_SITUATIONS: usize = 20_000;

/// and so many steps and transitions in all of them.
const MOST_WORK: usize = 4_000_000;

/// For more situations than this, nothing is told of each.
const MOST_TOLD: usize = 32;

/// The steps that are active at once, in order.
type Situation = Box<[u32]>;

/// What has been seen.
struct Seen {
    /// The steps that can be active.
    active: Vec<bool>,
    /// The transitions that can fire.
    fires: Vec<bool>,
    /// Transitions that enter an active step, and the step.
    doubles: Vec<(u32, u32)>,
    /// Situations that nothing leaves.
    last: Vec<Situation>,
}

impl Net {
    /// Tells what the chart can come to that it should not.
    pub fn look(&self, at: Span, found: &mut Found) {
        let mut seen = self.reached();
        let is_simple = |arc: &crate::net::Arc| arc.from.len() <= 1 && arc.enters.len() <= 1;
        if self.transitions.iter().all(is_simple) {
            let ends = |step: &&u32| self.steps[**step as usize].leave.is_empty();
            let active = (0..).zip(&seen.active).filter(|(_, is)| **is);
            let active: Vec<u32> = active.map(|(step, _)| step).collect();
            let last = active.iter().filter(ends).map(|step| Box::from([*step]));
            seen.last = last.collect();
        } else {
            match self.searched() {
                Some(all) => seen = all,
                None => found.tell(Code::StChartTooLarge, at, []),
            }
        }
        self.tell(&seen, found);
    }

    fn nothing(&self) -> Seen {
        Seen {
            active: self.steps.iter().map(|step| step.initial).collect(),
            fires: vec![false; self.transitions.len()],
            doubles: Vec::new(),
            last: Vec::new(),
        }
    }

    /// What can be reached at most: as if a step that has been active stayed so.
    fn reached(&self) -> Seen {
        let mut seen = self.nothing();
        let lacks = self.transitions.iter().map(|arc| arc.from.len());
        let mut lacks: Vec<usize> = lacks.collect();
        let steps = (0..self.steps.len()).filter(|step| seen.active[*step]);
        let mut new: Vec<usize> = steps.collect();
        while let Some(step) = new.pop() {
            for &turn in &self.steps[step].leave {
                let turn = turn as usize;
                lacks[turn] -= 1;
                if lacks[turn] > 0 {
                    continue;
                }
                seen.fires[turn] = true;
                for &to in &self.transitions[turn].enters {
                    if !std::mem::replace(&mut seen.active[to as usize], true) {
                        new.push(to as usize);
                    }
                }
            }
        }
        seen
    }

    /// What is reached; none where that is too much.
    fn searched(&self) -> Option<Seen> {
        let mut seen = self.nothing();
        let first = (0..).zip(&self.steps).filter(|(_, step)| step.initial);
        let first: Situation = first.map(|(number, _)| number).collect();
        let mut known: HashSet<Situation> = HashSet::from([first.clone()]);
        let mut new = vec![first];
        let mut told: HashSet<u32> = HashSet::new();
        let mut work = 0;
        while let Some(now) = new.pop() {
            let is_active = |step: &u32| now.binary_search(step).is_ok();
            let mut goes_on = false;
            for &step in &now {
                seen.active[step as usize] = true;
                for &turn in &self.steps[step as usize].leave {
                    let arc = &self.transitions[turn as usize];
                    work += now.len() + arc.from.len() + arc.enters.len();
                    if work > MOST_WORK || known.len() > MOST_SITUATIONS {
                        return None;
                    }
                    // Once for each transition: where its first step stands.
                    if arc.from.first() != Some(&step) || !arc.from.iter().all(is_active) {
                        continue;
                    }
                    goes_on = true;
                    seen.fires[turn as usize] = true;
                    let leaves: HashSet<u32> = arc.leaves.iter().copied().collect();
                    let stay = now.iter().copied().filter(|step| !leaves.contains(step));
                    let mut then: Vec<u32> = stay.collect();
                    for &to in &arc.enters {
                        match is_active(&to) {
                            true if told.insert(turn) => seen.doubles.push((turn, to)),
                            true => {}
                            false => then.push(to),
                        }
                    }
                    then.sort_unstable();
                    let then: Situation = then.into();
                    if !known.contains(&then) {
                        known.insert(then.clone());
                        new.push(then);
                    }
                }
            }
            if !goes_on {
                seen.last.push(now);
            }
        }
        Some(seen)
    }

    fn tell(&self, seen: &Seen, found: &mut Found) {
        let name = |step: u32| self.steps[step as usize].name.text.as_str();
        let listed = |steps: &mut dyn Iterator<Item = u32>| {
            let mut names: Vec<&str> = steps.take(9).map(name).collect();
            if names.len() > 8 {
                names[8] = "…";
            }
            names.join(", ")
        };
        for (step, _) in self.steps.iter().zip(&seen.active).filter(|(_, is)| !**is) {
            let words = [step.name.text.as_str().into()];
            found.tell(Code::StStepUnreached, step.name.at, words);
        }
        let mut stays = HashSet::new();
        for ((turn, arc), _) in (0_u32..)
            .zip(&self.transitions)
            .zip(&seen.fires)
            .filter(|(_, fires)| !**fires)
        {
            // Of one whose steps are never active that has been told.
            let all = arc.from.iter().all(|step| seen.active[*step as usize]);
            if all && !arc.from.is_empty() {
                stays.insert(turn);
                let words = [listed(&mut arc.from.iter().copied()).into()];
                found.tell(Code::StNeverFires, arc.at, words);
            }
        }
        for &(turn, step) in &seen.doubles {
            let at = self.transitions[turn as usize].at;
            found.tell(Code::StTokenDoubled, at, [name(step).into()]);
        }
        for last in seen.last.iter().take(MOST_TOLD) {
            let mut waits = last
                .iter()
                .flat_map(|step| &self.steps[*step as usize].leave);
            let active = || listed(&mut last.iter().copied()).into();
            match (waits.next(), last.first()) {
                (Some(turn), _) if stays.contains(turn) => {}
                (Some(turn), _) => {
                    let at = self.transitions[*turn as usize].at;
                    found.tell(Code::StChartStuck, at, [active()]);
                }
                (None, Some(step)) => {
                    let at = self.steps[*step as usize].name.at;
                    found.tell(Code::StChartEnds, at, [active()]);
                }
                (None, None) => {}
            }
        }
    }
}
