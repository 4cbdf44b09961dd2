//! The rules of a plant, and its faults that come on a condition.

use super::Run;
use crate::plant::Plant;
use crate::verdict::{Broken, Missed};
use unoclp_lang::Judge;

/// The conditions of a plant while it runs.
#[derive(Debug)]
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
}

impl Run<'_> {
    /// The faults that come or go now.
    pub(super) fn troubles(&mut self) {
        let mut judges = std::mem::take(&mut self.judges.troubles);
        for (trouble, coming) in self.plant.troubles.iter().zip(&mut judges) {
            if coming.over {
                continue;
            }
            let due = trouble.at.is_none_or(|at| self.now >= at);
            let value = |name| self.read(self.plant.places.get(name));
            let holds = due && coming.when.as_mut().is_none_or(|when| when.holds(value));
            match coming.since {
                None if holds => {
                    coming.since = Some(self.now);
                    self.fault(trouble.part, trouble.fault, true);
                }
                Some(since) if trouble.lasts > 0 && self.now - since >= trouble.lasts => {
                    coming.over = true;
                    self.fault(trouble.part, trouble.fault, false);
                }
                _ => {}
            }
        }
        self.judges.troubles = judges;
    }

    /// Which rules break now, and which goals are met or missed.
    pub(super) fn judge(&mut self) {
        let mut judges = std::mem::replace(
            &mut self.judges,
            Judges {
                nevers: Vec::new(),
                goals: Vec::new(),
                troubles: Vec::new(),
            },
        );
        let now = self.now;
        for (rule, watched) in judges.nevers.iter_mut().enumerate() {
            let Some(never) = self.plant.nevers.get(rule).filter(|_| !watched.broken) else {
                continue;
            };
            let value = |name| self.read(self.plant.places.get(name));
            if now < never.after || !watched.when.holds(value) {
                watched.held = 0;
                continue;
            }
            watched.held += 1;
            if watched.held > never.lasts {
                watched.broken = true;
                self.verdict.broken.push(Broken { rule, at: now });
            }
        }
        for (number, due) in judges.goals.iter_mut().enumerate() {
            let Some(goal) = self.plant.goals.get(number).filter(|_| !due.missed) else {
                continue;
            };
            let value = |name| self.read(self.plant.places.get(name));
            if let Some(each) = &mut due.each {
                let holds = each.holds(value);
                if holds && !due.held && due.since.is_none() {
                    due.since = Some(now);
                }
                due.held = holds;
            }
            let Some(since) = due.since else {
                continue;
            };
            if due.when.holds(value) {
                due.since = None;
                if let Some(met) = self.verdict.met.get_mut(number) {
                    *met += 1;
                }
            } else if now - since >= goal.within {
                due.missed = true;
                let missed = Missed {
                    goal: number,
                    since,
                    at: now,
                };
                self.verdict.missed.push(missed);
            }
        }
        self.judges = judges;
    }
}
