//! A chart as it is drawn: sequences, selections, simultaneous sequences, and what is a jump.
//!
//! Owns which way through the chart is drawn as a line. Each step and each transition stands in it once, whatever the chart
//! is like; where a step has been drawn already, or is drawn elsewhere, a jump leads to it.

use crate::document::Document;
use crate::net::Net;
use std::collections::HashMap;

/// Forks stand no deeper within each other; what would be deeper is a sequence of its own, to which jumps lead.
const DEEPEST: usize = 40;

/// A chart as it is drawn: sequences side by side, each from its first step on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outline {
    /// Its sequences.
    pub roots: Vec<Vec<Part>>,
}

/// A part of a sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// The step with this number.
    Step(usize),
    /// The transition with this number, and the steps that it waits for beside those that lead to it.
    Transition(usize, Vec<usize>),
    /// Several sequences beside each other.
    Fork(Fork),
    /// The end of a sequence: it goes on at the step that the transition names at this place.
    Jump(usize, usize),
    /// The end of a sequence: the transition with this number waits for it, and first of all for this step.
    Wait(usize, usize),
}

/// Sequences beside each other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fork {
    /// All of them, or one.
    pub simultaneous: bool,
    /// From left to right.
    pub branches: Vec<Branch>,
}

/// One of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Branch {
    /// What stands in it.
    pub parts: Vec<Part>,
    /// Whether it leads to where the sequence goes on below.
    pub joins: bool,
}

/// Where a sequence goes on that has come to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Goal {
    /// At a step, through a transition that names it at this place.
    Step(usize, usize, usize),
    /// At a transition that waits for others too.
    Sync(usize),
}

impl Goal {
    /// The same of all that lead to one place.
    fn place(self) -> (bool, usize) {
        match self {
            Goal::Step(step, ..) => (false, step),
            Goal::Sync(transition) => (true, transition),
        }
    }
}

/// Where a sequence leads.
struct End {
    goal: Goal,
    /// The steps that wait there, of a transition.
    from: Vec<usize>,
    /// How many ways lead there with it.
    ways: usize,
    /// Whether it may go on by itself where nothing else leads there: a transition is drawn below the fork that it ends.
    free: bool,
}

/// A sequence that has been drawn so far, and where it goes on.
struct Way {
    parts: Vec<Part>,
    end: Option<End>,
}

struct Maker {
    net: Net,
    /// The steps that are drawn.
    drawn: Vec<bool>,
    /// The transitions that are.
    passed: Vec<bool>,
    /// How many ways have come to each step, but for those back; how many of them have ended as a jump.
    come: Vec<usize>,
    jumped: Vec<usize>,
    /// How many steps have come to each transition that waits for several.
    waits: Vec<usize>,
    /// Those among them for which a mark stands.
    marked: HashMap<usize, Vec<usize>>,
}

impl Outline {
    /// How a chart is drawn.
    pub fn of(document: &Document) -> Outline {
        let net = Net::of(document);
        let mut maker = Maker {
            drawn: vec![false; net.leave.len()],
            passed: vec![false; net.from.len()],
            come: vec![0; net.leave.len()],
            jumped: vec![0; net.leave.len()],
            waits: vec![0; net.from.len()],
            marked: HashMap::new(),
            net,
        };
        let mut roots = Vec::new();
        let steps = 0..document.steps.len();
        let initial = steps.clone().filter(|step| document.steps[*step].initial);
        for step in initial.chain(steps) {
            if !maker.drawn[step] {
                roots.push(maker.root(Goal::Step(step, 0, 0)));
            }
        }
        for transition in 0..document.transitions.len() {
            if !maker.passed[transition] {
                roots.push(maker.root(Goal::Sync(transition)));
            }
        }
        for root in &mut roots {
            maker.note_marks(root);
        }
        Outline { roots }
    }
}

impl Maker {
    /// A sequence that begins here.
    fn root(&mut self, first: Goal) -> Vec<Part> {
        let mut all = Vec::new();
        let mut next = Some(first);
        while let Some(first) = next.take() {
            let way = self.sequence(first, 0);
            all.extend(way.parts);
            match way.end {
                // Whatever else leads there comes from elsewhere.
                Some(End { goal, .. })
                    if matches!(goal, Goal::Step(..)) || self.is_complete(goal) =>
                {
                    next = Some(goal);
                }
                Some(end) => all.push(self.mark(end)),
                None => {}
            }
        }
        all
    }

