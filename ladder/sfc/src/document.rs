//! A chart with its text.
//!
//! Owns that what nobody changes stays in the text as it was written, with its comments.

use std::fmt::Write as _;
use std::ops::Range;
use unoclp_chart::Qualifier;
use unoclp_lang::Span;
use unoclp_lang::parts::{self, Unit, Written};

/// A chart of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Document {
    /// The unit that it is the body of.
    pub unit: String,
    /// Its steps.
    pub steps: Vec<Step>,
    /// Its transitions, from left to right.
    pub transitions: Vec<Transition>,
    /// Its actions; a BOOL variable is one without standing here.
    pub actions: Vec<Action>,
    /// Its parts in the order of the text, each with what stands before it.
    order: Vec<(Part, String)>,
    /// The text before the chart, and after it.
    around: (String, String),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Step(usize),
    Transition(usize),
    Action(usize),
}

/// Where the parts of a chart stand in its text, in bytes, by their numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Places {
    /// Its steps.
    pub steps: Vec<Range<usize>>,
    /// Its transitions.
    pub transitions: Vec<Range<usize>>,
    /// Its actions.
    pub actions: Vec<Range<usize>>,
}

/// A step.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Step {
    /// Its name.
    pub name: String,
    /// Whether it is active at first.
    pub initial: bool,
    /// What it does.
    pub does: Vec<Does>,
    /// Its comment, where one stands right before it or at the end of its line.
    pub comment: String,
    pub(crate) written: Option<String>,
}

/// What a step does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Does {
    /// The action, or a BOOL variable.
    pub action: String,
    /// When.
    pub qualifier: Qualifier,
    /// The time, as it is written.
    pub time: Option<String>,
}

/// A transition.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Transition {
    /// Its name, if it has one.
    pub name: Option<String>,
    /// Of those that leave one step, the one with the lowest number goes first.
    pub priority: Option<u32>,
    /// The steps that it leaves.
    pub from: Vec<String>,
    /// The steps that it enters.
    pub to: Vec<String>,
    /// Its condition, as it is written.
    pub condition: String,
    pub(crate) written: Option<String>,
}

/// An action.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Action {
    /// Its name.
    pub name: String,
    /// Its statements, as they are written.
    pub body: String,
    pub(crate) written: Option<String>,
}

/// As names are compared.
pub(crate) fn key(name: &str) -> String {
    name.to_uppercase()
}

/// Whether two names are one.
pub(crate) fn same(one: &str, other: &str) -> bool {
    one.eq_ignore_ascii_case(other) || key(one) == key(other)
}

impl Document {
    /// The charts of a text in Structured Text, in its order.
    pub fn all(text: &str) -> Vec<Document> {
        if !parts::may_hold_chart(text) {
            return Vec::new();
        }
        let parts = parts::parts(text);
        let charts = parts.units.iter();
        charts.filter_map(|unit| Document::of(text, unit)).collect()
    }

    fn of(text: &str, unit: &Unit) -> Option<Document> {
        let written = unit.chart.as_ref()?;
        let mut document = Document::read(text, written);
        document.unit = unit.name.text.clone();
        Some(document)
    }

    fn read(text: &str, written: &Written) -> Document {
        let said = |span: Span| text.get(span.range()).unwrap_or_default().to_owned();
        let names = |all: &[unoclp_chart::Name]| all.iter().map(|name| name.text.clone()).collect();
        let chart = &written.chart;
        let steps = chart.steps.iter().zip(&written.steps);
        let steps = steps.map(|(step, at)| Step {
            name: step.name.text.clone(),
            initial: step.initial,
            does: step
                .does
                .iter()
                .map(|does| Does {
                    action: does.action.text.clone(),
                    qualifier: does.qualifier,
                    time: does.time.map(said),
                })
                .collect(),
            comment: String::new(),
            written: Some(said(*at)),
        });
        let transitions = chart.transitions.iter().zip(&written.transitions);
        let transitions = transitions.map(|(transition, at)| Transition {
            name: transition.name.as_ref().map(|name| name.text.clone()),
            priority: transition.priority,
            from: names(&transition.from),
            to: names(&transition.to),
            condition: said(transition.condition),
            written: Some(said(*at)),
        });
        let actions = chart.actions.iter().zip(&written.actions);
        let actions = actions.map(|(action, at)| Action {
            name: action.name.text.clone(),
            body: trimmed(&said(action.body)),
            written: Some(said(*at)),
        });
        let mut document = Document {
            steps: steps.collect(),
            transitions: transitions.collect(),
            actions: actions.collect(),
            ..Document::default()
        };
        document.place(text, written);
        document
    }

