//! A plant in motion.
//!
//! - `judge`: the rules
//!
//! Owns the state. Must not know what kinds there are.

mod judge;

use crate::kind::Fault;
use crate::moment::Moment;
use crate::outputs::Outputs;
use crate::parts;
use crate::plant::{Plant, Step};
use crate::signal::At;
use crate::verdict::Verdict;
use judge::Judges;
use unoclp_core::Inputs;

/// A plant in motion: the same plant, seed and outputs give the same inputs, on every machine.
#[derive(Debug)]
pub struct Run<'p> {
    plant: &'p Plant,
    seed: u64,
    values: Vec<i32>,
    random: u64,
    now: u64,
    outputs: Outputs,
    inputs: Inputs,
    /// The next step of the script.
    next: usize,
    /// Whether the script goes on; if not, persons act by hand alone, and nothing fails by itself.
    is_scripted: bool,
    judges: Judges<'p>,
    verdict: Verdict,
    /// What each part does.
    moves: Vec<parts::Step>,
}

impl<'p> Run<'p> {
    /// A plant before its first step; chance begins with this.
    pub fn new(plant: &'p Plant, seed: u64) -> Run<'p> {
        let mut run = Run {
            plant,
            seed,
            values: Vec::new(),
            random: 0,
            now: 0,
            outputs: Outputs::default(),
            inputs: Inputs::default(),
            next: 0,
            is_scripted: true,
            judges: Judges::new(plant),
            verdict: Verdict::default(),
            moves: plant
                .parts
                .iter()
                .map(|part| parts::step(part.kind))
                .collect(),
        };
        run.reset();
        run
    }

    /// The same without its script: whoever is there presses, and makes it fail.
    #[must_use]
    pub fn by_hand(mut self) -> Run<'p> {
        self.is_scripted = false;
        self
    }

    /// The machine as it was before the first step.
    pub fn reset(&mut self) {
        self.values = vec![0; self.plant.cells];
        for part in &self.plant.parts {
            let values = part.kind.values.iter().zip(&part.cells);
            for ((slot, first), (low, high)) in values.zip(&part.ranges) {
                let value = part.limit(slot.first).max(*low).min(*high);
                let cells = self.values.iter_mut().skip(*first).take(slot.count);
                cells.for_each(|cell| *cell = value);
            }
        }
        // A generator of this kind never leaves 0.
        self.random = (self.seed ^ 0x9E37_79B9_7F4A_7C15) | 1;
        self.now = 0;
        self.outputs = Outputs::default();
        self.inputs = Inputs::default();
        self.next = 0;
        self.judges = Judges::new(self.plant);
        self.verdict = Verdict {
            met: vec![0; self.plant.goals.len()],
            ..Verdict::default()
        };
        self.sense();
    }

    /// The inputs of a machine that stands still, before anything has moved.
    fn sense(&mut self) {
        let (values, random) = (self.values.clone(), self.random);
        self.move_parts();
        (self.values, self.random) = (values, random);
    }

    /// The next millisecond with these outputs. Gives the inputs at its end.
    pub fn step(&mut self, outputs: &Outputs) -> &Inputs {
        self.outputs = *outputs;
        let mut judges = std::mem::take(&mut self.judges);
        if self.is_scripted {
            self.script();
            let coming = judges.troubles(self.plant, self.now, |name| self.read(name));
            for (part, fault, is) in coming {
                self.fault(part, fault, is);
            }
        }
        self.move_parts();
        let mut verdict = std::mem::take(&mut self.verdict);
        judges.judge(self.plant, self.now, |name| self.read(name), &mut verdict);
        (self.judges, self.verdict) = (judges, verdict);
        self.now += 1;
        &self.inputs
    }

    fn move_parts(&mut self) {
        for &part in &self.plant.order {
            let (Some(own), Some(step)) = (self.plant.parts.get(part), self.moves.get(part)) else {
                continue;
            };
            step(&mut Moment {
                plant: self.plant,
                part: own,
                values: &mut self.values,
                outputs: &self.outputs,
                inputs: &mut self.inputs,
                random: &mut self.random,
            });
        }
    }

