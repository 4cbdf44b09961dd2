//! Runs a function before and after the pass, and holds what can be seen of one against the other.
//!
//! Both versions ask one oracle what memory, I/O and other functions hold and answer. Alike must be
//!
//! - the trace: reads of I/O, writes to memory and I/O, interrupts on and off, calls with the registers that
//!   they may look at, in order;
//! - at the end r1 to r25, r28, r29 and the stack pointer, which is all that a caller may look at; at a return
//!   from an interrupt all registers and flags;
//! - timed writes: none stands further after another than it did.
//!
//! What nobody may look at differs between the versions from the start: r0, r26, r27, r30, r31 at the entry and
//! after each call. What a function pushes is its own, so pushes are not in the trace. A shared entry may push
//! a register more; the version after begins that much higher on the stack, so that frames have equal addresses.

use std::fmt;

use crate::machine::decode::flag;
use crate::machine::oracle::{Oracle, mix};
use crate::machine::{End, Program, Run, Setting, run};

/// The instructions that a run may have.
pub const LIMIT: u32 = 10_000;
/// How far pointers must keep away from the stack, in bytes.
const BELOW: u16 = 16;
/// How much higher the stack of the shorter version may begin, in bytes: a shared entry saves more registers.
const ABOVE: u16 = 8;
/// The most instructions that may stand between two timed writes for the one to count on the other.
const TIMED: u32 = 4;

/// A unit before and after, as code that can be run.
pub struct Pair {
    before: Program,
    after: Program,
    fragment: bool,
    /// What of the version before was run so far.
    visited: Vec<bool>,
}

/// How many models a run may stand on.
const GENERATIONS: usize = 24;

/// What the runs of a function have come to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Explored {
    /// Runs in which both versions did the same.
    pub alike: u64,
    /// Runs whose values meant nothing: see [`End::Void`].
    pub void: u64,
}

/// A run that has ended in another way, or has done something else.
#[derive(Debug)]
pub struct Difference {
    /// The function.
    pub function: String,
    /// The seeds of the run.
    pub seeds: Vec<u64>,
    /// What was different.
    pub what: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Difference {
            function,
            seeds,
            what,
        } = self;
        write!(f, "{function}, seeds {seeds:?}: {what}")
    }
}

impl std::error::Error for Difference {}

impl Pair {
    /// Takes both versions.
    pub fn new(before: Program, after: Program) -> Self {
        Pair {
            visited: vec![false; before.steps()],
            before,
            after,
            fragment: false,
        }
    }

    /// Takes both versions of code that is no whole function: it may look at all registers at its entry.
    pub fn of_fragments(before: Program, after: Program) -> Self {
        Pair {
            fragment: true,
            ..Pair::new(before, after)
        }
    }

    /// Runs a function in both versions some times, each with other values. A run that has come to new code is
    /// the model for later ones, which differ from it in some values.
    ///
    /// # Errors
    /// If the versions differ.
    pub fn explore(&mut self, function: &str, runs: u64) -> Result<Explored, Difference> {
        let mut explored = Explored::default();
        let mut models: Vec<Vec<u64>> = Vec::new();
        let mut known = 0;
        for n in 0..runs {
            let model = mix(n) as usize % (models.len() + 1);
            let mut seeds = models.get(model).cloned().unwrap_or_default();
            seeds.push(n);
            if self.compare(function, &seeds)? {
                explored.alike += 1;
            } else {
                explored.void += 1;
            }
            let (covered, _) = self.coverage(function);
            if covered > known && seeds.len() < GENERATIONS {
                models.push(seeds);
            }
            known = covered;
        }
        Ok(explored)
    }