    /// Whether all that leads there has come.
    fn is_complete(&self, goal: Goal) -> bool {
        match goal {
            Goal::Step(step, ..) => !self.drawn[step] && self.come[step] >= self.net.enter[step],
            Goal::Sync(transition) => {
                !self.passed[transition]
                    && self.waits[transition] >= self.net.from[transition].len()
            }
        }
    }

    /// Whether nothing leads there but what has come with this end, and jumps.
    fn is_alone(&self, end: &End) -> bool {
        let all = match end.goal {
            Goal::Step(step, ..) => {
                self.net.enter[step] - self.jumped[step].min(self.net.enter[step])
            }
            Goal::Sync(transition) => {
                let marked = self.marked.get(&transition).map_or(0, Vec::len);
                self.net.from[transition].len().saturating_sub(marked)
            }
        };
        self.is_complete(end.goal) && end.ways >= all
    }

    /// The mark at which a sequence ends that goes on elsewhere.
    fn mark(&mut self, end: End) -> Part {
        match end.goal {
            Goal::Step(step, transition, nth) => {
                self.jumped[step] += end.ways;
                Part::Jump(transition, nth)
            }
            Goal::Sync(transition) => {
                let first = end.from.first().copied().unwrap_or(0);
                self.marked.entry(transition).or_default().extend(end.from);
                Part::Wait(transition, first)
            }
        }
    }

    /// A sequence from a step or a transition on, which it draws.
    fn sequence(&mut self, first: Goal, deep: usize) -> Way {
        let mut parts = Vec::new();
        let mut next = first;
        loop {
            let end = match next {
                Goal::Step(step, ..) => {
                    self.drawn[step] = true;
                    parts.push(Part::Step(step));
                    match self.net.leave[step].clone()[..] {
                        [] => None,
                        [one] => self.leave(one, step, &mut parts, deep),
                        ref several => self.select(several, step, &mut parts, deep),
                    }
                }
                Goal::Sync(transition) => self.pass(transition, &mut parts, deep),
            };
            match self.goes_on(end, &mut parts, deep) {
                Ok(goal) => next = goal,
                Err(end) => return Way { parts, end },
            }
        }
    }

    /// Where a sequence goes on by itself, or how it ends.
    fn goes_on(
        &mut self,
        end: Option<End>,
        parts: &mut Vec<Part>,
        deep: usize,
    ) -> Result<Goal, Option<End>> {
        match end {
            Some(end) if end.free && deep <= DEEPEST && self.is_alone(&end) => Ok(end.goal),
            Some(end) if matches!(end.goal, Goal::Step(step, ..) if self.drawn[step]) => {
                parts.push(self.mark(end));
                Err(None)
            }
            end => Err(end),
        }
    }

    /// From a step to a transition, and through it if it waits for nothing else.
    fn leave(
        &mut self,
        transition: usize,
        step: usize,
        parts: &mut Vec<Part>,
        deep: usize,
    ) -> Option<End> {
        if self.net.from[transition].len() > 1 {
            self.waits[transition] += 1;
            return Some(End {
                goal: Goal::Sync(transition),
                from: vec![step],
                ways: 1,
                free: false,
            });
        }
        self.pass(transition, parts, deep)
    }

    /// From a step to several transitions.
    fn select(
        &mut self,
        all: &[usize],
        step: usize,
        parts: &mut Vec<Part>,
        deep: usize,
    ) -> Option<End> {
        let ways = all.iter().map(|transition| {
            let mut parts = Vec::new();
            let end = self.leave(*transition, step, &mut parts, deep + 1);
            match self.goes_on(end, &mut parts, deep + 1) {
                Ok(goal) => {
                    let way = self.sequence(goal, deep + 1);
                    parts.extend(way.parts);
                    Way {
                        parts,
                        end: way.end,
                    }
                }
                Err(end) => Way { parts, end },
            }
        });
        let ways: Vec<Way> = ways.collect();
        self.fork(ways, false, parts, deep)
    }

