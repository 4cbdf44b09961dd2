//! What is changed in a chart where it stands.

use super::operation::{Refusal, Side};
use super::words::{renamed, uses};
use crate::document::{Action, Document, same};
use crate::sheet::Id;
use unoclp_chart::Qualifier;
use unoclp_lang::is_name;

impl Document {
    /// Whether steps, actions or transitions have this name.
    fn has(&self, name: &str) -> bool {
        let transitions = self.transitions.iter().filter_map(|of| of.name.as_ref());
        let mut names = transitions.map(String::as_str);
        self.step(name).is_some() || self.action(name).is_some() || names.any(|own| same(own, name))
    }

    pub(super) fn rename(&mut self, id: Id, name: &str) -> Result<Id, Refusal> {
        let name = name.trim();
        if !is_name(name) {
            return Err(Refusal::NoName);
        }
        let Id::Step(number) = id else {
            return self.rename_action(id, name);
        };
        let old = self
            .steps
            .get(number)
            .ok_or(Refusal::NotThere)?
            .name
            .clone();
        if !same(&old, name) && self.has(name) {
            return Err(Refusal::NameTaken);
        }
        let step = self.step_mut(number).ok_or(Refusal::NotThere)?;
        name.clone_into(&mut step.name);
        for transition in 0..self.transitions.len() {
            let of = &self.transitions[transition];
            let ends = of.from.iter().chain(&of.to);
            let is_end = ends.into_iter().any(|end| same(end, &old));
            if !is_end && !uses(&of.condition, &old) {
                continue;
            }
            let of = self.transition_mut(transition).ok_or(Refusal::NotThere)?;
            let ends = of.from.iter_mut().chain(&mut of.to);
            for end in ends.filter(|end| same(end, &old)) {
                name.clone_into(end);
            }
            of.condition = renamed(&of.condition, &old, name);
        }
        self.rename_in_bodies(&old, name);
        Ok(id)
    }

    fn rename_in_bodies(&mut self, old: &str, name: &str) {
        for action in 0..self.actions.len() {
            if uses(&self.actions[action].body, old)
                && let Some(of) = self.action_mut(action)
            {
                of.body = renamed(&of.body, old, name);
            }
        }
    }

    fn rename_action(&mut self, id: Id, name: &str) -> Result<Id, Refusal> {
        let Id::Does(step, nth) = id else {
            return Err(Refusal::SelectStep);
        };
        let does = self.steps.get(step).and_then(|step| step.does.get(nth));
        let old = does.ok_or(Refusal::NotThere)?.action.clone();
        if !same(&old, name) && self.has(name) {
            return Err(Refusal::NameTaken);
        }
        if let Some(action) = self.action(&old) {
            let of = self.action_mut(action).ok_or(Refusal::NotThere)?;
            name.clone_into(&mut of.name);
        }
        for step in 0..self.steps.len() {
            if !self.steps[step]
                .does
                .iter()
                .any(|does| same(&does.action, &old))
            {
                continue;
            }
            let of = self.step_mut(step).ok_or(Refusal::NotThere)?;
            for does in of.does.iter_mut().filter(|does| same(&does.action, &old)) {
                name.clone_into(&mut does.action);
            }
        }
        self.rename_in_bodies(&old, name);
        Ok(id)
    }

    pub(super) fn condition(&mut self, id: Id, condition: &str) -> Result<Id, Refusal> {
        let number = self.transition_of(id)?;
        let condition = condition.trim().trim_end_matches(';').trim();
        if condition.is_empty() {
            return Err(Refusal::Missing);
        }
        let of = self.transition_mut(number).ok_or(Refusal::NotThere)?;
        condition.clone_into(&mut of.condition);
        Ok(Id::Transition(number))
    }

