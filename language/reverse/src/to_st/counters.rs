//! What a program does with its counters, and which of them are blocks of the standard.
//!
//! Owns both questions. Must not know expressions.

use super::flow::Flow;
use std::collections::BTreeMap;
use unoclp_core::Instruction;
use unoclp_core::isa::{Class, Kind, Opcode, Operand};

/// An edge that is a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Edge {
    Rise,
    Fall,
}

/// What a program does with a counter.
#[derive(Clone, Debug, Default)]
pub(super) struct Counter {
    /// The preset that the program begins with.
    pub preset: i32,
    /// Its CTU and CTD.
    pub ups: Vec<usize>,
    pub downs: Vec<usize>,
    resets: Vec<usize>,
    loads: Vec<usize>,
    /// Whether its number is stored, and its preset.
    pub is_stored: bool,
    pub changes_preset: bool,
    /// CTU or CTD where it is a block, and the step of its reset or load.
    pub block: Option<(Opcode, Option<usize>)>,
    /// Where the block is called: the step, and the frames around it.
    pub called: Option<(usize, Vec<usize>)>,
}

/// The counters of a program, by their numbers.
pub(super) struct Counting(pub BTreeMap<u8, Counter>);

impl Counting {
    pub fn of(steps: &[Instruction<'_>], flow: &Flow) -> Counting {
        let mut all: BTreeMap<u8, Counter> = BTreeMap::new();
        for (at, step) in steps.iter().enumerate() {
            if !names_counter(step.opcode) {
                continue;
            }
            let counter = all.entry(step.number().unwrap_or_default()).or_default();
            match step.opcode {
                Opcode::CountUp => counter.ups.push(at),
                Opcode::CountDown => counter.downs.push(at),
                Opcode::ResetCounter => counter.resets.push(at),
                Opcode::LoadCounter => counter.loads.push(at),
                Opcode::StoreCount => counter.is_stored = true,
                Opcode::PresetCounter => counter.changes_preset = true,
                _ => {}
            }
            if let Operand::Count { preset, .. } = step.operand {
                counter.preset = preset;
            }
        }
        for (number, counter) in &mut all {
            counter.block = block(*number, counter, steps, flow);
        }
        Counting(all)
    }
}

fn names_counter(opcode: Opcode) -> bool {
    matches!(opcode.row().kind, Kind::Counter | Kind::Count)
}

/// CTU or CTD, where this counter does no more than that block does.
fn block(
    number: u8,
    counter: &Counter,
    steps: &[Instruction<'_>],
    flow: &Flow,
) -> Option<(Opcode, Option<usize>)> {
    let (opcode, at, other, last) = match (&counter.ups[..], &counter.downs[..]) {
        ([at], []) => (Opcode::CountUp, *at, &counter.loads, &counter.resets),
        ([], [at]) => (Opcode::CountDown, *at, &counter.resets, &counter.loads),
        _ => return None,
    };
    let fits = counter.preset <= i16::MAX.into() && !counter.is_stored && !counter.changes_preset;
    if !fits || !other.is_empty() || flow.in_loop(at) {
        return None;
    }
    let [last] = last[..] else {
        return last.is_empty().then_some((opcode, None));
    };
    // The rung after it is contacts, then the reset.
    let rung = steps.get(at + 1..last)?;
    let [new, contacts @ ..] = rung else {
        return None;
    };
    let plain = |step: &Instruction<'_>| {
        let own = matches!(
            step.opcode,
            Opcode::CounterContact | Opcode::CounterContactNot
        );
        step.opcode.class() == Class::Contact && !(own && step.number() == Some(number))
    };
    (new.opcode == Opcode::NewRung && contacts.iter().all(plain)).then_some((opcode, Some(last)))
}
