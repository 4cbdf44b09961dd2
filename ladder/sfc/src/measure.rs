//! How much room each part of a chart takes, in cells: a character each.

use crate::document::Document;
use crate::look::Look;
use crate::outline::{Branch, Fork, Outline, Part};
use unicode_width::UnicodeWidthStr;

/// The size of a cell, in the units of a drawing.
pub(crate) const CELL: (f32, f32) = (8.0, 16.0);
/// A condition is broken into lines of about so many characters.
const LINE: usize = 36;
/// The rows of the box of a step.
pub(crate) const BOX: usize = 3;
/// Between a step and its actions.
pub(crate) const LEAD: usize = 3;
/// Between sequences beside each other.
const BESIDE: usize = 3;

/// The room of a part: left and right of the line that leads through it, and its rows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Room {
    pub left: usize,
    pub right: usize,
    pub rows: usize,
}

impl Room {
    /// Both below each other, with a row between.
    fn then(self, below: Room) -> Room {
        Room {
            left: self.left.max(below.left),
            right: self.right.max(below.right),
            rows: self.rows + below.rows + usize::from(self.rows > 0),
        }
    }

    pub(crate) fn columns(self) -> usize {
        self.left + 1 + self.right
    }
}

/// Parts with their room.
pub(crate) struct Column<'d> {
    pub parts: Vec<(Measured<'d>, Room)>,
    pub room: Room,
}

/// A part, with what it says.
pub(crate) enum Measured<'d> {
    Step {
        number: usize,
        label: String,
        initial: bool,
        /// What it does: when, and which.
        does: Vec<(String, String)>,
    },
    Transition {
        number: usize,
        lines: Vec<String>,
    },
    Jump(usize, usize, String),
    Wait(usize, usize, String),
    Fork {
        fork: &'d Fork,
        branches: Vec<Column<'d>>,
    },
}

/// The columns of a text.
pub(crate) fn width(text: &str) -> usize {
    text.width()
}

/// A step's box: its columns, an odd number.
pub(crate) fn box_columns(label: &str) -> usize {
    (width(label) + 4).max(7) | 1
}

/// The columns of the two fields of actions, without their edges; the first may be missing.
pub(crate) fn fields(does: &[(String, String)]) -> (usize, usize) {
    let most = |of: &dyn Fn(&(String, String)) -> usize| does.iter().map(of).max().unwrap_or(0);
    (most(&|does| width(&does.0)), most(&|does| width(&does.1)))
}

/// The columns of the table of actions.
pub(crate) fn table_columns(does: &[(String, String)]) -> usize {
    match fields(does) {
        (0, name) => name + 4,
        (when, name) => when + name + 7,
    }
}

pub(crate) struct Measure<'d> {
    pub document: &'d Document,
    pub look: Look,
}

