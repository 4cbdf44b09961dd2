//! The steps of a chart, and the transitions between them.

use super::branches::Branches;
use super::written::{Who, tell};
use crate::found::{Found, span};
use crate::project::Pou;
use crate::text::Text;
use crate::xml::{all, first, says};
use roxmltree::Node;
use std::collections::HashMap;
use unoclp_lang::{Code, Span, Word, is_name};

/// A chart by its elements.
pub(crate) struct Net<'a, 'x> {
    /// What the unit is called.
    pub pou: String,
    pub steps: Vec<Step<'a, 'x>>,
    pub transitions: Vec<Transition<'a, 'x>>,
}

pub(crate) struct Step<'a, 'x> {
    pub name: String,
    pub initial: bool,
    pub at: Span,
    /// Its action blocks, from top to bottom.
    pub blocks: Vec<Node<'a, 'x>>,
}

pub(crate) struct Transition<'a, 'x> {
    pub node: Node<'a, 'x>,
    pub at: Span,
    /// The names of the steps, as the chart has them.
    pub from: Vec<String>,
    pub to: Vec<(String, Span)>,
    /// Where the lines to them end.
    ends: Vec<i64>,
    /// Its priority, if it says one.
    pub priority: Option<u32>,
    /// What it is called in a message.
    pub who: Who,
}

/// The number of an attribute.
pub(super) fn number(of: Node<'_, '_>, name: &str) -> i64 {
    let written = of.attribute(name).and_then(|text| text.parse::<f64>().ok());
    written.unwrap_or(0.0) as i64
}

/// Where an element stands: from left to right.
fn left(of: Node<'_, '_>) -> i64 {
    first(of, "position").map_or(0, |at| number(at, "x"))
}

/// A name as a text has it: what no name may hold becomes `_`.
pub(super) fn named(written: &str) -> String {
    let written = written.trim();
    if written.is_empty() || is_name(written) {
        return written.to_owned();
    }
    let sign = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let mut name: String = written.chars().map(sign).collect();
    if name.starts_with(|c: char| c.is_ascii_digit()) {
        name.insert(0, 'S');
    }
    match is_name(&name) {
        true => name,
        false => format!("{name}_1"),
    }
}

