//! An engine: whatever runs programs and can be compared with others.
//!
//! - [`Engine`]: what each of them does: the core on this PC, the firmware in a simulator
//! - [`HostEngine`]: the core as an engine; [`Machine`]: a program that it runs
//! - [`Cell`], [`Outcome`], [`Refusal`]: what an engine is asked, and what it says
//!
//! Owns what engines must do and say alike. Must not know who compares them, nor what they are expected to do.

mod host;

pub use host::{HostEngine, Machine};

use std::fmt;
use unoclp_core::{Cause, Fault, Image, Inputs, Millis};

/// A machine that runs programs: the core on this PC, the firmware in a simulator.
///
/// The outer `Result` of each method tells whether the machine itself did its work; a machine
/// that cannot fail has [`Infallible`](std::convert::Infallible) as its error.
pub trait Engine {
    /// Why the machine could not do its work, such as a chip that hangs.
    type Error: fmt::Display;

    /// Starts again with this program file: all outputs 0, no timer started, nothing kept of a program
    /// before. Gives the refusal of a faulty program; after one, and before the first load, nothing is
    /// scanned.
    fn load(&mut self, file: &[u8]) -> Result<Result<(), Refusal>, Self::Error>;

    /// One scan with these inputs, at this reading of the millisecond clock.
    fn scan(&mut self, inputs: &Inputs, now: Millis) -> Result<Outcome, Self::Error>;

    /// A power cut between two scans: the program starts again, and retentive markers and numbers are
    /// kept (NC-12, NC-21).
    fn restart(&mut self) -> Result<(), Self::Error>;

    /// What a cell holds after the last scan.
    fn look(&mut self, cell: Cell) -> Result<i32, Self::Error>;

    /// Sets a cell between two scans.
    fn poke(&mut self, cell: Cell, value: i32) -> Result<(), Self::Error>;

    /// PWM of the output with this number, from 1, after the last scan.
    fn pwm(&mut self, output: u8) -> Result<u8, Self::Error>;
}

/// What a scan ends in: the outputs as it leaves them, or a fault, with which all outputs are 0.
pub type Outcome = Result<Image, Refusal>;

/// A cell of a program's memory, which can be set from outside, as Modbus does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cell {
    /// The marker with this number, 1–64: 0 or 1.
    Marker(u8),
    /// The register with this number, 1–98.
    Register(u8),
}

/// How an engine refuses a program or ends it: what every engine must say alike (NC-11).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The number of the fault, 11–99.
    pub number: u8,
    /// The line, counted from 1; none where the fault has none.
    pub line: Option<u32>,
}

impl Refusal {
    /// The fault, where there is one of this number.
    pub fn fault(self) -> Option<Fault> {
        let cause = Cause::ALL
            .iter()
            .find(|cause| cause.number() == self.number)?;
        Some(Fault {
            cause: *cause,
            line: self.line,
        })
    }
}

impl fmt::Display for Refusal {
    /// For developers: `fault 24, line 7`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "fault {}", self.number)?;
        self.line.map_or(Ok(()), |line| write!(f, ", line {line}"))
    }
}

impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Refusal {
        Refusal {
            number: fault.cause.number(),
            line: fault.line,
        }
    }
}
