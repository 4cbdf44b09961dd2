//! A checked program that a simulated board starts with, in whichever way takes the least time there.

use std::iter::once;
use unoclp_core::Program;
use unoclp_host_sim::engine::{Engine, Refusal};
use unoclp_uno_sim::Uno;
use unoclp_uno_sim::avr8js::Avr8js;
use unoclp_uno_sim::engine::{EngineError, FirmwareEngine, Simulated};

/// The first scan, a fault that the board tells, or neither.
pub type Started = Result<Result<(), Refusal>, EngineError>;

pub trait Starts: Simulated {
    fn start(engine: &mut FirmwareEngine<Self>, program: &Program<'_>) -> Started;
}

/// A write to its EEPROM takes as long as on the chip, so that it keeps the program already.
impl Starts for Uno {
    fn start(engine: &mut FirmwareEngine<Uno>, program: &Program<'_>) -> Started {
        engine.start_kept(program)
    }
}

/// It reads the codes from its card, without comments, which take time to read.
impl Starts for Avr8js {
    fn start(engine: &mut FirmwareEngine<Avr8js>, program: &Program<'_>) -> Started {
        let codes = program.steps().flat_map(|step| step.codes());
        let lines = once(0).chain(codes).map(|code| format!("{code}\n"));
        engine.load(lines.collect::<String>().as_bytes())
    }
}