impl<'d> Measure<'d> {
    pub(crate) fn all(&self, outline: &'d Outline) -> Vec<Column<'d>> {
        outline.roots.iter().map(|root| self.column(root)).collect()
    }

    fn column(&self, parts: &'d [Part]) -> Column<'d> {
        let mut room = Room::default();
        let parts = parts.iter().map(|part| {
            let (part, own) = self.part(part);
            room = room.then(own);
            (part, own)
        });
        let parts = parts.collect();
        Column { parts, room }
    }

    fn part(&self, part: &'d Part) -> (Measured<'d>, Room) {
        match part {
            Part::Step(number) => self.step(*number),
            Part::Transition(number, beside) => self.transition(*number, beside),
            Part::Jump(transition, nth) => {
                let to = self.document.transitions.get(*transition);
                let to = to.and_then(|to| to.to.get(*nth));
                let label = to.map_or(String::new(), |name| self.named(name));
                let room = Room {
                    left: 0,
                    right: width(&label) + 1,
                    rows: 1,
                };
                (Measured::Jump(*transition, *nth, label), room)
            }
            Part::Wait(transition, step) => {
                let label = self.awaited(*transition);
                let room = Room {
                    left: 0,
                    right: width(&label) + 1,
                    rows: 1,
                };
                (Measured::Wait(*transition, *step, label), room)
            }
            Part::Fork(fork) => self.fork(fork),
        }
    }

    /// A step as it is called in its box.
    fn named(&self, name: &str) -> String {
        let number = self.document.step(name);
        number.map_or(name.to_owned(), |number| {
            self.look.step(self.document, number)
        })
    }

    /// What a transition is called where a sequence waits for it: `a, b → c`.
    fn awaited(&self, transition: usize) -> String {
        let Some(transition) = self.document.transitions.get(transition) else {
            return String::new();
        };
        if let Some(name) = &transition.name {
            return name.clone();
        }
        let named = |names: &[String]| {
            let names: Vec<String> = names.iter().map(|name| self.named(name)).collect();
            names.join(", ")
        };
        format!("{} → {}", named(&transition.from), named(&transition.to))
    }

    fn step(&self, number: usize) -> (Measured<'d>, Room) {
        let label = self.look.step(self.document, number);
        let step = self.document.steps.get(number);
        let does = step.into_iter().flat_map(|step| {
            let label = label.as_str();
            step.does
                .iter()
                .map(move |does| self.look.action(label, does))
        });
        let does: Vec<(String, String)> = does.collect();
        let half = box_columns(&label) / 2;
        let table = match does.is_empty() {
            true => 0,
            false => LEAD + table_columns(&does),
        };
        let room = Room {
            left: half,
            right: half + table,
            rows: BOX.max(match does.len() {
                0 => 0,
                count => 2 * count + 1,
            }),
        };
        let initial = step.is_some_and(|step| step.initial);
        let step = Measured::Step {
            number,
            label,
            initial,
            does,
        };
        (step, room)
    }

    fn transition(&self, number: usize, beside: &[usize]) -> (Measured<'d>, Room) {
        let transition = self.document.transitions.get(number);
        let said = transition.map_or(String::new(), |of| self.look.condition(of));
        let mut lines = broken(&said);
        if !beside.is_empty() {
            let names = beside
                .iter()
                .map(|step| self.look.step(self.document, *step));
            let names: Vec<String> = names.collect();
            lines.push(format!("← {}", names.join(", ")));
        }
        if let Some(name) = transition.and_then(|of| of.name.as_ref())
            && self.look == Look::Norm
        {
            lines.insert(0, format!("{name}:"));
        }
        let longest = lines.iter().map(|line| width(line)).max().unwrap_or(0);
        let room = Room {
            left: 2,
            right: 3 + longest,
            rows: lines.len().max(1),
        };
        (Measured::Transition { number, lines }, room)
    }

    fn fork(&self, fork: &'d Fork) -> (Measured<'d>, Room) {
        let column = |branch: &'d Branch| self.column(&branch.parts);
        let branches: Vec<Column<'d>> = fork.branches.iter().map(column).collect();
        let rows = branches
            .iter()
            .map(|branch| branch.room.rows)
            .max()
            .unwrap_or(0);
        let joins = fork.branches.iter().any(|branch| branch.joins);
        let mut right = 0;
        for (number, branch) in branches.iter().enumerate() {
            right = match number {
                0 => branch.room.right,
                _ => right + BESIDE + branch.room.columns(),
            };
        }
        let room = Room {
            left: branches.first().map_or(0, |first| first.room.left).max(1),
            right: right + 1,
            rows: 2 + rows + if joins { 1 + usize::from(rows > 0) } else { 0 },
        };
        (Measured::Fork { fork, branches }, room)
    }
}

/// Where the line through each sequence of a fork stands, from that through the fork.
pub(crate) fn offsets(branches: &[Column<'_>]) -> Vec<usize> {
    let mut offsets = Vec::with_capacity(branches.len());
    let mut next = 0;
    for branch in branches {
        let axis = match offsets.is_empty() {
            true => 0,
            false => next + BESIDE + branch.room.left,
        };
        offsets.push(axis);
        next = axis + branch.room.right + 1;
    }
    offsets
}

/// A text in lines of about the same length.
fn broken(text: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let Some(line) = lines.last_mut() else { break };
        if !line.is_empty() && width(line) + 1 + width(word) > LINE {
            lines.push(word.to_owned());
            continue;
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    lines
}
