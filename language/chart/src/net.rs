//! A chart by numbers: its names are looked up, and what is wrong with them is told.
//!
//! Owns which names clash or lead nowhere, and that each chart of a text has one initial step.

use crate::{Chart, Name, Qualifier};
use std::collections::{HashMap, HashSet};
use unoclp_text::diagnostics::{Code, Span};
use unoclp_text::near::nearest;
use unoclp_tree::build::{Builder, both};

/// For more wrong names than this, no near one is looked for.
const MOST_NEAR: u32 = 32;

/// Nor among more names than these.
const MOST_NAMES: usize = 4_000;

/// The net of a chart.
#[derive(Clone, Debug)]
pub struct Net {
    /// Its steps.
    pub(crate) steps: Vec<Node>,
    /// Its transitions, as they were given.
    pub(crate) transitions: Vec<Arc>,
    /// The numbers of the transitions: one that goes before another stands before it.
    pub(crate) turns: Vec<u32>,
    /// Its actions, and the variables that are actions, in the order in which steps name them.
    pub(crate) actions: Vec<Control>,
}

#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub name: Name,
    pub initial: bool,
    /// The transitions that leave it, in their turn.
    pub leave: Vec<u32>,
}

#[derive(Clone, Debug)]
pub(crate) struct Arc {
    /// The steps that have to be active.
    pub from: Vec<u32>,
    /// Those among them that it does not enter.
    pub leaves: Vec<u32>,
    /// The steps that it enters and does not leave.
    pub enters: Vec<u32>,
    pub at: Span,
}

impl Arc {
    fn new(from: Vec<u32>, to: Vec<u32>, at: Span) -> Arc {
        let without = |all: &[u32], others: &[u32]| {
            let others: HashSet<u32> = others.iter().copied().collect();
            let left = all.iter().copied();
            left.filter(|step| !others.contains(step)).collect()
        };
        Arc {
            leaves: without(&from, &to),
            enters: without(&to, &from),
            from,
            at,
        }
    }
}

/// An action, and what the steps do with it.
#[derive(Clone, Debug)]
pub(crate) struct Control {
    pub name: Name,
    /// The action of the chart; none of a variable.
    pub body: Option<usize>,
    pub does: Vec<Cause>,
}

/// What one step does with an action.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cause {
    pub step: u32,
    /// Its number among what the step does.
    pub nth: usize,
    pub qualifier: Qualifier,
    pub at: Span,
}

/// The names of one kind, in the order in which they were declared.
struct Names<'c> {
    by: HashMap<String, u32>,
    all: Vec<&'c str>,
    asked: u32,
}

impl<'c> Names<'c> {
    fn of(builder: &Builder<'_, '_>, all: impl Iterator<Item = &'c Name>) -> Names<'c> {
        let (mut by, mut names) = (HashMap::new(), Vec::new());
        for (number, name) in (0..).zip(all) {
            by.entry(builder.key(&name.text)).or_insert(number);
            names.push(name.text.as_str());
        }
        let asked = 0;
        let all = names;
        Names { by, all, asked }
    }

    fn near(&mut self, name: &str) -> Option<&'c str> {
        self.asked += 1;
        let few = self.asked <= MOST_NEAR && self.all.len() <= MOST_NAMES;
        few.then(|| nearest(name, self.all.iter().copied()))?
    }
}

impl Net {
    /// The net of a chart, as far as its names lead somewhere; what is wrong is told.
    pub fn of<C, A>(chart: &Chart<C, A>, builder: &mut Builder<'_, '_>) -> Net {
        let mut steps = Names::of(builder, chart.steps.iter().map(|step| &step.name));
        let mut transitions = Vec::with_capacity(chart.transitions.len());
        for transition in &chart.transitions {
            let from = ends(&transition.from, &mut steps, builder);
            let to = ends(&transition.to, &mut steps, builder);
            transitions.push(Arc::new(from, to, transition.at));
        }
        let nodes = chart.steps.iter().map(|step| Node {
            name: step.name.clone(),
            initial: step.initial,
            leave: Vec::new(),
        });
        let mut turns: Vec<u32> = (0..transitions.len() as u32).collect();
        turns.sort_by_key(|turn| {
            let transition = chart.transitions.get(*turn as usize);
            let priority = transition.and_then(|transition| transition.priority);
            priority.map_or(u64::MAX, u64::from)
        });
        let mut net = Net {
            steps: nodes.collect(),
            transitions,
            turns,
            actions: Vec::new(),
        };
        for &turn in &net.turns {
            for &step in &net.transitions[turn as usize].from {
                net.steps[step as usize].leave.push(turn);
            }
        }
        net.controls(chart, builder);
        net.name_transitions(chart, builder);
        net.initials(chart.at, builder);
        net
    }

