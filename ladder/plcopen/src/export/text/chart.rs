//! A chart as XML, its steps where they are drawn.

use super::super::xml::escaped;
use std::collections::HashMap;
use std::fmt::Write as _;
use unoclp_sfc::{Document, Id, Look, Outline, Part, Sheet, Transition};

/// The size of a cell in the file.
const CELL: (usize, usize) = (10, 20);

/// The chart of a unit: its body, then its actions and the transitions that have names.
pub(super) fn body(document: &Document, to: &mut String) {
    let outline = Outline::of(document);
    let mut jumps = Vec::new();
    outline.roots.iter().for_each(|root| note(root, &mut jumps));
    let sheet = Sheet::of(document, &outline, Look::Norm);
    let places = sheet.items.iter();
    let places = places.map(|item| (item.id, (item.area.x * CELL.0, item.area.y * CELL.1)));
    let mut drawn = Drawn {
        document,
        places: places.collect(),
        numbers: Numbers::of(document, &jumps),
        jumps,
        text: String::new(),
    };
    drawn.steps();
    drawn.transitions();
    drawn.ends();
    let _ = write!(
        to,
        "        <body>\n          <SFC>\n{}          </SFC>\n        </body>\n",
        drawn.text
    );
    actions(document, to);
    named(document, to);
}

/// Where a chart jumps.
fn note(parts: &[Part], jumps: &mut Vec<(usize, usize)>) {
    for part in parts {
        match part {
            Part::Jump(transition, nth) => jumps.push((*transition, *nth)),
            Part::Fork(fork) => {
                fork.branches
                    .iter()
                    .for_each(|branch| note(&branch.parts, jumps));
            }
            Part::Step(_) | Part::Transition(..) | Part::Wait(..) => {}
        }
    }
}

fn actions(document: &Document, to: &mut String) {
    if document.actions.is_empty() {
        return;
    }
    to.push_str("        <actions>\n");
    for action in &document.actions {
        let (name, body) = (escaped(&action.name), escaped(&action.body));
        let _ = writeln!(
            to,
            "          <action name=\"{name}\"><body><ST><xhtml:p>{body}</xhtml:p></ST></body></action>"
        );
    }
    to.push_str("        </actions>\n");
}

fn named(document: &Document, to: &mut String) {
    let all = document.transitions.iter();
    let all = all.filter_map(|transition| Some((transition.name.as_ref()?, transition)));
    let all: Vec<(&String, &Transition)> = all.collect();
    if all.is_empty() {
        return;
    }
    to.push_str("        <transitions>\n");
    for (name, transition) in all {
        let (name, said) = (escaped(name), escaped(&transition.condition));
        let _ = writeln!(
            to,
            "          <transition name=\"{name}\"><body><ST><xhtml:p>{said}</xhtml:p></ST></body></transition>"
        );
    }
    to.push_str("        </transitions>\n");
}

/// The numbers of what is drawn.
struct Numbers {
    /// Of each step, and of the branch that leaves it where several transitions do.
    steps: Vec<u32>,
    leave: Vec<Option<u32>>,
    /// Of the branch that leads to it, where several transitions do.
    enter: Vec<Option<u32>>,
    /// Of each transition, and of what joins and parts sequences there.
    transitions: Vec<u32>,
    join: Vec<Option<u32>>,
    part: Vec<Option<u32>>,
    next: u32,
}

