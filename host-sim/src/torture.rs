//! The loader meets random and damaged files, and stored programs that have been damaged.
//!
//! `cargo run --release -p unoclp-host-sim --example torture -- 10000000`

use crate::random::{Random, random_inputs, random_pause, random_program};
use unoclp_core::isa::TABLE;
use unoclp_core::{Board, Cause, Inputs, Loader, Millis, Plc, Program};

/// How the files of a run fared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Files that made a program, which then ran.
    pub programs: u64,
    /// Files that were refused.
    pub refused: u64,
    /// Stored programs that were damaged and yet made a program, which then ran.
    pub restored: u64,
    /// Runs that ended in the one fault that a running program may have.
    pub stopped: u64,
}

/// Scans that each accepted program runs.
const SCANS: u32 = 8;

/// Loads the file of this seed, and runs it where it makes a program; adds it to the tally. An
/// error says which promise of the core was broken.
pub fn torture(seed: u64, tally: &mut Tally) -> Result<(), String> {
    let mut random = Random::new(seed);
    let file = random_file(&mut random);
    let mut memory = vec![0; Board::UNO.plc_bytes()];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    let mut first_fault = None;
    for &byte in &file {
        if let Err(fault) = loader.push(byte) {
            first_fault.get_or_insert(fault);
        }
    }
    while let Err(fault) = loader.end() {
        first_fault.get_or_insert(fault);
    }
    match (loader.finish(), first_fault) {
        (Err(fault), Some(first)) if fault == first => {
            let lines = file.iter().filter(|&&byte| byte == b'\n').count() as u32 + 1;
            if fault.line.is_some_and(|line| line < 1 || line > lines) {
                return Err(format!("{fault}, in a file of {lines} lines"));
            }
            tally.refused += 1;
            Ok(())
        }
        (Ok(program), None) => {
            let stored = program.stored().to_vec();
            run(program, &mut random, tally)?;
            tally.programs += 1;
            torture_stored(stored, &mut random, tally)
        }
        (finished, told) => Err(format!("told {told:?}, and gave {finished:?}")),
    }
}

/// Damages a stored program and brings it back: it is refused, or a program like any other.
fn torture_stored(
    mut stored: Vec<u8>,
    random: &mut Random,
    tally: &mut Tally,
) -> Result<(), String> {
    let mut memory = vec![0; Board::UNO.plc_bytes()];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    let restored = loader.restore(&mut stored.iter().copied());
    match (restored, loader.finish()) {
        (Ok(()), Ok(program)) if program.stored() == stored => {}
        other => return Err(format!("a stored program comes back as {other:?}")),
    }
    for _ in 0..=random.below(3) {
        let at = random.below(stored.len() as u32) as usize;
        match (random.below(3), stored.get_mut(at)) {
            (0, Some(byte)) => *byte ^= 1 << random.below(8),
            (1, Some(byte)) => *byte = random.bits() as u8,
            _ => stored.truncate(at),
        }
    }
    let mut memory = vec![0; Board::UNO.plc_bytes()];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    let restored = loader.restore(&mut stored.iter().copied());
    match (restored, loader.finish()) {
        (Ok(()), Ok(program)) => {
            run(program, random, tally)?;
            tally.restored += 1;
            Ok(())
        }
        (Err(fault), Ok(_)) => Err(format!("a stored program in spite of {fault}")),
        (_, Err(_)) => Ok(()),
    }
}

/// Runs a program with random inputs: it is within the board's limits, outputs that the board lacks or
/// that are PWM stay 0, and all of them are 0 at a fault.
fn run(program: Program<'_>, random: &mut Random, tally: &mut Tally) -> Result<(), String> {
    let (stored, linked) = (program.stored_bytes(), program.linked_bytes());
    if stored > Board::UNO.stored_bytes.into() || linked > Board::UNO.linked_bytes.into() {
        return Err(format!(
            "accepted with {stored} bytes stored, {linked} linked"
        ));
    }
    let mut plc = Plc::new(program);
    let mut inputs = Inputs::default();
    let mut now = random.bits() as Millis;
    for _ in 0..SCANS {
        inputs = random_inputs(random, plc.needs(), inputs);
        now = now.wrapping_add(random_pause(random));
        let outputs = match plc.scan(inputs, now) {
            Ok(outputs) => outputs,
            Err(fault) if fault.cause == Cause::TooManyJumps && plc.outputs().0 == 0 => {
                tally.stopped += 1;
                return Ok(());
            }
            Err(fault) => return Err(format!("{fault}, outputs {:#b}", plc.outputs().0)),
        };
        if outputs.0 >> Board::UNO.outputs != 0 || outputs.0 & plc.needs().pwm != 0 {
            return Err(format!("outputs {:#b}", outputs.0));
        }
    }
    Ok(())
}

/// A valid program, a damaged one, or noise.
fn random_file(random: &mut Random) -> Vec<u8> {
    match random.below(10) {
        0 => noise(random, None),
        1 => noise(random, Some(b"0123456789-/ \t\r\n")),
        _ => {
            let mut file = random_program(random).into_bytes();
            for _ in 0..random.below(4) {
                damage(random, &mut file);
            }
            file
        }
    }
}

/// Random bytes; of this alphabet where there is one.
fn noise(random: &mut Random, alphabet: Option<&[u8]>) -> Vec<u8> {
    let length = random.below(300);
    let byte = |_| match alphabet {
        Some(alphabet) => random.pick(alphabet).unwrap_or_default(),
        None => random.bits() as u8,
    };
    (0..length).map(byte).collect()
}

/// Does one damage to a file.
fn damage(random: &mut Random, file: &mut Vec<u8>) {
    let at = random.below(file.len() as u32 + 1) as usize;
    let to = (at + random.below(40) as usize).min(file.len());
    match random.below(7) {
        // One bit, as a bad card would.
        0 => {
            if let Some(byte) = file.get_mut(at) {
                *byte ^= 1 << random.below(8);
            }
        }
        1 => file.insert(at, random.bits() as u8),
        // Any code, in the middle of whatever it may be.
        2 => {
            let code = TABLE.get(random.below(TABLE.len() as u32) as usize);
            let code = code.map_or(0, |row| row.code);
            let xx = random.below(100) as i32 * code.signum();
            file.splice(at..at, format!("\n{}\n", code + xx).into_bytes());
        }
        3 => file.truncate(at),
        4 => drop(file.drain(at..to)),
        // A piece twice.
        5 => {
            let piece = file[at..to].to_vec();
            file.splice(at..at, piece);
        }
        // A piece of another file.
        _ => {
            let other = random_program(random).into_bytes();
            let from = random.below(other.len() as u32) as usize;
            file.splice(at..to, other[from..].iter().copied());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn random_and_damaged_files_keep_the_promises() {
        let mut tally = Tally::default();
        for seed in 0..20_000 {
            if let Err(broken) = torture(seed, &mut tally) {
                panic!("seed {seed}: {broken}");
            }
        }
        assert!(
            tally.programs > 1_000 && tally.refused > 1_000 && tally.restored > 1_000,
            "{tally:?}"
        );
    }
}
