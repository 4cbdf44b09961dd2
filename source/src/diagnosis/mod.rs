//! `unoclp check`: all faults of a program file that can be told, each shown in its source line.

mod help;
mod show;

pub use show::show;

use crate::BOARD;
use crate::used::Used;
use std::fmt;
use unoclp_core::{Fault, Loader};

/// A fault, and where the loader stood when it told it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Diagnosis {
    /// The fault.
    pub fault: Fault,
    /// The offset in the file, in bytes, of the byte just taken; none at the end of the file.
    pub told_at: Option<usize>,
}

/// How much of the board a valid program takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Size {
    /// Codes in the file.
    pub codes: u16,
    /// Bytes of program memory.
    pub stored_bytes: usize,
    /// Bytes of run memory.
    pub linked_bytes: usize,
    /// Timers.
    pub timers: usize,
    /// What it uses of the board and its memory.
    pub used: Used,
}

impl fmt::Display for Size {
    /// `12 codes, 15 of 900 bytes (885 free), 0 timers, 2 counters`, and on a line below what it takes
    /// while it runs and the pins that it uses
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Size {
            codes,
            stored_bytes,
            linked_bytes,
            timers,
            ref used,
        } = *self;
        let room = usize::from(BOARD.stored_bytes);
        let free = room.saturating_sub(stored_bytes);
        let code = if codes == 1 { "code" } else { "codes" };
        let timer = if timers == 1 { "timer" } else { "timers" };
        write!(
            f,
            "{codes} {code}, {stored_bytes} of {room} bytes ({free} free), {timers} {timer}"
        )?;
        let more = [
            (&used.counters, "counter"),
            (&used.registers, "register"),
            (&used.markers, "marker"),
        ];
        for (numbers, name) in more {
            match numbers.len() {
                0 => {}
                1 => write!(f, ", 1 {name}")?,
                count => write!(f, ", {count} {name}s")?,
            }
        }
        let room = BOARD.linked_bytes;
        write!(
            f,
            "\n  {linked_bytes} of {room} bytes of run memory; pins: {used}"
        )
    }
}

/// Checks a program file. Gives its size, or its faults in the order in which they are found;
/// there is at least one.
pub fn diagnose(file: &[u8]) -> Result<Size, Vec<Diagnosis>> {
    let mut memory = vec![0; BOARD.plc_bytes()];
    let mut loader = Loader::new(&mut memory, BOARD);
    let mut faults = Vec::new();
    for (offset, &byte) in file.iter().enumerate() {
        if let Err(fault) = loader.push(byte) {
            faults.push(Diagnosis {
                fault,
                told_at: Some(offset),
            });
        }
    }
    while let Err(fault) = loader.end() {
        faults.push(Diagnosis {
            fault,
            told_at: None,
        });
    }
    match loader.finish() {
        Ok(program) => Ok(Size {
            codes: program.codes(),
            stored_bytes: program.stored_bytes(),
            linked_bytes: program.linked_bytes(),
            timers: program.timers(),
            used: Used::of(&program),
        }),
        Err(_) => Err(faults),
    }
}
