//! What of a chart is active, and for how long.

use crate::document::Document;

/// A step as it is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct State {
    /// Whether it is active.
    pub active: bool,
    /// For how long, in milliseconds, where that is measured.
    pub time: Option<i64>,
}

/// A chart as it is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Live {
    /// Of each step.
    pub steps: Vec<State>,
}

impl Live {
    /// The steps of a document as this says of each, by its name.
    pub fn of(document: &Document, state: impl FnMut(&str) -> State) -> Live {
        let names = document.steps.iter().map(|step| step.name.as_str());
        Live {
            steps: names.map(state).collect(),
        }
    }

    /// Whether a step is active.
    pub fn is_active(&self, step: usize) -> bool {
        self.steps.get(step).is_some_and(|state| state.active)
    }

    /// Whether all steps of a transition are active: its condition alone keeps it from firing.
    pub fn may_fire(&self, document: &Document, transition: usize) -> bool {
        let Some(transition) = document.transitions.get(transition) else {
            return false;
        };
        let is_active = |name: &String| {
            let step = document.step(name);
            step.is_some_and(|step| self.is_active(step))
        };
        !transition.from.is_empty() && transition.from.iter().all(is_active)
    }

    /// The active steps on one line, with their time: `● Fill 1.2 s  ● Warm`.
    pub fn line(&self, document: &Document) -> String {
        let steps = document.steps.iter().zip(&self.steps);
        let active = steps.filter(|(_, state)| state.active);
        let active = active.map(|(step, state)| match state.time {
            Some(time) => format!("● {} {}", step.name, seconds(time)),
            None => format!("● {}", step.name),
        });
        let active: Vec<String> = active.collect();
        active.join("  ")
    }
}

/// A time as it is shown: `1.2 s`.
pub(crate) fn seconds(ms: i64) -> String {
    format!("{}.{} s", ms / 1000, ms.rem_euclid(1000) / 100)
}
