//! The rules of a plant, and its faults that come on a condition.

use crate::kind::Fault;
use crate::plant::Plant;
use crate::verdict::{Broken, Missed, Verdict};
use unoclp_lang::Judge;

/// The conditions of a plant while it runs.
#[derive(Debug, Default)]
pub(super) struct Judges<'p> {
    nevers: Vec<Watched<'p>>,
    goals: Vec<Due<'p>>,
    troubles: Vec<Coming<'p>>,
}

#[derive(Debug)]
struct Watched<'p> {
    when: Judge<'p>,
    /// For how long it holds, ms.
    held: u64,
    broken: bool,
}

#[derive(Debug)]
struct Due<'p> {
    when: Judge<'p>,
    each: Option<Judge<'p>>,
    held: bool,
    since: Option<u64>,
    missed: bool,
}

#[derive(Debug)]
struct Coming<'p> {
    when: Option<Judge<'p>>,
    since: Option<u64>,
    over: bool,
}

impl<'p> Judges<'p> {
    /// Before the first step.
    pub fn new(plant: &'p Plant) -> Judges<'p> {
        let nevers = plant.nevers.iter().map(|never| Watched {
            when: Judge::new(&never.when),
            held: 0,
            broken: false,
        });
        let goals = plant.goals.iter().map(|goal| Due {
            when: Judge::new(&goal.when),
            each: goal.each.as_ref().map(Judge::new),
            held: false,
            since: goal.each.is_none().then_some(0),
            missed: false,
        });
        let troubles = plant.troubles.iter().map(|trouble| Coming {
            when: trouble.when.as_ref().map(Judge::new),
            since: None,
            over: false,
        });
        Judges {
            nevers: nevers.collect(),
            goals: goals.collect(),
            troubles: troubles.collect(),
        }
    }

    /// The faults that come or go now: the part, the fault, whether it has it.
    pub fn troubles(
        &mut self,
        plant: &Plant,
        now: u64,
        value: impl Fn(usize) -> i64,
    ) -> Vec<(usize, Fault, bool)> {
        let mut changes = Vec::new();
        for (trouble, coming) in plant.troubles.iter().zip(&mut self.troubles) {
            if coming.over {
                continue;
            }
            let due = trouble.at.is_none_or(|at| now >= at);
            let holds = due && coming.when.as_mut().is_none_or(|when| when.holds(&value));
            match coming.since {
                None if holds => {
                    coming.since = Some(now);
                    changes.push((trouble.part, trouble.fault, true));
                }
                Some(since) if trouble.lasts > 0 && now - since >= trouble.lasts => {
                    coming.over = true;
                    changes.push((trouble.part, trouble.fault, false));
                }
                _ => {}
            }
        }
        changes
    }

    /// Which rules break now, and which goals are met or missed.
    pub fn judge(
        &mut self,
        plant: &Plant,
        now: u64,
        value: impl Fn(usize) -> i64,
        verdict: &mut Verdict,
    ) {
        for (rule, (watched, never)) in self.nevers.iter_mut().zip(&plant.nevers).enumerate() {
            if watched.broken {
                continue;
            }
            if now < never.after || !watched.when.holds(&value) {
                watched.held = 0;
                continue;
            }
            watched.held += 1;
            if watched.held > never.lasts {
                watched.broken = true;
                verdict.broken.push(Broken { rule, at: now });
            }
        }
        for (number, (due, goal)) in self.goals.iter_mut().zip(&plant.goals).enumerate() {
            if due.missed {
                continue;
            }
            if let Some(each) = &mut due.each {
                let holds = each.holds(&value);
                if holds && !due.held && due.since.is_none() {
                    due.since = Some(now);
                }
                due.held = holds;
            }
            let Some(since) = due.since else {
                continue;
            };
            if due.when.holds(&value) {
                due.since = None;
                if let Some(met) = verdict.met.get_mut(number) {
                    *met += 1;
                }
            } else if now + 1 >= since + goal.within {
                // This was its last millisecond: a goal that has until the end of the script is judged too.
                due.missed = true;
                let (goal, at) = (number, since + goal.within);
                verdict.missed.push(Missed { goal, since, at });
            }
        }
    }
}
