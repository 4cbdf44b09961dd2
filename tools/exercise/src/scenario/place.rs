//! What a scenario looks at and sets: outputs, PWM, and cells of the program's memory.

use std::fmt;
use unoclp_core::Board;
use unoclp_core::isa::REGISTERS;
use unoclp_host_sim::engine::Cell;

/// What an expectation is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// The output with this number, from 1: 0 or 1.
    Output(u8),
    /// A cell.
    Cell(Cell),
    /// PWM of the output with this number: 0 to 255.
    Pwm(u8),
}

impl Place {
    /// The place that a scenario calls so.
    pub(super) fn of_name(name: &str, board: Board) -> Option<Place> {
        let all = |count| 1..=count;
        let outputs = all(board.outputs).map(Place::Output);
        let markers = all(board.markers).map(|number| Place::Cell(Cell::Marker(number)));
        let registers = all(REGISTERS).map(|number| Place::Cell(Cell::Register(number)));
        let pwm = board.pwm_outputs().map(Place::Pwm);
        outputs
            .chain(markers)
            .chain(registers)
            .chain(pwm)
            .find(|place| place.to_string() == name)
    }

    /// Whether it can only be 0 or 1.
    pub fn is_bit(self) -> bool {
        matches!(self, Place::Output(_) | Place::Cell(Cell::Marker(_)))
    }
}

impl fmt::Display for Place {
    /// `Q1`, `M64`, `D3`, `P4`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Output(number) => write!(f, "Q{number}"),
            Place::Cell(Cell::Marker(number)) => write!(f, "M{number}"),
            Place::Cell(Cell::Register(number)) => write!(f, "D{number}"),
            Place::Pwm(number) => write!(f, "P{number}"),
        }
    }
}