impl Numbers {
    fn of(document: &Document, jumps: &[(usize, usize)]) -> Numbers {
        let mut next = 0;
        let mut new = || {
            next += 1;
            next
        };
        let steps: Vec<u32> = document.steps.iter().map(|_| new()).collect();
        let transitions: Vec<u32> = document.transitions.iter().map(|_| new()).collect();
        let (mut left, mut entered) = (vec![0; steps.len()], vec![0; steps.len()]);
        for (number, transition) in document.transitions.iter().enumerate() {
            let from = transition
                .from
                .iter()
                .filter_map(|name| document.step(name));
            from.for_each(|step| left[step] += 1);
            for (nth, name) in transition.to.iter().enumerate() {
                if let Some(step) = document.step(name)
                    && !jumps.contains(&(number, nth))
                {
                    entered[step] += 1;
                }
            }
        }
        let several = |counts: Vec<usize>, new: &mut dyn FnMut() -> u32| {
            let counts = counts.into_iter();
            counts
                .map(|count| (count > 1).then(&mut *new))
                .collect::<Vec<_>>()
        };
        let of = |count: fn(&Transition) -> usize| {
            document
                .transitions
                .iter()
                .map(count)
                .collect::<Vec<usize>>()
        };
        Numbers {
            leave: several(left, &mut new),
            enter: several(entered, &mut new),
            join: several(of(|transition| transition.from.len()), &mut new),
            part: several(of(|transition| transition.to.len()), &mut new),
            steps,
            transitions,
            next: next + 1,
        }
    }
}

struct Drawn<'d> {
    document: &'d Document,
    places: HashMap<Id, (usize, usize)>,
    numbers: Numbers,
    jumps: Vec<(usize, usize)>,
    text: String,
}

