//! A scan in slow motion: where it stands, how far it goes on by one key, and where a person points to.
//!
//! Owns where a scan stops. Must not know keys, nor what is shown of it.

use std::collections::{BTreeMap, BTreeSet};
use unoclp_checked::SourceMap;
use unoclp_core::Scan;
use unoclp_core::isa::Opcode;
use unoclp_draw::Ladder;
use unoclp_program::Source;

/// How far a scan goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum To {
    /// To the next element of the drawing, rung, or line of the text; or to the end of the scan, whichever comes first.
    Element,
    Rung,
    Line,
}

/// Where the steps of a program begin rungs and lines.
pub struct Places {
    /// Steps that only begin a rung: they are no elements.
    heads: BTreeSet<usize>,
    rungs: BTreeSet<usize>,
    lines: BTreeSet<usize>,
    /// The first step of each line that makes code.
    firsts: BTreeMap<usize, usize>,
}

/// What one points to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Among {
    Lines,
    Rungs,
}

impl Places {
    /// Of this program.
    pub fn new(program: &Source) -> Places {
        let ladder = Ladder::new(program.program().steps());
        let steps = program.map.steps.windows(2);
        let lines = (1..).zip(steps).filter_map(|(step, places)| match places {
            [before, place] if before.line != place.line => Some(step),
            _ => None,
        });
        let mut firsts = BTreeMap::new();
        for (step, place) in program.map.steps.iter().enumerate() {
            firsts.entry(place.line).or_insert(step);
        }
        let steps = (0..).zip(program.program().steps());
        let heads = steps.filter(|(_, step)| step.opcode == Opcode::NewRung);
        Places {
            heads: heads.map(|(index, _)| index).collect(),
            rungs: ladder.rungs.iter().map(|rung| rung.first).collect(),
            lines: lines.chain([0]).collect(),
            firsts,
        }
    }

    /// The first step of the line or rung so many after that of a step, or of the last there is: those without code are passed
    /// over.
    pub fn beyond(&self, step: usize, by: isize, among: Among, map: &SourceMap) -> usize {
        let all: Vec<usize> = match among {
            Among::Lines => self.firsts.values().copied().collect(),
            Among::Rungs => self.rungs.iter().copied().collect(),
        };
        let begun = match among {
            Among::Lines => {
                let line = line(map, step).unwrap_or(usize::MAX);
                self.firsts.range(..=line).count()
            }
            Among::Rungs => self.rungs.range(..=step).count(),
        };
        let last = all.len().saturating_sub(1);
        let at = begun.saturating_sub(1).saturating_add_signed(by).min(last);
        all.get(at).copied().unwrap_or_default()
    }
}

/// What stands beside a scan that stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Standing {
    /// The step that comes next.
    pub step: usize,
    pub acc: bool,
    pub value: i32,
    /// What is pushed, the last first.
    pub pushed: Vec<i32>,
}

impl Standing {
    /// Of a scan that stands.
    pub fn of(scan: &Scan) -> Standing {
        let found = scan.found();
        Standing {
            step: scan.next(),
            acc: found.acc,
            value: found.value,
            pushed: scan.pushed().to_vec(),
        }
    }
}

impl To {
    /// Whether a scan that goes so far stops before this step.
    pub fn stops(self, step: usize, places: &Places) -> bool {
        match self {
            To::Element => !places.heads.contains(&step),
            To::Rung => places.rungs.contains(&step),
            To::Line => places.lines.contains(&step),
        }
    }
}

/// The line of the text that a step comes from, from 1.
pub fn line(map: &SourceMap, step: usize) -> Option<usize> {
    map.steps.get(step).map(|place| place.line)
}