    /// Which action each step names.
    fn controls<C, A>(&mut self, chart: &Chart<C, A>, builder: &mut Builder<'_, '_>) {
        let actions = Names::of(builder, chart.actions.iter().map(|action| &action.name));
        let mut numbers: HashMap<String, usize> = HashMap::new();
        for (step, of) in (0..).zip(&chart.steps) {
            for (nth, does) in of.does.iter().enumerate() {
                let key = builder.key(&does.action.text);
                let body = actions.by.get(&key).map(|number| *number as usize);
                let new = self.actions.len();
                let number = *numbers.entry(key).or_insert(new);
                if number == new {
                    let own = body.and_then(|body| chart.actions.get(body));
                    self.actions.push(Control {
                        name: own.map_or(&does.action, |own| &own.name).clone(),
                        body,
                        does: Vec::new(),
                    });
                }
                self.actions[number].does.push(Cause {
                    step,
                    nth,
                    qualifier: does.qualifier,
                    at: does.action.at,
                });
            }
        }
        let used: HashSet<usize> = self.actions.iter().filter_map(|of| of.body).collect();
        for (body, action) in chart.actions.iter().enumerate() {
            if used.contains(&body) {
                continue;
            }
            // Its name is known all the same.
            let name = action.name.clone();
            if !numbers.contains_key(&builder.key(&name.text)) {
                let words = [name.text.as_str().into()];
                builder.tell(Code::StActionUnused, name.at, words);
            }
            self.actions.push(Control {
                name,
                body: Some(body),
                does: Vec::new(),
            });
        }
    }

    /// Transitions have names of their own.
    fn name_transitions<C, A>(&self, chart: &Chart<C, A>, builder: &mut Builder<'_, '_>) {
        let steps = chart.steps.iter().map(|step| &step.name);
        let actions = chart.actions.iter().map(|action| &action.name);
        let named = steps.chain(actions);
        let mut taken: HashSet<String> = named.map(|name| builder.key(&name.text)).collect();
        for name in chart.transitions.iter().filter_map(|one| one.name.as_ref()) {
            let is_new = taken.insert(builder.key(&name.text));
            if !is_new || builder.is_taken(&name.text) {
                builder.tell(Code::StNameTwice, name.at, [name.text.as_str().into()]);
            }
        }
    }

    /// Steps that transitions join are one chart, and that has one initial step.
    fn initials(&self, at: Span, builder: &mut Builder<'_, '_>) {
        if self.steps.is_empty() {
            builder.tell(Code::StNoInitialStep, at, []);
            return;
        }
        let mut groups = Groups::new(self.steps.len());
        for arc in &self.transitions {
            let mut ends = arc.from.iter().chain(&arc.enters);
            let Some(first) = ends.next() else { continue };
            ends.for_each(|end| groups.join(*first, *end));
        }
        let mut first: HashMap<u32, u32> = HashMap::new();
        for (number, step) in (0..).zip(&self.steps) {
            if !step.initial {
                continue;
            }
            let one = *first.entry(groups.of(number)).or_insert(number);
            if one != number {
                let before = &self.steps[one as usize].name.text;
                let words = [before.as_str().into(), step.name.text.as_str().into()];
                builder.tell(Code::StTwoInitialSteps, step.name.at, words);
            }
        }
        if first.is_empty() {
            builder.tell(Code::StNoInitialStep, self.steps[0].name.at, []);
        }
    }
}

/// The steps of these names, each once.
fn ends(names: &[Name], steps: &mut Names<'_>, builder: &mut Builder<'_, '_>) -> Vec<u32> {
    let mut all = Vec::with_capacity(names.len());
    let mut taken = HashSet::new();
    for name in names {
        let Some(&step) = steps.by.get(&builder.key(&name.text)) else {
            let help = match steps.near(&name.text) {
                Some(near) => both(
                    format!("did you mean {near}?"),
                    format!("você quis dizer {near}?"),
                ),
                None => both(
                    format!("write it: STEP {}: END_STEP", name.text),
                    format!("escreva-a: STEP {}: END_STEP", name.text),
                ),
            };
            builder.tell(Code::StNoStep, name.at, [name.text.as_str().into(), help]);
            continue;
        };
        if !taken.insert(step) {
            builder.tell(Code::StStepTwice, name.at, [name.text.as_str().into()]);
            continue;
        }
        all.push(step);
    }
    all
}

/// Which steps hang together.
struct Groups(Vec<u32>);

impl Groups {
    fn new(count: usize) -> Groups {
        Groups((0..count as u32).collect())
    }

    fn of(&mut self, mut step: u32) -> u32 {
        while self.0[step as usize] != step {
            let above = self.0[self.0[step as usize] as usize];
            self.0[step as usize] = above;
            step = above;
        }
        step
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.of(a), self.of(b));
        let (low, high) = (a.min(b), a.max(b));
        self.0[high as usize] = low;
    }
}