impl<'a, 'x: 'a> Net<'a, 'x> {
    /// The chart of a body; what leads nowhere is told.
    pub(super) fn read(pou: &Pou<'a, 'x>, body: Node<'a, 'x>, found: &mut Found) -> Net<'a, 'x> {
        let mut net = Net {
            pou: pou.name.clone(),
            steps: Vec::new(),
            transitions: Vec::new(),
        };
        let elements: Vec<Node<'_, '_>> = body.children().filter(Node::is_element).collect();
        let mut branches = Branches::of(&elements);
        let mut steps = HashMap::new();
        for (at, node) in elements.iter().enumerate() {
            match node.tag_name().name() {
                "step" => {
                    steps.insert(at, net.steps.len());
                    net.step(*node, found);
                }
                "macroStep" => {
                    let who = net.who("macro step", "macroetapa", node.attribute("name"));
                    tell(found, Code::XmlMacro, who, span(*node), []);
                }
                _ => {}
            }
        }
        let mut transitions = HashMap::new();
        for (at, node) in elements.iter().enumerate() {
            if node.tag_name().name() == "transition" {
                transitions.insert(at, net.transitions.len());
                let from = branches.before(at, "step");
                net.transition_from(*node, from.iter().filter_map(|at| steps.get(at)).copied());
            }
        }
        for (at, node) in elements.iter().enumerate() {
            let to = match node.tag_name().name() {
                "step" => net.steps[steps[&at]].name.clone(),
                "jumpStep" => named(node.attribute("targetName").unwrap_or_default()),
                "actionBlock" => {
                    net.block(*node, branches.before(at, "step"), &steps, found);
                    continue;
                }
                _ => continue,
            };
            for before in branches.before(at, "transition") {
                if let Some(number) = transitions.get(&before) {
                    let transition = &mut net.transitions[*number];
                    // From left to right.
                    let place = transition.ends.partition_point(|x| *x <= left(*node));
                    transition.ends.insert(place, left(*node));
                    transition.to.insert(place, (to.clone(), span(*node)));
                }
            }
        }
        net.check(found);
        net.order(&elements, &branches);
        net
    }

    /// What an element is called in a message.
    fn who(&self, en: &str, pt: &str, name: Option<&str>) -> Who {
        let pou = &self.pou;
        match name.filter(|name| !name.is_empty()) {
            Some(name) => (
                format!("`{pou}`, {en} `{name}`"),
                format!("`{pou}`, {pt} `{name}`"),
            ),
            None => (format!("`{pou}`, {en}"), format!("`{pou}`, {pt}")),
        }
    }

    fn step(&mut self, node: Node<'a, 'x>, found: &mut Found) {
        let written = node.attribute("name").unwrap_or_default();
        let name = match named(written) {
            name if name.is_empty() => {
                let who = self.who("a step", "uma etapa", None);
                tell(found, Code::XmlNameless, who, span(node), []);
                format!("step_{}", self.steps.len())
            }
            name => name,
        };
        self.steps.push(Step {
            name,
            initial: says(node, "initialStep"),
            at: span(node),
            blocks: Vec::new(),
        });
    }

    fn transition_from(&mut self, node: Node<'a, 'x>, from: impl Iterator<Item = usize>) {
        let mut names: Vec<String> = Vec::new();
        for step in from {
            let name = &self.steps[step].name;
            if !names.contains(name) {
                names.push(name.clone());
            }
        }
        let written = reference(node).or_else(|| node.attribute("name"));
        let who = match written.filter(|name| !name.is_empty()) {
            Some(name) => self.who("transition", "transição", Some(name)),
            None if names.is_empty() => self.who("a transition", "uma transição", None),
            None => self.who(
                "transition after",
                "transição depois de",
                names.first().map(|n| &**n),
            ),
        };
        let priority = node
            .attribute("priority")
            .and_then(|text| text.parse().ok());
        self.transitions.push(Transition {
            node,
            at: span(node),
            from: names,
            to: Vec::new(),
            ends: Vec::new(),
            priority: priority.filter(|priority| *priority > 0),
            who,
        });
    }

    /// The action block of a step.
    fn block(
        &mut self,
        node: Node<'a, 'x>,
        before: Vec<usize>,
        steps: &HashMap<usize, usize>,
        found: &mut Found,
    ) {
        let step = before.first().and_then(|at| steps.get(at));
        match step {
            Some(step) => self.steps[*step].blocks.push(node),
            None if all(node, "action").next().is_some() => {
                let names = all(node, "action").find_map(reference);
                let who = self.who("actions", "ações", names);
                tell(found, Code::XmlUnjoined, who, span(node), [BEFORE.into()]);
            }
            None => {}
        }
    }

    /// Tells which transitions lead nowhere, or come from nowhere.
    fn check(&mut self, found: &mut Found) {
        for transition in &self.transitions {
            let lacks: Word = match () {
                () if transition.from.is_empty() => BEFORE.into(),
                () if transition.to.is_empty() => BEHIND.into(),
                () => continue,
            };
            let (who, at) = (transition.who.clone(), transition.at);
            tell(found, Code::XmlUnjoined, who, at, [lacks]);
        }
        self.transitions
            .retain(|transition| !transition.from.is_empty() && !transition.to.is_empty());
    }

    /// Of the transitions that leave one step, the one on the left comes first, in the places that they have in the file.
    fn order(&mut self, elements: &[Node<'a, 'x>], branches: &Branches) {
        let at: HashMap<roxmltree::NodeId, usize> = elements
            .iter()
            .enumerate()
            .map(|(at, node)| (node.id(), at))
            .collect();
        let mut groups: HashMap<usize, Vec<usize>> = HashMap::new();
        for (number, transition) in self.transitions.iter().enumerate() {
            let own = at.get(&transition.node.id());
            if let Some(before) = own.and_then(|own| branches.right_before(*own)) {
                groups.entry(before).or_default().push(number);
            }
        }
        let mut places: Vec<usize> = (0..self.transitions.len()).collect();
        for group in groups.values().filter(|group| group.len() > 1) {
            let mut sorted = group.clone();
            sorted.sort_by_key(|number| left(self.transitions[*number].node));
            for (place, number) in group.iter().zip(sorted) {
                places[*place] = number;
            }
        }
        let mut all: Vec<Option<Transition<'a, 'x>>> = std::mem::take(&mut self.transitions)
            .into_iter()
            .map(Some)
            .collect();
        let sorted = places
            .into_iter()
            .filter_map(|place| all.get_mut(place)?.take());
        self.transitions = sorted.collect();
    }

    /// `TRANSITION (PRIORITY := 1) FROM a TO (b, c)`
    pub(super) fn transition(&self, transition: &Transition<'_, '_>, to: &mut Text) {
        let at = transition.at;
        to.piece("TRANSITION ", at);
        if let Some(priority) = transition.priority {
            to.piece(&format!("(PRIORITY := {priority}) "), at);
        }
        to.piece(&format!("FROM ({}) TO (", transition.from.join(", ")), at);
        for (nth, (name, at)) in transition.to.iter().enumerate() {
            to.piece(if nth > 0 { ", " } else { "" }, *at);
            to.piece(name, *at);
        }
        to.piece(") ", at);
    }
}

const BEFORE: (&str, &str) = ("comes before it", "vem antes");
const BEHIND: (&str, &str) = ("comes after it", "vem depois");

/// The name that a condition or an action refers to.
pub(super) fn reference<'a>(of: Node<'a, '_>) -> Option<&'a str> {
    let within = first(of, "condition").unwrap_or(of);
    first(within, "reference")?.attribute("name").map(str::trim)
}