    /// The step that a transition enters; of several, the one that a jump names.
    pub(super) fn lead(&mut self, id: Id, to: &str) -> Result<Id, Refusal> {
        let number = self.transition_of(id)?;
        let step = self.step(to.trim()).ok_or(Refusal::NotThere)?;
        let name = self.steps[step].name.clone();
        let of = self.transition_mut(number).ok_or(Refusal::NotThere)?;
        match id {
            Id::Jump(_, nth) if nth < of.to.len() => of.to[nth] = name,
            _ => of.to = vec![name],
        }
        Ok(Id::Transition(number))
    }

    pub(super) fn priority(&mut self, id: Id, priority: Option<u32>) -> Result<Id, Refusal> {
        let number = self.transition_of(id)?;
        let of = self.transition_mut(number).ok_or(Refusal::NotThere)?;
        of.priority = priority;
        Ok(Id::Transition(number))
    }

    pub(super) fn initial(&mut self, id: Id) -> Result<Id, Refusal> {
        let (number, _) = self.step_of(id)?;
        for step in 0..self.steps.len() {
            let is = step == number;
            if self.steps[step].initial != is {
                let of = self.step_mut(step).ok_or(Refusal::NotThere)?;
                of.initial = is;
            }
        }
        Ok(Id::Step(number))
    }

    /// What a step does; an action without a body that nothing names any longer goes.
    pub(super) fn does(
        &mut self,
        id: Id,
        action: &str,
        qualifier: Qualifier,
        time: Option<&str>,
    ) -> Result<Id, Refusal> {
        let Id::Does(step, nth) = id else {
            return Err(Refusal::SelectStep);
        };
        let action = action.trim();
        if !is_name(action) && !action.starts_with('%') {
            return Err(Refusal::NoName);
        }
        let time = time.map(str::trim).filter(|time| !time.is_empty());
        if qualifier.is_timed() && time.is_none() {
            return Err(Refusal::Missing);
        }
        let of = self.step_mut(step).ok_or(Refusal::NotThere)?;
        let does = of.does.get_mut(nth).ok_or(Refusal::NotThere)?;
        let old = std::mem::replace(&mut does.action, action.to_owned());
        does.qualifier = qualifier;
        does.time = time.filter(|_| qualifier.is_timed()).map(str::to_owned);
        let mut all = self.steps.iter().flat_map(|step| &step.does);
        if !all.any(|does| same(&does.action, &old))
            && let Some(number) = self.action(&old)
            && self.actions[number].body.trim().is_empty()
        {
            self.remove_action(number);
        }
        Ok(id)
    }

    /// The statements of an action; a variable becomes an action of its own by them.
    pub(super) fn body(&mut self, action: &str, body: &str) -> Result<Id, Refusal> {
        let number = match self.action(action) {
            Some(number) => number,
            None if is_name(action) => self.add_action(Action {
                name: action.to_owned(),
                ..Action::default()
            }),
            None => return Err(Refusal::NoName),
        };
        let of = self.action_mut(number).ok_or(Refusal::NotThere)?;
        body.trim_end().clone_into(&mut of.body);
        let steps = self.steps.iter().enumerate();
        let mut uses = steps.flat_map(|(step, of)| {
            let does = of.does.iter().enumerate();
            does.map(move |(nth, does)| (step, nth, does))
        });
        let used = uses.find(|(_, _, does)| same(&does.action, action));
        Ok(used.map_or(Id::Step(0), |(step, nth, _)| Id::Does(step, nth)))
    }

    /// Of the transitions that leave the same step, one changes places with its neighbour.
    pub(super) fn moved(&mut self, id: Id, side: Side) -> Result<Id, Refusal> {
        let number = self.transition_of(id)?;
        let from = self.transitions[number].from.first().cloned();
        let all = self.leaving(&from.unwrap_or_default());
        let own = all
            .iter()
            .position(|of| *of == number)
            .ok_or(Refusal::NotThere)?;
        let other = match side {
            Side::Left => own.checked_sub(1),
            Side::Right => Some(own + 1),
        };
        let other = other.and_then(|at| all.get(at)).copied();
        let other = other.ok_or(Refusal::NoFurther)?;
        self.transitions.swap(number, other);
        Ok(Id::Transition(other))
    }
}
