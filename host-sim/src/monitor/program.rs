//! The program file that the board shall run: what a board does not tell of it.

use crate::board::watch::{Kept, Scope};
use crate::engine::Machine;
use crate::panel::Rung;
use unoclp_core::{Delay, Fault};

/// A program, to show a board's timers, counters and rungs by.
pub struct Program {
    /// What it is called.
    pub(super) name: String,
    /// How a board keeps it.
    pub(super) kept: Kept,
    pub(super) rungs: Vec<Rung>,
    /// What each timer does.
    pub(super) timers: Vec<Delay>,
    counters: u16,
}

impl Program {
    /// The program of this file.
    ///
    /// # Errors
    /// Its first fault.
    pub fn new(name: String, file: &[u8]) -> Result<Program, Fault> {
        let machine = Machine::load(file)?;
        let plc = machine.plc();
        Ok(Program {
            name,
            kept: Kept::of(file).unwrap_or_default(),
            rungs: Rung::all(plc.steps()),
            timers: plc
                .steps()
                .filter_map(|step| Delay::of(step.opcode))
                .collect(),
            counters: plc.counters().count() as u16,
        })
    }

    /// How much of a board there is to read for it.
    pub fn scope(&self) -> Scope {
        Scope {
            timers: self.timers.len() as u16,
            counters: self.counters,
        }
    }
}
