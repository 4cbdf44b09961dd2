//! A scan in slow motion: where it stands, and how far it goes on by one key.
//!
//! Owns the scan that is under way and its breakpoints. Must not know keys, nor what is shown of it.

use std::collections::BTreeSet;
use unoclp_checked::SourceMap;
use unoclp_core::isa::Opcode;
use unoclp_core::{Fault, Inputs, Millis, Plc, Scan};
use unoclp_draw::Ladder;
use unoclp_exercise::live::Flow;
use unoclp_host_sim::engine::Machine;
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
        let steps = (0..).zip(program.program().steps());
        let heads = steps.filter(|(_, step)| step.opcode == Opcode::NewRung);
        Places {
            heads: heads.map(|(index, _)| index).collect(),
            rungs: ladder.rungs.iter().map(|rung| rung.first).collect(),
            lines: lines.chain([0]).collect(),
        }
    }
}

/// A scan that is under way.
pub struct Slow {
    scan: Scan,
    pub flow: Flow,
    pub inputs: Inputs,
    pub now: Millis,
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

impl Slow {
    /// Begins a scan.
    pub fn begin(machine: &mut Machine, inputs: Inputs, now: Millis) -> Slow {
        machine.with_plc(|plc: &mut Plc<'_>| {
            let mut flow = Flow::new(plc.steps().count());
            flow.look(plc, now);
            Slow {
                scan: plc.begin(inputs, now),
                flow,
                inputs,
                now,
            }
        })
    }

    /// Goes on by one step at least, to where `stops` says that it stops before a step. Says whether the scan is over.
    ///
    /// # Errors
    /// Where it has made too many jumps back.
    pub fn go(
        &mut self,
        machine: &mut Machine,
        stops: impl Fn(usize) -> bool,
    ) -> Result<bool, Fault> {
        machine.with_plc(|plc: &mut Plc<'_>| {
            while let Some((step, after)) = plc.step(&mut self.scan)? {
                self.flow.observe(step, after);
                if stops(self.scan.next()) {
                    return Ok(false);
                }
            }
            self.flow.end(plc);
            Ok(true)
        })
    }

    /// Where it stands.
    pub fn standing(&self) -> Standing {
        let found = self.scan.found();
        Standing {
            step: self.scan.next(),
            acc: found.acc,
            value: found.value,
            pushed: self.scan.pushed().to_vec(),
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