impl Drawn<'_> {
    fn place(&self, id: Id) -> (usize, usize) {
        self.places.get(&id).copied().unwrap_or_default()
    }

    /// An element that joins or parts lines.
    fn branch(&mut self, kind: &str, number: u32, from: &[u32], (x, y): (usize, usize)) {
        let joins = kind.ends_with("Convergence");
        let lines = from
            .iter()
            .map(|id| format!("<connection refLocalId=\"{id}\"/>"));
        let point = |line: String| format!("<connectionPointIn>{line}</connectionPointIn>");
        let lines: String = match joins {
            true => lines.map(point).collect(),
            false => point(lines.collect()),
        };
        let out = match joins {
            true => "<connectionPointOut/>",
            false => "<connectionPointOut formalParameter=\"\"/>",
        };
        let _ = writeln!(
            self.text,
            "            <{kind} localId=\"{number}\" height=\"1\" width=\"20\"><position x=\"{x}\" y=\"{y}\"/>{lines}{out}</{kind}>"
        );
    }

    /// What leads from a transition to its steps.
    fn source(&self, transition: usize) -> u32 {
        let part = self.numbers.part[transition];
        part.unwrap_or(self.numbers.transitions[transition])
    }

    fn steps(&mut self) {
        let mut sources = vec![Vec::new(); self.document.steps.len()];
        for (transition, of) in self.document.transitions.iter().enumerate() {
            for (nth, name) in of.to.iter().enumerate() {
                let jumps = self.jumps.contains(&(transition, nth));
                if let Some(step) = self.document.step(name).filter(|_| !jumps) {
                    sources[step].push(self.source(transition));
                }
            }
        }
        for number in 0..self.document.steps.len() {
            let (x, y) = self.place(Id::Step(number));
            let step = &self.document.steps[number];
            let mut sources = sources[number].clone();
            if let Some(enter) = self.numbers.enter[number] {
                self.branch(
                    "selectionConvergence",
                    enter,
                    &sources,
                    (x, y.saturating_sub(10)),
                );
                sources = vec![enter];
            }
            let lines = sources.iter().map(|id| {
                format!("<connectionPointIn><connection refLocalId=\"{id}\"/></connectionPointIn>")
            });
            let lines: String = lines.collect();
            let name = escaped(&step.name);
            let does = match step.does.is_empty() {
                true => "",
                false => "<connectionPointOutAction formalParameter=\"\"/>",
            };
            let id = self.numbers.steps[number];
            let _ = writeln!(
                self.text,
                "            <step localId=\"{id}\" name=\"{name}\" initialStep=\"{}\" height=\"40\" width=\"70\"><position x=\"{x}\" y=\"{y}\"/>{lines}<connectionPointOut formalParameter=\"\"/>{does}</step>",
                step.initial
            );
            if let Some(leave) = self.numbers.leave[number] {
                self.branch("selectionDivergence", leave, &[id], (x, y + 50));
            }
            self.does(number, (x, y));
        }
    }

    /// The action block of a step.
    fn does(&mut self, step: usize, (x, y): (usize, usize)) {
        let does = &self.document.steps[step].does;
        if does.is_empty() {
            return;
        }
        let number = self.numbers.next;
        self.numbers.next += 1;
        let (x, y) = self
            .places
            .get(&Id::Does(step, 0))
            .copied()
            .unwrap_or((x + 100, y));
        let height = 20 * does.len();
        let _ = writeln!(
            self.text,
            "            <actionBlock localId=\"{number}\" height=\"{height}\" width=\"150\"><position x=\"{x}\" y=\"{y}\"/><connectionPointIn><connection refLocalId=\"{}\"/></connectionPointIn>",
            self.numbers.steps[step]
        );
        for does in does {
            let time = does.time.as_ref();
            let time = time.map_or(String::new(), |time| {
                format!(" duration=\"{}\"", escaped(time))
            });
            let _ = writeln!(
                self.text,
                "              <action localId=\"0\" qualifier=\"{}\"{time}><relPosition x=\"0\" y=\"0\"/><reference name=\"{}\"/></action>",
                does.qualifier.name(),
                escaped(&does.action)
            );
        }
        self.text.push_str("            </actionBlock>\n");
    }

    fn transitions(&mut self) {
        // In a file 0 says that there is none.
        let all = self.document.transitions.iter();
        let more = u32::from(all.clone().any(|of| of.priority == Some(0)));
        for number in 0..self.document.transitions.len() {
            let (x, y) = self.place(Id::Transition(number));
            let of = &self.document.transitions[number];
            let from = of.from.iter().filter_map(|name| self.document.step(name));
            let from =
                from.map(|step| self.numbers.leave[step].unwrap_or(self.numbers.steps[step]));
            let mut from: Vec<u32> = from.collect();
            if let Some(join) = self.numbers.join[number] {
                self.branch(
                    "simultaneousConvergence",
                    join,
                    &from,
                    (x, y.saturating_sub(10)),
                );
                from = vec![join];
            }
            let lines = from
                .iter()
                .map(|id| format!("<connection refLocalId=\"{id}\"/>"));
            let lines: String = lines.collect();
            let of = &self.document.transitions[number];
            let condition = match &of.name {
                Some(name) => format!("<reference name=\"{}\"/>", escaped(name)),
                None => format!(
                    "<inline name=\"\"><ST><xhtml:p>{}</xhtml:p></ST></inline>",
                    escaped(&of.condition)
                ),
            };
            let priority = of.priority.map(|priority| priority.saturating_add(more));
            let priority = priority.map_or(String::new(), |n| format!(" priority=\"{n}\""));
            let id = self.numbers.transitions[number];
            let _ = writeln!(
                self.text,
                "            <transition localId=\"{id}\" height=\"2\" width=\"40\"{priority}><position x=\"{x}\" y=\"{y}\"/><connectionPointIn>{lines}</connectionPointIn><connectionPointOut/><condition>{condition}</condition></transition>"
            );
            if let Some(part) = self.numbers.part[number] {
                self.branch("simultaneousDivergence", part, &[id], (x, y + 10));
            }
        }
    }

    fn ends(&mut self) {
        for (transition, nth) in self.jumps.clone() {
            let id = self.numbers.next;
            self.numbers.next += 1;
            let (x, y) = self.place(Id::Jump(transition, nth));
            let of = &self.document.transitions[transition];
            let target = of.to.get(nth).map_or(String::new(), |name| escaped(name));
            let from = self.source(transition);
            let _ = writeln!(
                self.text,
                "            <jumpStep localId=\"{id}\" height=\"13\" width=\"12\" targetName=\"{target}\"><position x=\"{x}\" y=\"{y}\"/><connectionPointIn><connection refLocalId=\"{from}\"/></connectionPointIn></jumpStep>"
            );
        }
    }
}
