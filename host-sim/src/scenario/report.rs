//! What came of a scenario, as text that a student can read.

use super::{Place, Refusal, Setting, Timeline};
use std::collections::BTreeSet;
use std::fmt;
use unoclp_core::{Cause, Image, Inputs, Millis};

/// What came of a scenario on an engine. Its `Display` is the timeline, then `PASS` or `FAIL`.
#[derive(Clone, Debug)]
pub struct Report {
    /// The path of the scenario.
    pub scenario: String,
    /// What the scenario shows.
    pub about: String,
    /// What the program is called.
    pub program: String,
    /// What is shown of each change.
    pub columns: Columns,
    /// The scans at which anything shown changed; the first scan is always among them.
    pub changes: Vec<Change>,
    /// Whether the engine did as expected.
    pub verdict: Verdict,
}

/// What is shown from this scan on, until the next change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// ms after the first scan.
    pub at: Millis,
    /// The inputs that the scan saw.
    pub inputs: Inputs,
    /// The outputs as the scan left them.
    pub outputs: Image,
    /// [`Columns::seen`] as the scan left them.
    pub seen: Vec<i32>,
}

impl Change {
    /// Whether both show the same.
    pub(super) fn shows_as(&self, other: &Change) -> bool {
        (self.inputs, self.outputs, &self.seen) == (other.inputs, other.outputs, &other.seen)
    }
}

/// What a timeline shows beside the outputs.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Columns {
    /// The inputs from 01 to this number.
    pub inputs: u8,
    /// The analogue inputs that the scenario uses, from 0.
    pub analogue: Vec<u8>,
    /// The places beside outputs that it expects anything of.
    pub seen: Vec<Place>,
}

impl Columns {
    /// What is worth showing of a run.
    pub(super) fn of(timeline: &Timeline) -> Columns {
        let (mut inputs, mut analogue, mut seen) = (4, BTreeSet::new(), BTreeSet::new());
        for step in &timeline.steps {
            for setting in &step.set {
                match *setting {
                    Setting::Input(input, _) => inputs = inputs.max(input.number()),
                    Setting::Analogue(input, _) => drop(analogue.insert(input)),
                    Setting::Cell(..) => {}
                }
            }
            let places = step.expect.iter().map(|&(place, _)| place);
            seen.extend(places.filter(|place| !matches!(place, Place::Output(_))));
        }
        Columns {
            inputs,
            analogue: analogue.into_iter().collect(),
            seen: seen.into_iter().collect(),
        }
    }

    /// What has been seen of a place.
    pub(super) fn value(&self, place: &Place, seen: &[i32]) -> i32 {
        let column = self.seen.iter().position(|column| column == place);
        let value = column.and_then(|column| seen.get(column));
        value.copied().unwrap_or_default()
    }
}

/// How an engine did in a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Every expectation was met in every scan.
    Met {
        /// How many times a place was compared with what was expected of it.
        comparisons: u64,
    },
    /// The program was refused as expected.
    Refused(Refusal),
    /// It ran, met every expectation, and ended in the fault expected, so many ms after the first scan.
    Stopped(Millis, Refusal),
    /// Some expectations were not met, in the order of time.
    Unmet(Vec<Unmet>),
    /// The program was refused, or run, against what was expected.
    WrongRefusal {
        /// The refusal expected; none where the program should run.
        expected: Option<Refusal>,
        /// The engine's refusal; none where the program ran.
        came: Option<Refusal>,
    },
    /// The program ended in a fault, or ran on, against what was expected.
    WrongStop {
        /// The fault expected, and when, in ms after the first scan; none where it should run on.
        expected: Option<(Millis, Refusal)>,
        /// What came of it; none where it ran on.
        came: Option<(Millis, Refusal)>,
    },
    /// The engine itself could not go on.
    Broken {
        /// The scan, in ms after the first; none while the program was loaded.
        at: Option<Millis>,
        /// What the engine says.
        reason: String,
    },
}

/// A place that was not as expected, in one scan or several that follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unmet {
    /// The place.
    pub place: Place,
    /// What was expected of it.
    pub expected: i32,
    /// What came.
    pub came: i32,
    /// The first of the scans, in ms after the first scan of all.
    pub from: Millis,
    /// The last of them.
    pub to: Millis,
}

impl Unmet {
    pub(super) fn new(place: Place, expected: i32, came: i32, at: Millis) -> Unmet {
        Unmet {
            place,
            expected,
            came,
            from: at,
            to: at,
        }
    }
}

/// More expectations that were not met than this are only counted.
const UNMET_SHOWN: usize = 8;

impl Report {
    /// Whether the engine did everything as expected.
    pub fn passed(&self) -> bool {
        matches!(
            self.verdict,
            Verdict::Met { .. } | Verdict::Refused(_) | Verdict::Stopped(..)
        )
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}", self.scenario, self.about)?;
        writeln!(f, "program: {}", self.program)?;
        if !self.changes.is_empty() {
            writeln!(f)?;
            timeline(f, &self.columns, &self.changes)?;
            writeln!(f)?;
        }
        self.verdict.fmt(f)
    }
}

