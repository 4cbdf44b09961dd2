//! Running a scenario on an engine.

use super::report::{Change, Report, Unmet, Verdict};
use super::{Goal, Refusal, Scenario, Step, Timeline};
use std::fmt;
use unoclp_core::{Image, Inputs, Millis};

/// A machine that runs programs: the core on this PC, the firmware in a simulator.
///
/// The outer `Result` of both methods tells whether the machine itself did its work; a machine
/// that cannot fail has [`Infallible`](std::convert::Infallible) as its error.
pub trait Engine {
    /// Why the machine could not do its work, such as a chip that hangs.
    type Error: fmt::Display;

    /// Starts anew with this program file: all outputs 0, no timer started. Gives the refusal of
    /// a faulty program; after one, and before the first load, nothing is scanned.
    fn load(&mut self, file: &[u8]) -> Result<Result<(), Refusal>, Self::Error>;

    /// One scan with these inputs, at this reading of the millisecond clock.
    fn scan(&mut self, inputs: &Inputs, now: Millis) -> Result<Outcome, Self::Error>;
}

/// What a scan ends in: the outputs as it leaves them, or a fault, with which all outputs are 0.
pub type Outcome = Result<Image, Refusal>;

/// Runs a scenario: a scan at 0, 1, 2 … periods, each compared with every expectation in force.
pub fn check<E: Engine>(scenario: &Scenario, engine: &mut E) -> Report {
    let mut run = Run::default();
    let verdict = match (engine.load(&scenario.program.bytes), &scenario.goal) {
        (Err(error), _) => Verdict::Broken {
            at: None,
            reason: error.to_string(),
        },
        (Ok(Err(came)), &Goal::Refusal(expected)) if came == expected => Verdict::Refused(came),
        (Ok(came), &Goal::Refusal(expected)) => Verdict::WrongRefusal {
            expected: Some(expected),
            came: came.err(),
        },
        (Ok(Err(came)), Goal::Run(_)) => Verdict::WrongRefusal {
            expected: None,
            came: Some(came),
        },
        (Ok(Ok(())), Goal::Run(timeline)) => run.through(timeline, engine),
    };
    Report {
        scenario: scenario.name.clone(),
        about: scenario.about.clone(),
        program: scenario.program.name.clone(),
        changes: run.changes,
        verdict,
    }
}

/// A run and what has come of it so far.
#[derive(Default)]
struct Run {
    inputs: Image,
    /// The states expected of the outputs …
    wanted: Image,
    /// … and the outputs of which one is expected at all.
    checked: Image,
    changes: Vec<Change>,
    unmet: Vec<Unmet>,
    comparisons: u64,
    /// ms from scan to scan.
    period: Millis,
}

impl Run {
    fn through<E: Engine>(&mut self, timeline: &Timeline, engine: &mut E) -> Verdict {
        let mut steps = timeline.steps.iter().peekable();
        self.period = timeline.period.get();
        let mut next_scan = Some(0);
        while let Some(at) = next_scan.filter(|&at| at <= timeline.until) {
            while let Some(step) = steps.next_if(|step| step.at <= at) {
                self.step(step);
            }
            match engine.scan(&self.inputs.into(), timeline.start.wrapping_add(at)) {
                Ok(Ok(outputs)) => self.compare(at, outputs),
                Ok(Err(refusal)) => {
                    return Verdict::Broken {
                        at: Some(at),
                        reason: refusal.to_string(),
                    };
                }
                Err(error) => {
                    return Verdict::Broken {
                        at: Some(at),
                        reason: error.to_string(),
                    };
                }
            }
            next_scan = at.checked_add(self.period);
        }
        match std::mem::take(&mut self.unmet) {
            unmet if unmet.is_empty() => Verdict::Met {
                comparisons: self.comparisons,
            },
            unmet => Verdict::Unmet(unmet),
        }
    }

    fn step(&mut self, step: &Step) {
        for &(input, state) in &step.set {
            self.inputs.set(input, state);
        }
        for &(output, expected) in &step.expect {
            self.checked.set(output, expected.is_some());
            self.wanted.set(output, expected.unwrap_or_default());
        }
    }

    fn compare(&mut self, at: Millis, outputs: Image) {
        let change = Change {
            at,
            inputs: self.inputs,
            outputs,
        };
        let same = |last: &Change| (last.inputs, last.outputs) == (self.inputs, outputs);
        if !self.changes.last().is_some_and(same) {
            self.changes.push(change);
        }
        self.comparisons += u64::from(self.checked.0.count_ones());
        if (outputs.0 ^ self.wanted.0) & self.checked.0 == 0 {
            return;
        }
        let checked = self.checked;
        for output in super::outputs().filter(|&output| checked.get(output)) {
            let expected = self.wanted.get(output);
            if outputs.get(output) != expected {
                self.unmet(Unmet::new(output, expected, at));
            }
        }
    }

    /// Notes an expectation not met; where it was not met in the scan before either, as one.
    fn unmet(&mut self, unmet: Unmet) {
        let before = unmet.from.checked_sub(self.period);
        let ongoing = self.unmet.iter_mut().rev().find(|last| {
            (last.output, last.expected, Some(last.to)) == (unmet.output, unmet.expected, before)
        });
        match ongoing {
            Some(last) => last.to = unmet.to,
            None => self.unmet.push(unmet),
        }
    }
}
