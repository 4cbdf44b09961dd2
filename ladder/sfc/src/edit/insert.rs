//! What is put into a chart.

use super::operation::Refusal;
use super::words::free;
use crate::document::{Document, Does, Step, Transition, same};
use crate::sheet::Id;
use unoclp_chart::Qualifier;

/// The condition of a new transition: a person is to write another.
const ALWAYS: &str = "TRUE";

impl Document {
    /// A name that no word of the text is: `S4`.
    fn new_name(&self, letter: &str) -> String {
        free(letter, &self.text())
    }

    fn new_step(&mut self) -> (usize, String) {
        let name = self.new_name("S");
        let step = Step {
            name: name.clone(),
            ..Step::default()
        };
        (self.add_step(step), name)
    }

    fn join(&mut self, at: usize, from: &str, to: &str) -> usize {
        let transition = Transition {
            from: vec![from.to_owned()],
            to: vec![to.to_owned()],
            condition: ALWAYS.to_owned(),
            ..Transition::default()
        };
        self.add_transition(at, transition)
    }

    /// The name of the step that an id means: of an action its step.
    pub(super) fn step_of(&self, id: Id) -> Result<(usize, String), Refusal> {
        let (Id::Step(number) | Id::Does(number, _)) = id else {
            return Err(Refusal::SelectStep);
        };
        let step = self.steps.get(number).ok_or(Refusal::NotThere)?;
        Ok((number, step.name.clone()))
    }

    /// The transition that an id means: of a jump the one before it.
    pub(super) fn transition_of(&self, id: Id) -> Result<usize, Refusal> {
        let (Id::Transition(number) | Id::Jump(number, _) | Id::Wait(number, _)) = id else {
            return Err(Refusal::SelectTransition);
        };
        match number < self.transitions.len() {
            true => Ok(number),
            false => Err(Refusal::NotThere),
        }
    }

    /// The transitions that leave a step of this name.
    pub(super) fn leaving(&self, name: &str) -> Vec<usize> {
        let all = self.transitions.iter().enumerate();
        let leaves = all.filter(|(_, of)| of.from.iter().any(|from| same(from, name)));
        leaves.map(|(number, _)| number).collect()
    }

    /// Those that enter it.
    pub(super) fn entering(&self, name: &str) -> Vec<usize> {
        let all = self.transitions.iter().enumerate();
        let enters = all.filter(|(_, of)| of.to.iter().any(|to| same(to, name)));
        enters.map(|(number, _)| number).collect()
    }

    pub(super) fn step_after(&mut self, id: Id) -> Result<Id, Refusal> {
        if let Ok(transition) = self.transition_of(id) {
            let (number, new) = self.new_step();
            let of = self.transition_mut(transition).ok_or(Refusal::NotThere)?;
            let to = std::mem::replace(&mut of.to, vec![new.clone()]);
            let next = self.join(transition + 1, &new, "");
            let of = self.transition_mut(next).ok_or(Refusal::NotThere)?;
            of.to = to;
            return Ok(Id::Step(number));
        }
        let (_, name) = self.step_of(id)?;
        let (number, new) = self.new_step();
        let leaving = self.leaving(&name);
        for transition in &leaving {
            self.rename_end(*transition, true, &name, &new);
        }
        let at = leaving.first().copied();
        self.join(at.unwrap_or(self.transitions.len()), &name, &new);
        Ok(Id::Step(number))
    }

    pub(super) fn step_before(&mut self, id: Id) -> Result<Id, Refusal> {
        let (old, name) = self.step_of(id)?;
        let (number, new) = self.new_step();
        for transition in self.entering(&name) {
            self.rename_end(transition, false, &name, &new);
        }
        let at = self.leaving(&name).first().copied();
        self.join(at.unwrap_or(self.transitions.len()), &new, &name);
        // A chart begins at its first step.
        if self.steps[old].initial {
            let first = self.step_mut(old).ok_or(Refusal::NotThere)?;
            first.initial = false;
            let new = self.step_mut(number).ok_or(Refusal::NotThere)?;
            new.initial = true;
        }
        Ok(Id::Step(number))
    }