/// One line for each change, under the names of the points.
fn timeline(f: &mut fmt::Formatter<'_>, columns: &Columns, changes: &[Change]) -> fmt::Result {
    let inputs = || super::inputs().filter(|point| point.number() <= columns.inputs);
    write!(f, "{:>10}", "ms")?;
    inputs().try_for_each(|point| write!(f, "  I{}", point.number()))?;
    for input in &columns.analogue {
        write!(f, "{:>6}", format!("A{input}"))?;
    }
    f.write_str("  ")?;
    super::outputs().try_for_each(|point| write!(f, "  Q{}", point.number()))?;
    for place in &columns.seen {
        let width = if place.is_bit() { 5 } else { NUMBER_WIDTH };
        write!(f, "{:>width$}", place.to_string())?;
    }
    writeln!(f, "    1 = closed, on; · = open, off")?;
    for change in changes {
        write!(f, "{:>10}", change.at)?;
        inputs().try_for_each(|point| state(f, change.inputs.points.get(point)))?;
        for &input in &columns.analogue {
            let reading = change.inputs.analogue.get(usize::from(input));
            write!(f, "{:>6}", reading.copied().unwrap_or_default())?;
        }
        f.write_str("  ")?;
        super::outputs().try_for_each(|point| state(f, change.outputs.get(point)))?;
        for (place, value) in columns.seen.iter().zip(&change.seen) {
            match (place.is_bit(), value) {
                (true, 0) => write!(f, "{:>5}", "·")?,
                (true, _) => write!(f, "{value:>5}")?,
                (false, _) => write!(f, "{value:>NUMBER_WIDTH$}")?,
            }
        }
        writeln!(f)?;
    }
    Ok(())
}

/// Columns of a number with a sign and 32 bits, and a space.
const NUMBER_WIDTH: usize = 12;

fn state(f: &mut fmt::Formatter<'_>, state: bool) -> fmt::Result {
    f.write_str(if state { "   1" } else { "   ·" })
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Verdict::Met { comparisons: 0 } => write!(f, "PASS: it ran; nothing was expected"),
            Verdict::Met { .. } => write!(f, "PASS"),
            Verdict::Refused(refusal) => write!(f, "PASS: refused as expected: {}", told(*refusal)),
            Verdict::Stopped(at, refusal) => {
                write!(
                    f,
                    "PASS: stopped as expected at {at} ms: {}",
                    told(*refusal)
                )
            }
            Verdict::WrongStop { expected, came } => {
                let said = |stop: &Option<(Millis, Refusal)>| match stop {
                    Some((at, refusal)) => format!("at {at} ms {}", told(*refusal)),
                    None => "that the program runs on".to_owned(),
                };
                write!(f, "FAIL\n  expected {}", said(expected))?;
                match came {
                    Some(_) => write!(f, "\n  came     {}", said(came)),
                    None => write!(f, "\n  but the program ran on"),
                }
            }
            Verdict::Unmet(unmet) => {
                write!(f, "FAIL")?;
                for unmet in unmet.iter().take(UNMET_SHOWN) {
                    write!(f, "\n  {unmet}")?;
                }
                match unmet.len().saturating_sub(UNMET_SHOWN) {
                    0 => Ok(()),
                    more => write!(f, "\n  … and {more} more"),
                }
            }
            Verdict::WrongRefusal { expected, came } => {
                let said = |refusal: &Option<Refusal>| match refusal {
                    Some(refusal) => told(*refusal),
                    None => "that the program runs".to_owned(),
                };
                write!(f, "FAIL\n  expected {}", said(expected))?;
                match came {
                    Some(came) => write!(f, "\n  came     {}", told(*came)),
                    None => write!(f, "\n  but the program was accepted"),
                }
            }
            Verdict::Broken { at: None, reason } => {
                write!(f, "FAIL\n  while the program was loaded: {reason}")
            }
            Verdict::Broken {
                at: Some(at),
                reason,
            } => write!(f, "FAIL\n  at {at} ms: {reason}"),
        }
    }
}

impl fmt::Display for Unmet {
    /// `Q1 at 5000 ms: expected 0, came 1 (until 5020 ms)`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} at {} ms: expected {}, came {}",
            self.place, self.from, self.expected, self.came
        )?;
        if self.to > self.from {
            write!(f, " (until {} ms)", self.to)?;
        }
        Ok(())
    }
}

/// A refusal with the text of its fault.
fn told(refusal: Refusal) -> String {
    let cause = Cause::ALL
        .iter()
        .find(|cause| cause.number() == refusal.number);
    match cause {
        Some(cause) => format!("{refusal}: {}", cause.text()),
        None => refusal.to_string(),
    }
}
