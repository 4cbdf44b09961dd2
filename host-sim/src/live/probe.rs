//! What the value accumulator holds behind single instructions (NC-16). A scan does not tell that, so the program runs once
//! more beside itself, with a store behind each of these instructions into a register that it does not use.
//!
//! Owns that second program. Must not know where the values are shown.

use crate::engine::Machine;
use std::collections::BTreeMap;
use std::fmt::Write;
use unoclp_checked::Checked;
use unoclp_core::isa::Opcode;
use unoclp_core::{Board, Inputs, Instruction, Millis, Plc};
use unoclp_source::{BOARD, Source};

/// The program that stores what is to be seen.
pub struct Probe {
    machine: Machine,
    /// The register that tells of a step.
    seen: BTreeMap<usize, u8>,
}

/// Room for a program with a store behind each register's worth of instructions; no board has it.
const ROOMY: Board = Board {
    stored_bytes: 2 * BOARD.stored_bytes,
    linked_bytes: 2 * BOARD.linked_bytes,
    ..BOARD
};

impl Probe {
    /// Looks at the value behind these steps, as far as the program leaves registers for it; none if it leaves none, or
    /// no room for the branches.
    pub fn new(program: &Source, steps: &[usize]) -> Option<Probe> {
        let used = &program.size.used.registers;
        let free = (1..=BOARD.engine.near_registers).filter(|register| !used.contains(register));
        let seen: BTreeMap<usize, u8> = steps.iter().copied().zip(free).collect();
        if seen.is_empty() {
            return None;
        }
        let mut text = String::from("0\n");
        for (index, step) in program.program().steps().enumerate() {
            put(&mut text, step);
            if let Some(register) = seen.get(&index) {
                look(&mut text, *register);
            }
        }
        let checked = Checked::new(ROOMY, |loader| {
            // The loader itself keeps the fault.
            let _ = text.bytes().try_for_each(|byte| loader.push(byte));
        });
        let machine = Machine::new(checked.ok()?);
        Some(Probe { machine, seen })
    }

    /// A scan like that of the program itself; gives the value behind each step, an old one where the scan has not come.
    pub fn scan(&mut self, inputs: Inputs, now: Millis) -> BTreeMap<usize, i32> {
        // The program itself tells its faults.
        let _ = self.machine.scan_observed(inputs, now, |_, _| ());
        let registers = self.machine.plc().registers();
        let value = |(step, register): (&usize, &u8)| {
            let index = usize::from(*register).checked_sub(1)?;
            Some((*step, *registers.get(index)?))
        };
        self.seen.iter().filter_map(value).collect()
    }

    /// What is done to the program, done to this one too.
    pub fn with_plc(&mut self, with: impl FnOnce(&mut Plc<'_>)) {
        self.machine.with_plc(with);
    }
}

/// The codes of an instruction, a line each.
fn put(text: &mut String, step: Instruction<'_>) {
    for code in step.codes() {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{code}");
    }
}

/// A store of the value that leaves all else as it was: in a branch, where acc is 1, which is then made 0.
fn look(text: &mut String, register: u8) {
    let store = Opcode::Store.row().code + i32::from(register);
    let row = |opcode: Opcode| opcode.row().code;
    let codes = [
        row(Opcode::OpenBranch),
        store,
        row(Opcode::Not),
        row(Opcode::CloseBranch),
    ];
    for code in codes {
        let _ = writeln!(text, "{code}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Random, random_inputs, random_program};
    use unoclp_core::Cause;
    use unoclp_core::isa::Class;
    use unoclp_source::Written;

    #[test]
    fn to_look_at_a_program_does_not_change_what_it_does() {
        let mut random = Random::new(11);
        let mut looked = 0;
        for _ in 0..150 {
            let text = random_program(&mut random);
            let Ok(source) = Written::new("p.txt".to_owned(), text.into()).check(None) else {
                continue;
            };
            let of_number = |class| matches!(class, Class::Load | Class::Operation);
            let steps = source.program().steps().enumerate();
            let steps = steps.filter(|(_, step)| of_number(step.opcode.class()));
            let steps: Vec<usize> = steps.map(|(index, _)| index).collect();
            let Some(mut probe) = Probe::new(&source, &steps) else {
                continue;
            };
            let needs = source.program().needs();
            let mut inputs = Inputs::default();
            let mut machine = Machine::new(source.checked);
            for now in (0..400).step_by(7) {
                inputs = random_inputs(&mut random, needs, inputs);
                let came = machine.scan_observed(inputs, now, |_, _| ());
                if came.is_err() {
                    break;
                }
                // To look takes bytes, of which a loop may jump over too many then.
                let looks = probe.machine.scan_observed(inputs, now, |_, _| ());
                if looks.is_err_and(|fault| fault.cause == Cause::TooManyJumps) {
                    break;
                }
                let (own, other) = (machine.plc(), probe.machine.plc());
                assert_eq!(own.outputs(), other.outputs(), "at {now} ms");
                assert_eq!(own.markers(), other.markers(), "at {now} ms");
                looked += 1;
            }
        }
        assert!(looked > 1000, "{looked}");
    }
}