    /// What persons do now.
    fn script(&mut self) {
        while let Some(Step { at, set }) = self.plant.steps.get(self.next) {
            if *at > self.now {
                return;
            }
            self.next += 1;
            for (part, value, to) in set {
                self.hand(*part, *value, *to);
            }
        }
    }

    /// A person there changes a value that persons can change. What is stuck stays as it is.
    pub fn hand(&mut self, part: usize, value: usize, to: i32) {
        let Some(own) = self.plant.parts.get(part) else {
            return;
        };
        let by_hand = own.kind.values.get(value).is_some_and(|slot| slot.by_hand);
        if !by_hand || self.fails(part, Fault::Stuck) {
            return;
        }
        let (low, high) = own.range(value);
        let cell = own.cells.get(value).copied().unwrap_or(usize::MAX);
        if let Some(held) = self.values.get_mut(cell) {
            *held = to.max(low).min(high);
        }
    }

    /// A fault comes, or is mended. One that the part cannot have is none.
    pub fn fault(&mut self, part: usize, fault: Fault, is: bool) {
        let Some(own) = self.plant.parts.get(part) else {
            return;
        };
        if !own.kind.faults.contains(&fault) {
            return;
        }
        if let Some(held) = self.values.get_mut(own.faults) {
            match is {
                true => *held |= fault.bit(),
                false => *held &= !fault.bit(),
            }
        }
    }

    /// Whether a part has this fault.
    pub fn fails(&self, part: usize, fault: Fault) -> bool {
        let cell = self
            .plant
            .parts
            .get(part)
            .map_or(usize::MAX, |own| own.faults);
        let faults = self.values.get(cell).copied().unwrap_or(0);
        faults & fault.bit() != 0
    }

    /// A value of a part; 0 where there is none.
    pub fn value(&self, part: usize, value: usize) -> i32 {
        let own = self.plant.parts.get(part);
        let cell = own.and_then(|own| own.cells.get(value)).copied();
        cell.and_then(|cell| self.values.get(cell))
            .copied()
            .unwrap_or(0)
    }

    /// The value of a row at this place; 0 where there is none.
    pub(crate) fn row(&self, part: usize, value: usize, at: usize) -> i32 {
        let own = self.plant.parts.get(part);
        let cell = own.and_then(|own| own.cells.get(value)).copied();
        let cell = cell.and_then(|cell| self.values.get(cell + at));
        cell.copied().unwrap_or(0)
    }

    /// The plant.
    pub fn plant(&self) -> &'p Plant {
        self.plant
    }

    /// The time of the next step, ms after the first.
    pub fn now(&self) -> u64 {
        self.now
    }

    /// The inputs as they are.
    pub fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// The outputs of the last step.
    pub fn outputs(&self) -> &Outputs {
        &self.outputs
    }

    /// What has come of it so far.
    pub fn verdict(&self) -> &Verdict {
        &self.verdict
    }

    /// All its numbers.
    pub fn cells(&self) -> &[i32] {
        &self.values
    }

    /// A number for all that it is (FNV-1a): the same state gives the same number.
    pub fn hash(&self) -> u64 {
        let mut hash = 0xCBF2_9CE4_8422_2325_u64;
        let mut note = |value: u64| {
            hash = (hash ^ value).wrapping_mul(0x0000_0100_0000_01B3);
        };
        self.values
            .iter()
            .for_each(|value| note(u64::from(value.cast_unsigned())));
        note(self.inputs.points.0 as u64);
        self.inputs
            .analogue
            .iter()
            .for_each(|reading| note(u64::from(*reading)));
        note(self.random);
        note(self.now);
        hash
    }

    /// The value of a condition's name.
    fn read(&self, name: usize) -> i64 {
        match self.plant.places.get(name) {
            Some(At::Cell(cell)) => self.values.get(*cell).copied().unwrap_or(0).into(),
            Some(At::Output(point)) => self.outputs.points.get(*point).into(),
            Some(At::Input(point)) => self.inputs.points.get(*point).into(),
            Some(At::Clock) => self.now as i64,
            None => 0,
        }
    }
}
