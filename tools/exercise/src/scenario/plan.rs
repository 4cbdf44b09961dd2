//! What a scenario does from outside and expects over time, for whoever shows it beside what came.

use super::{Goal, Place, Scenario, Setting, Timeline};
use std::collections::BTreeMap;
use unoclp_core::{Millis, Point};

/// A value from each of these times on, in ms after the first scan, in rising order; none where any will do.
pub type Course = Vec<(Millis, Option<i32>)>;

/// The plan of a run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plan {
    /// The inputs that are set at any time, in order.
    pub inputs: Vec<Point>,
    /// What is expected of each place of which anything is.
    pub expected: BTreeMap<Place, Course>,
    /// When the power is cut.
    pub restarts: Vec<Millis>,
    /// No scan comes after this time.
    pub until: Millis,
}

impl Scenario {
    /// Its plan; where the program must be refused, nothing.
    pub fn plan(&self) -> Plan {
        match &self.goal {
            Goal::Refusal(_) => Plan::default(),
            Goal::Run(timeline) => plan(timeline),
        }
    }
}

fn plan(timeline: &Timeline) -> Plan {
    let mut plan = Plan {
        until: timeline.stop.map_or(timeline.until, |stop| stop.at),
        ..Plan::default()
    };
    for step in &timeline.steps {
        if step.restart {
            plan.restarts.push(step.at);
        }
        for set in &step.set {
            match set {
                Setting::Input(input, _) => plan.inputs.push(*input),
                Setting::Analogue(..) | Setting::Cell(..) => {}
            }
        }
        for &(place, expected) in &step.expect {
            let course = plan.expected.entry(place).or_default();
            match course.last_mut() {
                // Within a step the last counts.
                Some(last) if last.0 == step.at => last.1 = expected,
                _ => course.push((step.at, expected)),
            }
        }
    }
    plan.inputs.sort_unstable_by_key(|input| input.number());
    plan.inputs.dedup();
    // Of a place that may always be anything there is nothing to show.
    let is_told = |course: &mut Course| course.iter().any(|(_, expected)| expected.is_some());
    plan.expected.retain(|_, course| is_told(course));
    plan
}