    /// Notes what stands between the parts.
    fn place(&mut self, text: &str, written: &Written) {
        let all = |spans: &[Span], part: fn(usize) -> Part| {
            let all = spans.iter().enumerate();
            let all = all.map(|(number, span)| (*span, part(number)));
            all.collect::<Vec<_>>()
        };
        let mut parts = all(&written.steps, Part::Step);
        parts.extend(all(&written.transitions, Part::Transition));
        parts.extend(all(&written.actions, Part::Action));
        parts.sort_by_key(|(span, _)| span.start);
        let mut at = parts.first().map_or(0, |(span, _)| span.start as usize);
        self.around.0 = text.get(..at).unwrap_or_default().to_owned();
        for (span, part) in parts {
            let between = text.get(at..span.start as usize).unwrap_or_default();
            if let Part::Step(step) = part {
                self.steps[step].comment = comment(match self.order.is_empty() {
                    true => &self.around.0,
                    false => between,
                });
            }
            self.order.push((part, between.to_owned()));
            at = at.max(span.end as usize);
        }
        self.around.1 = text.get(at..).unwrap_or_default().to_owned();
    }

    /// The whole text, with the chart as it is now.
    pub fn text(&self) -> String {
        let mut text = self.around.0.clone();
        for (part, before) in &self.order {
            text.push_str(before);
            self.write(*part, &mut text);
        }
        text.push_str(&self.around.1);
        text
    }

    /// Where its parts stand in its text.
    pub fn places(&self) -> Places {
        let nowhere = |parts: usize| vec![0..0; parts];
        let mut places = Places {
            steps: nowhere(self.steps.len()),
            transitions: nowhere(self.transitions.len()),
            actions: nowhere(self.actions.len()),
        };
        let mut text = self.around.0.clone();
        for (part, before) in &self.order {
            text.push_str(before);
            let start = text.len();
            self.write(*part, &mut text);
            let place = match *part {
                Part::Step(number) => places.steps.get_mut(number),
                Part::Transition(number) => places.transitions.get_mut(number),
                Part::Action(number) => places.actions.get_mut(number),
            };
            if let Some(place) = place {
                *place = start..text.len();
            }
        }
        places
    }

    fn write(&self, part: Part, to: &mut String) {
        match part {
            Part::Step(number) => self.steps[number].write(to),
            Part::Transition(number) => self.transitions[number].write(to),
            Part::Action(number) => self.actions[number].write(to),
        }
    }

    /// The number of the step with this name.
    pub fn step(&self, name: &str) -> Option<usize> {
        self.steps.iter().position(|step| same(&step.name, name))
    }

    /// The number of the action with this name.
    pub fn action(&self, name: &str) -> Option<usize> {
        self.actions
            .iter()
            .position(|action| same(&action.name, name))
    }

    /// The step, to be changed.
    pub(crate) fn step_mut(&mut self, number: usize) -> Option<&mut Step> {
        let step = self.steps.get_mut(number)?;
        step.written = None;
        Some(step)
    }

    /// The transition, to be changed.
    pub(crate) fn transition_mut(&mut self, number: usize) -> Option<&mut Transition> {
        let transition = self.transitions.get_mut(number)?;
        transition.written = None;
        Some(transition)
    }

    /// The action, to be changed.
    pub(crate) fn action_mut(&mut self, number: usize) -> Option<&mut Action> {
        let action = self.actions.get_mut(number)?;
        action.written = None;
        Some(action)
    }

    /// Adds a step after the others; its number.
    pub(crate) fn add_step(&mut self, step: Step) -> usize {
        let number = self.steps.len();
        self.steps.push(step);
        self.insert(Part::Step(number), |part| matches!(part, Part::Step(_)));
        number
    }

    /// Adds a transition that stands at this place among the others: those from there on count one more.
    pub(crate) fn add_transition(&mut self, at: usize, transition: Transition) -> usize {
        let at = at.min(self.transitions.len());
        self.transitions.insert(at, transition);
        for (part, _) in &mut self.order {
            if let Part::Transition(number) = part {
                *number += usize::from(*number >= at);
            }
        }
        let place = self
            .order
            .iter()
            .position(|(part, _)| *part == Part::Transition(at + 1));
        match place {
            // What stands before that one stays with it.
            Some(place) => self
                .order
                .insert(place, (Part::Transition(at), self.new_line())),
            None => self.insert(Part::Transition(at), |part| {
                !matches!(part, Part::Action(_))
            }),
        }
        at
    }

    /// Adds an action after the others; its number.
    pub(crate) fn add_action(&mut self, action: Action) -> usize {
        let number = self.actions.len();
        self.actions.push(action);
        self.insert(Part::Action(number), |_| true);
        number
    }

    /// Puts a part after the last one of these.
    fn insert(&mut self, part: Part, follows: impl Fn(&Part) -> bool) {
        let last = self.order.iter().rposition(|(other, _)| follows(other));
        let place = last.map_or(0, |last| last + 1);
        let before = self.new_line();
        if place == 0
            && let Some((_, first)) = self.order.first_mut()
        {
            first.clone_from(&before);
            self.order.insert(0, (part, String::new()));
            return;
        }
        self.order.insert(place, (part, before));
    }

    /// A new line, indented as the others.
    fn new_line(&self) -> String {
        let mut all = self.order.iter().skip(1).map(|(_, before)| before);
        let line = all.find_map(|before| before.rsplit_once('\n'));
        let indent = line.map_or("", |(_, indent)| indent);
        match indent.trim().is_empty() {
            true => format!("\n{indent}"),
            false => "\n".to_owned(),
        }
    }