    /// Draws a transition, and what it leads to if that is more than one step.
    fn pass(&mut self, transition: usize, parts: &mut Vec<Part>, deep: usize) -> Option<End> {
        self.passed[transition] = true;
        parts.push(Part::Transition(transition, Vec::new()));
        let to = self.net.to[transition].clone();
        match to[..] {
            [] => None,
            [None] => {
                parts.push(Part::Jump(transition, 0));
                None
            }
            [Some(step)] => Some(End {
                ways: usize::from(!self.net.back.contains(&(transition, step))),
                goal: self.come(transition, 0, step),
                from: Vec::new(),
                free: true,
            }),
            _ => {
                let ways = to.into_iter().enumerate().map(|(nth, step)| {
                    let step = step.filter(|step| !self.drawn[*step] && deep < DEEPEST);
                    let Some(step) = step else {
                        return Way {
                            parts: vec![Part::Jump(transition, nth)],
                            end: None,
                        };
                    };
                    let goal = self.come(transition, nth, step);
                    self.sequence(goal, deep + 1)
                });
                let ways: Vec<Way> = ways.collect();
                self.fork(ways, true, parts, deep)
            }
        }
    }

    /// Notes that a way has come to a step.
    fn come(&mut self, transition: usize, nth: usize, step: usize) -> Goal {
        if !self.net.back.contains(&(transition, step)) {
            self.come[step] += 1;
        }
        Goal::Step(step, transition, nth)
    }

    /// Ends a fork: where most of its sequences lead is where it goes on.
    fn fork(
        &mut self,
        mut ways: Vec<Way>,
        simultaneous: bool,
        parts: &mut Vec<Part>,
        deep: usize,
    ) -> Option<End> {
        let below = common(&ways, simultaneous);
        let ends = ways.iter().enumerate();
        let ends = ends.filter_map(|(number, way)| Some((way.end.as_ref()?.goal.place(), number)));
        let last: HashMap<(bool, usize), usize> = ends.collect();
        let (mut joined, mut together) = (Vec::new(), 0);
        let mut branches = Vec::with_capacity(ways.len());
        for (number, way) in ways.iter_mut().enumerate() {
            let mut joins = false;
            while let Some(end) = way.end.take() {
                let place = end.goal.place();
                if below.is_some_and(|below| below.place() == place) {
                    joins = true;
                    joined.extend(end.from);
                    together += end.ways;
                    break;
                }
                // The last of those that lead there goes on, if nothing else does.
                let is_last = last.get(&place).is_none_or(|last| *last <= number);
                if !is_last || !self.is_complete(end.goal) || deep >= DEEPEST {
                    way.parts.push(self.mark(end));
                    break;
                }
                let more = self.sequence(end.goal, deep + 1);
                way.parts.extend(more.parts);
                way.end = more.end;
            }
            let parts = std::mem::take(&mut way.parts);
            branches.push(Branch { parts, joins });
        }
        parts.push(Part::Fork(Fork {
            simultaneous,
            branches,
        }));
        let goal = below?;
        Some(End {
            goal,
            from: joined,
            ways: together,
            free: simultaneous || matches!(goal, Goal::Step(..)),
        })
    }

    /// Notes at each transition for which of its steps a mark stands elsewhere.
    fn note_marks(&mut self, parts: &mut [Part]) {
        for part in parts {
            match part {
                Part::Transition(transition, beside) => {
                    *beside = self.marked.remove(transition).unwrap_or_default();
                }
                Part::Fork(fork) => {
                    let branches = fork.branches.iter_mut();
                    branches.for_each(|branch| self.note_marks(&mut branch.parts));
                }
                Part::Step(_) | Part::Jump(..) | Part::Wait(..) => {}
            }
        }
    }
}

/// Where most of these sequences lead, the first of them where several are alike; simultaneous ones end at a transition.
fn common(ways: &[Way], simultaneous: bool) -> Option<Goal> {
    let mut counts: HashMap<(bool, usize), usize> = HashMap::new();
    let ends = || {
        let ends = ways.iter().filter_map(|way| Some(way.end.as_ref()?.goal));
        ends.filter(|goal| !simultaneous || matches!(goal, Goal::Sync(_)))
    };
    for goal in ends() {
        *counts.entry(goal.place()).or_default() += 1;
    }
    let most = *counts.values().max()?;
    ends().find(|goal| counts.get(&goal.place()) == Some(&most))
}
