//! The time that a program has to do what is expected of it: programs that solve the same task differ by some scans.
//!
//! Owns how that time is written as steps. Must not know how steps are read.

use super::{Place, Step};
use std::collections::BTreeMap;
use unoclp_core::Millis;

/// The same steps, in which whatever is newly expected of a place is compared only `within` ms later; until then the
/// place may be anything.
pub(super) fn allow(steps: Vec<Step>, within: Millis) -> Vec<Step> {
    if within == 0 {
        return steps;
    }
    let mut run = Run::default();
    for step in steps {
        run.settle(step.at);
        let Step {
            at,
            restart,
            set,
            expect,
        } = step;
        let entry = run.at(at);
        entry.restart = restart;
        entry.set = set;
        for (place, expected) in expect {
            run.expect(at, place, expected, within);
        }
    }
    run.settle(Millis::MAX);
    run.steps.into_values().collect()
}

/// A run as far as its steps have been gone through.
#[derive(Default)]
struct Run {
    /// By their times.
    steps: BTreeMap<Millis, Step>,
    /// What is expected of each place, compared or not yet.
    wanted: BTreeMap<Place, i32>,
    /// What is not compared before its time.
    pending: BTreeMap<Place, (Millis, i32)>,
}

impl Run {
    fn at(&mut self, at: Millis) -> &mut Step {
        self.steps.entry(at).or_insert_with(|| Step::at(at))
    }

    fn expect(&mut self, at: Millis, place: Place, expected: Option<i32>, within: Millis) {
        let before = match expected {
            Some(value) => self.wanted.insert(place, value),
            None => self.wanted.remove(&place),
        };
        if expected.is_some() && expected == before {
            return;
        }
        self.pending.remove(&place);
        self.at(at).expect.push((place, None));
        if let Some(value) = expected {
            self.pending
                .insert(place, (at.saturating_add(within), value));
        }
    }

    /// What is due by this time is compared from when it is due.
    fn settle(&mut self, by: Millis) {
        let due = self.pending.extract_if(.., |_, (due, _)| *due <= by);
        for (place, (due, value)) in due.collect::<Vec<_>>() {
            self.at(due).expect.push((place, Some(value)));
        }
    }
}