    /// Runs a function in both versions with the values of some seeds. False if they mean nothing: a pointer led
    /// to where none may.
    ///
    /// # Errors
    /// If the versions differ.
    pub fn compare(&mut self, function: &str, seeds: &[u64]) -> Result<bool, Difference> {
        let oracle = Oracle::new(seeds, self.before.constants(function));
        let mut setting = Setting {
            program: &self.before,
            original: &self.before,
            oracle: &oracle,
            version: 0,
            fragment: self.fragment,
            moved: 0,
            below: 2 * BELOW,
            above: ABOVE,
            limit: LIMIT,
        };
        let before = run(setting, function, &mut self.visited);
        if before.end == End::Void {
            return Ok(false);
        }
        setting.program = &self.after;
        // A shared part has a return address more on the stack.
        setting.below = BELOW;
        setting.above = 0;
        // An interrupt keeps all registers.
        setting.version = u8::from(before.end != End::ReturnedFromInterrupt);
        setting.limit = 2 * LIMIT;
        let mut after = run(setting, function, &mut []);
        if let (Some(wanted), Some(found)) = (before.frame, after.frame)
            && wanted != found
        {
            setting.moved = wanted.wrapping_sub(found);
            after = run(setting, function, &mut []);
        }
        // The few bytes by which its stack begins higher may be hit by a pointer too.
        let higher = setting.moved != 0 && before.trace.starts_with(&after.trace);
        if after.end == End::Void && higher {
            return Ok(false);
        }
        match difference(&before, &after) {
            None => Ok(true),
            Some(what) => Err(Difference {
                function: function.to_owned(),
                seeds: seeds.to_vec(),
                what,
            }),
        }
    }

    /// How many instructions of a function were run, before the pass, and how many it has.
    pub fn coverage(&self, function: &str) -> (usize, usize) {
        let all = self.before.length(function);
        let begin = self.before.begin(function).unwrap_or(self.visited.len());
        let run = self.visited.iter().skip(begin).take(all);
        (run.filter(|run| **run).count(), all)
    }
}

/// What is different, in words.
fn difference(before: &Run, after: &Run) -> Option<String> {
    let unequal =
        (before.trace.iter().zip(&after.trace)).position(|(before, after)| before != after);
    if let Some(n) = unequal {
        let event = |run: &Run| format!("{:?}", run.trace.get(n));
        return Some(format!(
            "event {n} was {}, is {}",
            event(before),
            event(after)
        ));
    }
    let longer = |&(before, after): &(&u32, &u32)| *before <= TIMED && after > before;
    if let Some((was, is)) = before.gaps.iter().zip(&after.gaps).find(longer) {
        return Some(format!(
            "a timed write came {was} instructions later, comes {is}"
        ));
    }
    if before.end == End::TooLong {
        // The shorter version may have done more by then, but not less.
        let less = after.trace.len() < before.trace.len();
        return less.then(|| format!("it ended after {} events", after.trace.len()));
    }
    if (before.end, before.trace.len()) != (after.end, after.trace.len()) {
        let end = |run: &Run| format!("{:?} after {} events", run.end, run.trace.len());
        return Some(format!(
            "it ended as {}, ends as {}",
            end(before),
            end(after)
        ));
    }
    let kept: &[std::ops::RangeInclusive<usize>] = match before.end {
        End::Returned => &[1..=25, 28..=29],
        End::ReturnedFromInterrupt => &[0..=31],
        _ => return None,
    };
    let register = kept
        .iter()
        .cloned()
        .flatten()
        .find(|&n| before.registers[n] != after.registers[n]);
    if let Some(n) = register {
        let (was, is) = (before.registers[n], after.registers[n]);
        return Some(format!("r{n} was {was} at the end, is {is}"));
    }
    let flags = match before.end {
        End::ReturnedFromInterrupt => 0xFF,
        _ => 1 << flag::I,
    };
    if (before.flags ^ after.flags) & flags != 0 {
        let (was, is) = (before.flags, after.flags);
        return Some(format!(
            "the flags were {was:#04x} at the end, are {is:#04x}"
        ));
    }
    (before.popped != after.popped).then(|| {
        let (was, is) = (before.popped, after.popped);
        format!("the stack pointer had moved by {was} at the end, moves by {is}")
    })
}
