//! Which accumulator is still looked at, before each step.
//!
//! Owns that question. Must not know Structured Text.

use unoclp_core::Instruction;
use unoclp_core::isa::{Class, Opcode, Operand, Value};

/// Before each step, and after the last, whether what it holds is looked at.
pub(super) struct Live {
    pub acc: Vec<bool>,
    pub value: Vec<bool>,
}

/// What a step does with an accumulator.
#[derive(Clone, Copy, PartialEq)]
enum Use {
    Reads,
    Sets,
    Leaves,
}

impl Live {
    pub fn of(steps: &[Instruction<'_>], next: &dyn Fn(usize) -> [Option<usize>; 2]) -> Live {
        Live {
            acc: before(steps, next, acc),
            value: before(steps, next, value),
        }
    }
}

fn before(
    steps: &[Instruction<'_>],
    next: &dyn Fn(usize) -> [Option<usize>; 2],
    does: fn(Instruction<'_>) -> Use,
) -> Vec<bool> {
    let mut live = vec![false; steps.len() + 1];
    loop {
        let mut changed = false;
        for (at, step) in steps.iter().enumerate().rev() {
            let now = match does(*step) {
                Use::Reads => true,
                Use::Sets => false,
                Use::Leaves => next(at).into_iter().flatten().any(|to| live[to]),
            };
            changed |= now != live[at];
            live[at] = now;
        }
        if !changed {
            return live;
        }
    }
}

fn acc(step: Instruction<'_>) -> Use {
    match step.opcode.class() {
        Class::Rung | Class::Part | Class::Label | Class::RecallPoint => Use::Sets,
        Class::Load | Class::Operation | Class::Setting => Use::Leaves,
        _ => Use::Reads,
    }
}

fn value(step: Instruction<'_>) -> Use {
    match step.opcode.class() {
        Class::LoadResult => Use::Sets,
        Class::Load if step.operand == Operand::Value(Value::Popped) => Use::Reads,
        Class::Load => Use::Sets,
        Class::Store if matches!(step.opcode, Opcode::Move | Opcode::Drum) => Use::Leaves,
        Class::Comparison | Class::ValueContact | Class::Operation | Class::Store => Use::Reads,
        _ => Use::Leaves,
    }
}
