//! Running a scenario on an engine.

use super::report::{Change, Columns, Report, Unmet, Verdict};
use super::{Goal, Place, Scenario, Setting, Step, Timeline};
use std::collections::BTreeMap;
use unoclp_core::{Image, Inputs, Millis};
use unoclp_host_sim::engine::Engine;

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
        columns: run.columns,
        changes: run.changes,
        end: run.end,
        verdict,
    }
}

/// A run and what has come of it so far.
#[derive(Default)]
struct Run {
    inputs: Inputs,
    /// What is expected of each place of which anything is.
    wanted: BTreeMap<Place, i32>,
    columns: Columns,
    changes: Vec<Change>,
    unmet: Vec<Unmet>,
    comparisons: u64,
    /// ms from scan to scan.
    period: Millis,
    /// The last scan that the engine ended without a fault, in ms after the first.
    end: Millis,
}

impl Run {
    fn through<E: Engine>(&mut self, timeline: &Timeline, engine: &mut E) -> Verdict {
        self.columns = Columns::of(timeline);
        self.period = timeline.period.get();
        let stop = timeline.stop.map(|stop| (stop.at, stop.refusal));
        let mut steps = timeline.steps.iter().peekable();
        let mut next_scan = Some(0);
        while let Some(at) = next_scan.filter(|&at| at <= timeline.until) {
            let now = timeline.start.wrapping_add(at);
            let mut scan = || {
                while let Some(step) = steps.next_if(|step| step.at <= at) {
                    self.step(step, engine)?;
                }
                match engine.scan(&self.inputs, now)? {
                    Ok(outputs) => self.compare(at, outputs, engine).map(Ok),
                    Err(refusal) => Ok(Err(refusal)),
                }
            };
            match scan() {
                Ok(Ok(())) => self.end = at,
                Ok(Err(_)) if !self.unmet.is_empty() => break,
                Ok(Err(came)) if stop == Some((at, came)) => return Verdict::Stopped(at, came),
                Ok(Err(came)) => {
                    return Verdict::WrongStop {
                        expected: stop,
                        came: Some((at, came)),
                    };
                }
                Err(error) => {
                    let error: E::Error = error;
                    return Verdict::Broken {
                        at: Some(at),
                        reason: error.to_string(),
                    };
                }
            }
            next_scan = at.checked_add(self.period);
        }
        match (std::mem::take(&mut self.unmet), stop) {
            (unmet, None) if unmet.is_empty() => Verdict::Met {
                comparisons: self.comparisons,
            },
            (unmet, expected) if unmet.is_empty() => Verdict::WrongStop {
                expected,
                came: None,
            },
            (unmet, _) => Verdict::Unmet(unmet),
        }
    }

    fn step<E: Engine>(&mut self, step: &Step, engine: &mut E) -> Result<(), E::Error> {
        if step.restart {
            engine.restart()?;
        }
        for &setting in &step.set {
            match setting {
                Setting::Input(input, state) => self.inputs.points.set(input, state),
                Setting::Analogue(input, reading) => {
                    if let Some(place) = self.inputs.analogue.get_mut(usize::from(input)) {
                        *place = reading;
                    }
                }
                Setting::Cell(cell, value) => engine.poke(cell, value)?,
            }
        }
        for &(place, expected) in &step.expect {
            match expected {
                Some(expected) => self.wanted.insert(place, expected),
                None => self.wanted.remove(&place),
            };
        }
        Ok(())
    }

    fn compare<E: Engine>(
        &mut self,
        at: Millis,
        outputs: Image,
        engine: &mut E,
    ) -> Result<(), E::Error> {
        let level = |output: u8| (outputs.0 >> (output - 1) & 1) as i32;
        let look = |place: &Place| match (place.cell(), place.output()) {
            (Some(cell), _) => engine.look(cell),
            (None, Some(output)) => Ok(level(output)),
            (None, None) => engine.pwm(place.point().number()).map(i32::from),
        };
        let seen: Result<Vec<i32>, E::Error> = self.columns.seen.iter().map(look).collect();
        let change = Change {
            at,
            inputs: self.inputs,
            outputs,
            seen: seen?,
        };
        let came = |place: &Place| match place.output() {
            Some(output) => level(output),
            None => self.columns.value(place, &change.seen),
        };
        self.comparisons += self.wanted.len() as u64;
        let unmet: Vec<Unmet> = self
            .wanted
            .iter()
            .map(|(&place, &expected)| Unmet::new(place, expected, came(&place), at))
            .filter(|unmet| unmet.came != unmet.expected)
            .collect();
        unmet.into_iter().for_each(|unmet| self.unmet(unmet));
        if !self
            .changes
            .last()
            .is_some_and(|last| last.shows_as(&change))
        {
            self.changes.push(change);
        }
        Ok(())
    }

    /// Notes an expectation not met; where it was not met in the scan before either, as one.
    fn unmet(&mut self, unmet: Unmet) {
        let before = unmet.from.checked_sub(self.period);
        let ongoing = self.unmet.iter_mut().rev().find(|last| {
            let same =
                (last.place, last.expected, last.came) == (unmet.place, unmet.expected, unmet.came);
            same && Some(last.to) == before
        });
        match ongoing {
            Some(last) => last.to = unmet.to,
            None => self.unmet.push(unmet),
        }
    }
}