    fn rename_end(&mut self, transition: usize, from: bool, old: &str, new: &str) {
        let Some(of) = self.transition_mut(transition) else {
            return;
        };
        let ends = if from { &mut of.from } else { &mut of.to };
        for end in ends.iter_mut().filter(|end| same(end, old)) {
            new.clone_into(end);
        }
    }

    /// Another way with a step of its own, which leads to where the way beside it does.
    pub(super) fn branch(&mut self, id: Id) -> Result<Id, Refusal> {
        let (from, at, to) = match self.transition_of(id) {
            Ok(transition) => {
                let of = &self.transitions[transition];
                let from = of.from.clone();
                (from, transition + 1, self.end_of(transition))
            }
            Err(_) => {
                let (_, name) = self.step_of(id)?;
                let leaving = self.leaving(&name);
                let to = match leaving.last() {
                    Some(last) => self.end_of(*last),
                    None => name.clone(),
                };
                let at = leaving
                    .last()
                    .map_or(self.transitions.len(), |last| last + 1);
                (vec![name], at, to)
            }
        };
        let (number, new) = self.new_step();
        let transition = self.join(at, "", &new);
        let of = self.transition_mut(transition).ok_or(Refusal::NotThere)?;
        of.from = from;
        self.join(transition + 1, &new, &to);
        Ok(Id::Step(number))
    }

    /// Where a way of a selection ends: after its steps in a row, as far as several ways meet.
    fn end_of(&self, transition: usize) -> String {
        let mut to = self.transitions[transition]
            .to
            .first()
            .cloned()
            .unwrap_or_default();
        for _ in 0..self.steps.len() {
            let several = self.entering(&to).len() > 1;
            let initial = self.step(&to).is_none_or(|step| self.steps[step].initial);
            let leaving = self.leaving(&to);
            match leaving[..] {
                [one] if !several && !initial && self.transitions[one].to.len() == 1 => {
                    let next = self.transitions[one].to.first();
                    to = next.cloned().unwrap_or_default();
                }
                _ => break,
            }
        }
        to
    }

    /// A step beside a step: the transitions around it enter and leave both.
    pub(super) fn beside(&mut self, id: Id) -> Result<Id, Refusal> {
        let (old, name) = self.step_of(id)?;
        let (entering, leaving) = (self.entering(&name), self.leaving(&name));
        if self.steps[old].initial || entering.is_empty() {
            return Err(Refusal::SelectStep);
        }
        let (number, new) = self.new_step();
        let beside = |ends: &mut Vec<String>| {
            if let Some(at) = ends.iter().position(|end| same(end, &name)) {
                ends.insert(at + 1, new.clone());
            }
        };
        for transition in entering {
            beside(&mut self.transition_mut(transition).ok_or(Refusal::NotThere)?.to);
        }
        for transition in leaving {
            beside(
                &mut self
                    .transition_mut(transition)
                    .ok_or(Refusal::NotThere)?
                    .from,
            );
        }
        Ok(Id::Step(number))
    }

    pub(super) fn jump(&mut self, id: Id, to: &str) -> Result<Id, Refusal> {
        let (_, name) = self.step_of(id)?;
        let target = self.step(to).ok_or(Refusal::NotThere)?;
        let to = self.steps[target].name.clone();
        let at = self.leaving(&name).last().map(|last| last + 1);
        let transition = self.join(at.unwrap_or(self.transitions.len()), &name, &to);
        Ok(Id::Transition(transition))
    }

    /// A step does something more: an action that is still to be named.
    pub(super) fn act(&mut self, id: Id) -> Result<Id, Refusal> {
        let (number, _) = self.step_of(id)?;
        let action = self.new_name("A");
        self.add_action(crate::document::Action {
            name: action.clone(),
            ..crate::document::Action::default()
        });
        let step = self.step_mut(number).ok_or(Refusal::NotThere)?;
        step.does.push(Does {
            action,
            qualifier: Qualifier::N,
            time: None,
        });
        Ok(Id::Does(number, step.does.len() - 1))
    }
}
