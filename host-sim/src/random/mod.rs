//! Random valid programs, and random inputs and times to run them with.
//!
//! Everything follows from a seed, so a failure is repeated by its seed alone.

mod program;
mod stream;
mod write;

pub use stream::Random;

use unoclp_checked::Checked;
use unoclp_core::{Board, Cause, Inputs, Instruction, Millis, Needs};

/// A random program that the board accepts: of any size up to nearly full, with every instruction, and
/// written in any of the ways that NC-3 allows.
pub fn random_program(random: &mut Random) -> String {
    random_program_on(random, Board::UNO)
}

/// The same on another board.
pub fn random_program_on(random: &mut Random, board: Board) -> String {
    let mut rungs = program::random_rungs(random, board);
    loop {
        let instructions: Vec<Instruction<'static>> = program::resolve(random, &rungs, board);
        let text = write::write(random, &instructions);
        match Checked::read(text.as_bytes(), board) {
            // Sizes were only estimated.
            Err(fault) if matches!(fault.cause, Cause::ProgramFull | Cause::RunMemoryFull) => {
                drop(rungs.pop());
            }
            _ => return text,
        }
    }
}

/// Inputs for the next scan of a program that needs this: mostly as they were, sometimes with one
/// changed, seldom all again.
pub fn random_inputs(random: &mut Random, needs: Needs, before: Inputs) -> Inputs {
    random_inputs_on(random, (needs, Board::UNO), before)
}

/// The same on another board.
pub fn random_inputs_on(
    random: &mut Random,
    (needs, board): (Needs, Board),
    before: Inputs,
) -> Inputs {
    let mut inputs = before;
    // A pin that is an analogue input has no button.
    let shared = match board.shared_from {
        0 => 0,
        first => needs.analogue << (first - 1),
    };
    let buttons = !shared & ((1 << board.inputs) - 1);
    match random.below(100) {
        0..70 => {}
        70..95 => inputs.points.0 ^= 1 << random.below(board.inputs.into()) & buttons,
        _ => {
            let low = u128::from(random.bits() as u16);
            let high = match board.inputs {
                ..=16 => 0,
                _ => u128::from(random.bits()) << 64 | u128::from(random.bits()) << 16,
            };
            inputs.points.0 = (high | low) & buttons;
        }
    }
    let readings = inputs.analogue.iter_mut().take(board.analogue.into());
    for (input, reading) in readings.enumerate() {
        if needs.analogue >> input & 1 != 0 && random.percent(30) {
            *reading = random.below(1024) as u16;
        }
    }
    inputs
}

/// ms to the next scan: mostly a few, sometimes none or as many as a timer takes, seldom an age.
pub fn random_pause(random: &mut Random) -> Millis {
    match random.below(100) {
        0..80 => random.below(4),
        80..99 => random.below(60),
        _ => random.bits() as Millis,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use unoclp_core::isa::Opcode;

    #[test]
    fn random_programs_are_valid_and_together_use_everything() {
        let mut seen = BTreeSet::new();
        let (mut smallest, mut most_stored, mut most_linked) = (usize::MAX, 0, 0);
        for seed in 0..500 {
            let text = random_program(&mut Random::new(seed));
            let checked = Checked::read(text.as_bytes(), Board::UNO)
                .unwrap_or_else(|fault| panic!("seed {seed}: {fault}\n{text}"));
            let program = checked.program();
            smallest = smallest.min(program.stored_bytes());
            most_stored = most_stored.max(program.stored_bytes());
            most_linked = most_linked.max(program.linked_bytes());
            seen.extend(program.steps().map(|step| step.opcode));
        }
        for &opcode in Opcode::ALL {
            assert!(seen.contains(&opcode), "{opcode:?} never occurs");
        }
        assert_eq!(smallest, 0);
        assert!(
            most_stored > usize::from(Board::UNO.stored_bytes) * 3 / 4,
            "{most_stored}"
        );
        assert!(
            most_linked > usize::from(Board::UNO.linked_bytes) * 9 / 10,
            "{most_linked}"
        );
    }

    #[test]
    fn some_programs_jump_back_too_often_and_most_do_not() {
        let mut faults = 0;
        for seed in 0..500 {
            let mut random = Random::new(seed);
            let text = random_program(&mut random);
            let mut machine =
                crate::engine::Machine::new(Checked::read(text.as_bytes(), Board::UNO).unwrap());
            let mut inputs = Inputs::default();
            for now in 0..60 {
                inputs = random_inputs(&mut random, machine.plc().needs(), inputs);
                if machine.scan_observed(inputs, now, |_, _| ()).is_err() {
                    faults += 1;
                    break;
                }
            }
        }
        assert!((5..100).contains(&faults), "{faults}");
    }

    /// Of few programs chance decides how much they do: here of as many as a quick run compares, from many seeds.
    #[test]
    fn random_programs_do_something_in_most_scans() {
        for first in (0..20).map(|group| group * 1_000) {
            let (mut scans, mut changes) = (0, 0);
            for seed in first..first + 150 {
                let (ran, changed) = changes_of(seed);
                (scans, changes) = (scans + ran, changes + changed);
            }
            assert!(
                changes * 4 > scans,
                "from seed {first}: {changes} changes in {scans} scans"
            );
        }
    }

    /// Scans, and how many of them change an output, a marker or a register.
    fn changes_of(seed: u64) -> (u32, u32) {
        let random = &mut Random::new(seed);
        let text = random_program(random);
        let mut machine =
            crate::engine::Machine::new(Checked::read(text.as_bytes(), Board::UNO).unwrap());
        let (mut inputs, mut before, mut changes) = (Inputs::default(), Default::default(), 0);
        for scan in 0..40 {
            inputs = random_inputs(random, machine.plc().needs(), inputs);
            if machine.scan_observed(inputs, scan * 10, |_, _| ()).is_err() {
                return (scan, changes);
            }
            let plc = machine.plc();
            let now = (plc.outputs(), plc.markers(), plc.registers().to_vec());
            changes += u32::from(now != before);
            before = now;
        }
        (40, changes)
    }

    #[test]
    fn the_seed_decides_the_program() {
        let program = |seed| random_program(&mut Random::new(seed));
        assert_eq!(program(7), program(7));
        assert_ne!(program(7), program(8));
    }

    #[test]
    fn numbers_stay_below_their_limit_and_reach_it() {
        let mut random = Random::new(1);
        let mut seen = [false; 5];
        for _ in 0..200 {
            seen[random.below(5) as usize] = true;
        }
        assert_eq!(seen, [true; 5]);
        assert_eq!(random.below(0), 0);
    }

    #[test]
    fn inputs_change_and_stay_on_the_board() {
        let mut random = Random::new(1);
        let mut inputs = Inputs::default();
        let needs = Needs {
            analogue: 0b1_0010,
            ..Needs::default()
        };
        let (mut ever, mut held, mut readings) = (0, 0, [0; 5]);
        for _ in 0..1_000 {
            let next = random_inputs(&mut random, needs, inputs);
            held += usize::from(next.points == inputs.points);
            ever |= next.points.0;
            for (most, reading) in readings.iter_mut().zip(next.analogue) {
                *most = reading.max(*most);
            }
            inputs = next;
        }
        assert_eq!(ever, 0b1101_1111);
        assert!((500..900).contains(&held), "{held}");
        assert_eq!(
            readings.map(|most| most > 900),
            [false, true, false, false, true]
        );
        assert!(readings.iter().all(|most| *most < 1024));
    }
}
