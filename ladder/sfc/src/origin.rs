//! Which part of a chart an instruction of its program comes from, by where that stands in the text.

use crate::document::{Document, key};
use crate::sheet::Id;
use unoclp_lang::Lines;

/// What of a chart an instruction comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A step.
    Step(usize),
    /// An action or a variable that steps name, by its name in capitals.
    Action(String),
    /// A transition: its condition, and what it leaves and enters.
    Transition(usize),
}

impl Document {
    /// What stands at each of these lines and columns of its text; none where nothing of the chart does.
    pub fn origins(&self, at: impl Iterator<Item = (usize, usize)>) -> Vec<Option<Origin>> {
        let (text, places) = (self.text(), self.places());
        let lines = Lines::new(&text);
        let steps = places.steps.iter().enumerate();
        let steps = steps.map(|(number, place)| (place, Origin::Step(number)));
        let transitions = places.transitions.iter().enumerate();
        let transitions = transitions.map(|(at, place)| (place, Origin::Transition(at)));
        let actions = places.actions.iter().zip(&self.actions);
        let actions = actions.map(|(place, action)| (place, Origin::Action(key(&action.name))));
        let mut all: Vec<_> = steps.chain(transitions).chain(actions).collect();
        all.sort_by_key(|(place, _)| place.start);
        let origin = |byte: usize| {
            let begun = all.partition_point(|(place, _)| place.start <= byte);
            let (place, origin) = all.get(begun.checked_sub(1)?)?;
            if !place.contains(&byte) {
                return None;
            }
            let Origin::Step(number) = origin else {
                return Some(origin.clone());
            };
            // Where a step names what it does, that is meant.
            let step = self.steps.get(*number)?;
            let word = text.get(byte..).unwrap_or_default();
            let is_name = |c: char| c.is_alphanumeric() || c == '_';
            let word = key(word.split(|c| !is_name(c)).next().unwrap_or_default());
            let does = step.does.iter().any(|does| key(&does.action) == word);
            match does && word != key(&step.name) {
                true => Some(Origin::Action(word)),
                false => Some(origin.clone()),
            }
        };
        let byte = |(line, column)| lines.byte(&text, line, column) as usize;
        at.map(|place| origin(byte(place))).collect()
    }

    /// What the instructions of a part of its drawing come from.
    pub fn origin(&self, id: Id) -> Option<Origin> {
        Some(match id {
            Id::Step(step) => Origin::Step(step),
            Id::Does(step, nth) => {
                let does = self.steps.get(step)?.does.get(nth)?;
                Origin::Action(key(&does.action))
            }
            Id::Transition(of) | Id::Jump(of, _) | Id::Wait(of, _) => Origin::Transition(of),
        })
    }
}
