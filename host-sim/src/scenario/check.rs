//! Running a scenario on an engine.

use super::report::{Change, Columns, Report, Unmet, Verdict};
use super::{Cell, Goal, Place, Refusal, Scenario, Setting, Step, Timeline};
use std::collections::BTreeMap;
use std::fmt;
use unoclp_core::{Image, Inputs, Millis};

/// A machine that runs programs: the core on this PC, the firmware in a simulator.
///
/// The outer `Result` of each method tells whether the machine itself did its work; a machine
/// that cannot fail has [`Infallible`](std::convert::Infallible) as its error.
pub trait Engine {
    /// Why the machine could not do its work, such as a chip that hangs.
    type Error: fmt::Display;

    /// Starts anew with this program file: all outputs 0, no timer started, nothing kept of a program
    /// before. Gives the refusal of a faulty program; after one, and before the first load, nothing is
    /// scanned.
    fn load(&mut self, file: &[u8]) -> Result<Result<(), Refusal>, Self::Error>;

    /// One scan with these inputs, at this reading of the millisecond clock.
    fn scan(&mut self, inputs: &Inputs, now: Millis) -> Result<Outcome, Self::Error>;

    /// A power cut between two scans: the program starts anew, and retentive markers and numbers are
    /// kept (NC-12, NC-21).
    fn restart(&mut self) -> Result<(), Self::Error>;

    /// What a cell holds after the last scan.
    fn look(&mut self, cell: Cell) -> Result<i32, Self::Error>;

    /// Sets a cell between two scans.
    fn poke(&mut self, cell: Cell, value: i32) -> Result<(), Self::Error>;

    /// PWM of the output with this number, from 1, after the last scan.
    fn pwm(&mut self, output: u8) -> Result<u8, Self::Error>;
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
        let look = |place: &Place| match *place {
            Place::Output(number) => Ok((outputs.0 >> (number - 1) & 1) as i32),
            Place::Cell(cell) => engine.look(cell),
            Place::Pwm(output) => engine.pwm(output).map(i32::from),
        };
        let seen: Result<Vec<i32>, E::Error> = self.columns.seen.iter().map(look).collect();
        let change = Change {
            at,
            inputs: self.inputs,
            outputs,
            seen: seen?,
        };
        let came = |place: &Place| match *place {
            Place::Output(number) => (outputs.0 >> (number - 1) & 1) as i32,
            _ => self.columns.value(place, &change.seen),
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
