//! What is taken out of a chart, and what goes with it.

use super::operation::Refusal;
use crate::document::{Document, same};
use crate::net::Net;
use crate::sheet::Id;

impl Document {
    pub(super) fn remove(&mut self, id: Id) -> Result<Id, Refusal> {
        match id {
            Id::Step(number) => self.remove_whole_step(number),
            Id::Does(step, nth) => {
                let of = self.step_mut(step).ok_or(Refusal::NotThere)?;
                if nth >= of.does.len() {
                    return Err(Refusal::NotThere);
                }
                let gone = of.does.remove(nth).action;
                self.forget_action(&gone);
                Ok(Id::Step(step))
            }
            Id::Transition(number) | Id::Jump(number, _) | Id::Wait(number, _) => {
                self.remove_whole_transition(number)
            }
        }
    }

    /// An action that nothing asks for any longer and that does nothing goes too.
    fn forget_action(&mut self, name: &str) {
        let mut does = self.steps.iter().flat_map(|step| &step.does);
        if does.any(|does| same(&does.action, name)) {
            return;
        }
        if let Some(number) = self.action(name)
            && self.actions[number].body.trim().is_empty()
        {
            self.remove_action(number);
        }
    }

    /// A step goes with the transition after it: what leads to it leads to where that led.
    fn remove_whole_step(&mut self, number: usize) -> Result<Id, Refusal> {
        if number >= self.steps.len() {
            return Err(Refusal::NotThere);
        }
        if self.steps.len() == 1 {
            return Err(Refusal::LastStep);
        }
        let name = self.steps[number].name.clone();
        let leaving = self.leaving(&name);
        let beside = leaving
            .iter()
            .all(|of| self.transitions[*of].from.len() > 1);
        let to = leaving.first().map(|of| self.transitions[*of].to.clone());
        let to = to
            .filter(|_| !beside || leaving.is_empty())
            .unwrap_or_default();
        let to: Vec<String> = to.into_iter().filter(|to| !same(to, &name)).collect();
        let was = self.reached();
        for transition in self.entering(&name) {
            let of = self.transition_mut(transition).ok_or(Refusal::NotThere)?;
            let at = of.to.iter().position(|to| same(to, &name)).unwrap_or(0);
            of.to.retain(|to| !same(to, &name));
            if of.to.is_empty() {
                for (nth, to) in to.iter().enumerate() {
                    of.to.insert((at + nth).min(of.to.len()), to.clone());
                }
            }
        }
        for transition in leaving.into_iter().rev() {
            let of = self.transition_mut(transition).ok_or(Refusal::NotThere)?;
            of.from.retain(|from| !same(from, &name));
            if of.from.is_empty() {
                self.remove_transition(transition);
            }
        }
        // What leads nowhere now.
        for transition in (0..self.transitions.len()).rev() {
            if self.transitions[transition].to.is_empty() {
                self.remove_transition(transition);
            }
        }
        let initial = self.steps[number].initial;
        self.remove_step(number);
        let next = to.first().and_then(|to| self.step(to)).unwrap_or(0);
        if initial {
            let first = self.step_mut(next).ok_or(Refusal::NotThere)?;
            first.initial = true;
        }
        self.sweep(&was, &name);
        let last = self.steps.len() - 1;
        Ok(Id::Step(next.min(last)))
    }

    /// A transition goes with what only it leads to.
    fn remove_whole_transition(&mut self, number: usize) -> Result<Id, Refusal> {
        let of = self.transitions.get(number).ok_or(Refusal::NotThere)?;
        let before = of.from.first().cloned().unwrap_or_default();
        let was = self.reached();
        self.remove_transition(number);
        self.sweep(&was, "");
        Ok(Id::Step(self.step(&before).unwrap_or(0)))
    }

    /// The names of the steps that something leads to.
    fn reached(&self) -> Vec<String> {
        let net = Net::of(self);
        let mut seen: Vec<bool> = self.steps.iter().map(|step| step.initial).collect();
        let steps = 0..seen.len();
        let mut open: Vec<usize> = steps.filter(|step| seen[*step]).collect();
        while let Some(step) = open.pop() {
            let to = net.leave[step]
                .iter()
                .flat_map(|transition| &net.to[*transition]);
            for to in to.flatten() {
                if !std::mem::replace(&mut seen[*to], true) {
                    open.push(*to);
                }
            }
        }
        let steps = self.steps.iter().zip(seen);
        let names = steps
            .filter(|(_, seen)| *seen)
            .map(|(step, _)| step.name.clone());
        names.collect()
    }

    /// Takes away the steps that something led to and nothing leads to now, with what leaves them.
    fn sweep(&mut self, was: &[String], gone: &str) {
        let now = self.reached();
        let lost = was
            .iter()
            .filter(|name| !now.contains(name) && !same(name, gone));
        for name in lost {
            for transition in self.leaving(name).into_iter().rev() {
                let Some(of) = self.transition_mut(transition) else {
                    continue;
                };
                of.from.retain(|from| !same(from, name));
                if of.from.is_empty() {
                    self.remove_transition(transition);
                }
            }
            if let Some(step) = self.step(name).filter(|_| self.steps.len() > 1) {
                let does = self.steps[step].does.clone();
                self.remove_step(step);
                does.iter()
                    .for_each(|does| self.forget_action(&does.action));
            }
        }
    }
}
