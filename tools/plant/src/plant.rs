//! A plant as its file says it, checked: every name is known, every number in its range.

use crate::kind::{Fault, Kind, Limit};
use crate::rules::{Goal, Never};
use crate::signal::{At, Given, Source};
use crate::text::Text;
use std::collections::BTreeSet;
use unoclp_core::Board;
use unoclp_lang::Condition;

/// A plant.
#[derive(Debug)]
pub struct Plant {
    /// What it is called.
    pub title: Text,
    /// What it is, in a sentence or two.
    pub about: Text,
    /// What it is wired to.
    pub board: Board,
    /// How long its script goes on, ms.
    pub until: u64,
    /// What chance begins with, unless somebody says otherwise.
    pub seed: u64,
    /// Its parts, in the order of the file.
    pub parts: Vec<Part>,
    /// The parts in the order in which they are stepped: what others need comes first.
    pub(crate) order: Vec<usize>,
    /// What must never be.
    pub nevers: Vec<Never>,
    /// What must be.
    pub goals: Vec<Goal>,
    /// What persons do there, in the order of the times.
    pub steps: Vec<Step>,
    /// What fails.
    pub troubles: Vec<Trouble>,
    /// What is drawn beside the parts.
    pub decorations: Vec<Decoration>,
    /// How many numbers it has.
    pub(crate) cells: usize,
    /// Where the values are that conditions read.
    pub(crate) places: Vec<At>,
}

/// A part of a plant.
#[derive(Debug)]
pub struct Part {
    /// Its kind.
    pub kind: &'static Kind,
    /// Its name.
    pub name: String,
    /// What people call it.
    pub label: Text,
    /// Where its symbol stands; none of what is on the panel.
    pub at: Option<[i32; 2]>,
    pub(crate) given: Vec<Given>,
    /// The least and the most of each of its values.
    pub(crate) ranges: Vec<(i32, i32)>,
    /// The first cell of each of its values.
    pub(crate) cells: Vec<usize>,
    /// The cell of each contact's state and time, by the field; of others it is not asked.
    pub(crate) contacts: Vec<usize>,
    /// The cell of its faults.
    pub(crate) faults: usize,
}

impl Part {
    /// A number that it was given.
    pub(crate) fn number(&self, field: usize) -> i32 {
        match self.given.get(field) {
            Some(Given::Number(number)) => *number,
            Some(Given::Choice(choice)) => *choice as i32,
            _ => 0,
        }
    }

    /// The least and the most of one of its values.
    pub fn range(&self, value: usize) -> (i32, i32) {
        self.ranges.get(value).copied().unwrap_or((0, 0))
    }

    /// What a limit comes to.
    pub(crate) fn limit(&self, limit: Limit) -> i32 {
        let field = |name| self.kind.field(name).map_or(0, |field| self.number(field));
        match limit {
            Limit::Is(number) => number,
            Limit::Of(name) => field(name),
            Limit::Thousand(name) => field(name).saturating_mul(1000),
        }
    }
}

/// What persons do at a time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// ms after the first.
    pub at: u64,
    /// The part, its value, and what that becomes.
    pub set: Vec<(usize, usize, i32)>,
}

/// A fault that comes.
#[derive(Debug)]
pub struct Trouble {
    /// Of which part.
    pub part: usize,
    /// Which.
    pub fault: Fault,
    /// At this time, ms; none: on a condition alone.
    pub at: Option<u64>,
    /// Since this holds.
    pub when: Option<Condition>,
    /// It is gone after so long, ms; 0: never.
    pub lasts: u64,
}

/// A line or a word that is drawn beside the parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decoration {
    /// What it is: `pipe`, `wire`, `floor`, `text`.
    pub kind: &'static str,
    /// Its points.
    pub points: Vec<[i32; 2]>,
    /// The value, by the numbers of part and value, that shows whether something flows in it.
    pub carries: Option<(usize, usize)>,
    /// What is written.
    pub text: Text,
}

impl Plant {
    /// What it is wired to, each in order: the inputs that it switches, the analogue inputs that it sets, and the outputs
    /// that drive it.
    pub fn uses(&self) -> [Vec<u8>; 3] {
        let mut uses = [const { BTreeSet::new() }; 3];
        let [inputs, analogue, outputs] = &mut uses;
        for given in self.parts.iter().flat_map(|part| &part.given) {
            match given {
                Given::Contact(contact) => inputs.insert(contact.input.index() + 1),
                Given::Analogue(number) => analogue.insert(*number),
                Given::Signal(signal) => match signal.source {
                    Source::Output(point) => outputs.insert(point.index() + 1),
                    Source::Pwm(number) => outputs.insert(number),
                    _ => false,
                },
                _ => false,
            };
        }
        uses.map(|numbers| numbers.into_iter().collect())
    }

    /// Whether the share of a time for which an output is on drives it: PWM.
    pub fn dims(&self) -> bool {
        let mut given = self.parts.iter().flat_map(|part| &part.given);
        given.any(|given| matches!(given, Given::Signal(signal) if matches!(signal.source, Source::Pwm(_))))
    }

    /// The number of the part of this name.
    pub fn part(&self, name: &str) -> Option<usize> {
        let same = |part: &Part| part.name.eq_ignore_ascii_case(name);
        self.parts.iter().position(same)
    }

    /// The part and the value of a path: `tank.level`.
    pub fn value(&self, path: &str) -> Option<(usize, usize)> {
        let (part, value) = path.split_once('.')?;
        let part = self.part(part)?;
        Some((part, self.parts.get(part)?.kind.value(value)?))
    }

    /// The range of each cell, least and most.
    pub fn ranges(&self) -> Vec<(i32, i32)> {
        let mut ranges = vec![(i32::MIN, i32::MAX); self.cells];
        let mut set = |cell: usize, range| {
            if let Some(place) = ranges.get_mut(cell) {
                *place = range;
            }
        };
        for part in &self.parts {
            for ((slot, first), range) in part.kind.values.iter().zip(&part.cells).zip(&part.ranges)
            {
                (*first..first + slot.count).for_each(|cell| set(cell, *range));
            }
            part.contacts
                .iter()
                .for_each(|cell| set(*cell, (-CONTACT_SEEN, CONTACT_SEEN)));
            set(part.faults, (0, 255));
        }
        ranges
    }
}

/// The time since a contact changed is counted so far, ms.
pub(crate) const CONTACT_SEEN: i32 = 1000;
