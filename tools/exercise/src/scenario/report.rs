//! What came of a scenario.

use super::{Both, Place, Setting, Timeline};
use std::collections::BTreeSet;
use unoclp_core::{Image, Inputs, Millis};
use unoclp_host_sim::engine::Refusal;

/// What came of a scenario on an engine. As text it is the timeline, then `PASS` or `FAIL`.
#[derive(Clone, Debug)]
pub struct Report {
    /// The path of the scenario.
    pub scenario: String,
    /// What the scenario shows.
    pub about: Both,
    /// What the program is called.
    pub program: String,
    /// What is shown of each change.
    pub columns: Columns,
    /// The scans at which anything shown changed; the first scan is always among them.
    pub changes: Vec<Change>,
    /// The last scan, in ms after the first; 0 where nothing ran.
    pub end: Millis,
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

/// Inputs and outputs that are shown whatever a scenario names.
const FIRST: u8 = 4;

/// What a timeline shows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Columns {
    /// The inputs from 01 to this number.
    pub inputs: u8,
    /// Outputs 01 to this number are shown.
    pub outputs: u8,
    /// The analogue inputs that the scenario uses, from 0.
    pub analogue: Vec<u8>,
    /// The places beside outputs that it expects anything of.
    pub seen: Vec<Place>,
}

impl Columns {
    /// What is worth showing of a run.
    pub(super) fn of(timeline: &Timeline) -> Columns {
        let (mut inputs, mut analogue, mut seen) = (FIRST, BTreeSet::new(), BTreeSet::new());
        let mut outputs = FIRST.min(timeline.board.outputs);
        for step in &timeline.steps {
            for setting in &step.set {
                match *setting {
                    Setting::Input(input, _) => inputs = inputs.max(input.number()),
                    Setting::Analogue(input, _) => drop(analogue.insert(input)),
                    Setting::Cell(..) => {}
                }
            }
            let places = step.expect.iter().map(|&(place, _)| place);
            for place in places.clone() {
                if let Some(output) = place.output() {
                    outputs = outputs.max(output);
                }
            }
            seen.extend(places.filter(|place| place.output().is_none()));
        }
        Columns {
            inputs,
            outputs,
            analogue: analogue.into_iter().collect(),
            seen: seen.into_iter().collect(),
        }
    }

    /// What has been seen of a place that is no output.
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

impl Report {
    /// What a place was in the scan of this change.
    pub fn came(&self, place: Place, change: &Change) -> i32 {
        match place.output() {
            Some(number) => (change.outputs.0 >> (number - 1) & 1) as i32,
            None => self.columns.value(&place, &change.seen),
        }
    }

    /// Whether the engine did everything as expected.
    pub fn passed(&self) -> bool {
        matches!(
            self.verdict,
            Verdict::Met { .. } | Verdict::Refused(_) | Verdict::Stopped(..)
        )
    }
}