    /// Takes a step away; those after it count one less.
    pub(crate) fn remove_step(&mut self, number: usize) {
        self.steps.remove(number);
        self.forget(Part::Step(number), |part| match part {
            Part::Step(other) => Some(other),
            _ => None,
        });
    }

    /// Takes a transition away; those after it count one less.
    pub(crate) fn remove_transition(&mut self, number: usize) {
        self.transitions.remove(number);
        self.forget(Part::Transition(number), |part| match part {
            Part::Transition(other) => Some(other),
            _ => None,
        });
    }

    /// Takes an action away; those after it count one less.
    pub(crate) fn remove_action(&mut self, number: usize) {
        self.actions.remove(number);
        self.forget(Part::Action(number), |part| match part {
            Part::Action(other) => Some(other),
            _ => None,
        });
    }

    fn forget(&mut self, gone: Part, number: impl Fn(&mut Part) -> Option<&mut usize>) {
        let Some(place) = self.order.iter().position(|(part, _)| *part == gone) else {
            return;
        };
        let (mut part, before) = self.order.remove(place);
        let Some(gone) = number(&mut part).copied() else {
            return;
        };
        // What stands before the first part stays where it is.
        if place == 0
            && let Some((_, first)) = self.order.first_mut()
        {
            *first = before;
        }
        for (part, _) in &mut self.order {
            if let Some(other) = number(part) {
                *other -= usize::from(*other > gone);
            }
        }
    }
}

/// The last comment of what stands before a part, without its signs, if the part is what it is about.
fn comment(before: &str) -> String {
    let own = before.trim_end();
    let is_near = before
        .get(own.len()..)
        .is_some_and(|rest| rest.matches('\n').count() <= 1);
    let said = match own.strip_suffix("*)") {
        Some(inner) => inner.rsplit_once("(*").map(|(_, said)| said),
        None => own
            .lines()
            .next_back()
            .and_then(|line| line.split_once("//"))
            .map(|(_, said)| said),
    };
    let said = said.filter(|_| is_near).unwrap_or_default();
    let words: Vec<&str> = said.split_whitespace().collect();
    words.join(" ")
}

/// Statements without empty lines around them, and without the indentation that they share.
fn trimmed(body: &str) -> String {
    let body = body.trim_end();
    let body = body.strip_prefix('\n').unwrap_or(body);
    if !body.contains('\n') {
        return body.trim_start().to_owned();
    }
    let lines = || body.lines().filter(|line| !line.trim().is_empty());
    let indent = |line: &str| line.len() - line.trim_start_matches([' ', '\t']).len();
    let least = lines().map(indent).min().unwrap_or(0);
    let lines = body
        .lines()
        .map(|line| line.get(least..).unwrap_or_default());
    let lines: Vec<&str> = lines.collect();
    lines.join("\n").trim_matches('\n').to_owned()
}

impl Does {
    /// `valve(N)`, `lamp(L, T#5s)`
    pub fn written(&self) -> String {
        let Does {
            action,
            qualifier,
            time,
        } = self;
        match time {
            Some(time) => format!("{action}({}, {time})", qualifier.name()),
            None => format!("{action}({})", qualifier.name()),
        }
    }
}

impl Step {
    fn write(&self, to: &mut String) {
        if let Some(written) = &self.written {
            return to.push_str(written);
        }
        let word = if self.initial { "INITIAL_STEP" } else { "STEP" };
        let _ = write!(to, "{word} {}:", self.name);
        for does in &self.does {
            let _ = write!(to, " {};", does.written());
        }
        to.push_str(" END_STEP");
    }
}

impl Transition {
    fn write(&self, to: &mut String) {
        if let Some(written) = &self.written {
            return to.push_str(written);
        }
        to.push_str("TRANSITION ");
        if let Some(name) = &self.name {
            let _ = write!(to, "{name} ");
        }
        if let Some(priority) = self.priority {
            let _ = write!(to, "(PRIORITY := {priority}) ");
        }
        let (from, enters) = (list(&self.from), list(&self.to));
        let condition = self.condition.trim();
        let _ = write!(to, "FROM {from} TO {enters} := {condition}; END_TRANSITION");
    }
}

impl Action {
    fn write(&self, to: &mut String) {
        if let Some(written) = &self.written {
            return to.push_str(written);
        }
        let _ = match self.body.contains('\n') || self.body.contains("//") {
            false => write!(to, "ACTION {}: {} END_ACTION", self.name, self.body.trim()),
            true => {
                let lines = self.body.lines().map(|line| format!("  {line}\n"));
                let lines: String = lines.collect();
                write!(to, "ACTION {}:\n{lines}END_ACTION", self.name)
            }
        };
    }
}

/// `a`, or `(a, b)`
pub(crate) fn list(names: &[String]) -> String {
    match names {
        [one] => one.clone(),
        all => format!("({})", all.join(", ")),
    }
}
