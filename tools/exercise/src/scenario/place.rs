//! What a scenario looks at and sets: outputs, PWM, markers and registers.

use std::fmt;
use unoclp_core::Board;
use unoclp_core::isa::REGISTERS;
use unoclp_host_sim::engine::Cell;
use unoclp_point::Address;

/// What an expectation is about: an output, its PWM, a marker or a register.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place(Address);

impl Place {
    /// The place that a scenario calls so.
    pub(super) fn of_name(name: &str, board: Board) -> Option<Place> {
        let outputs = (1..=board.outputs).map(Address::Output);
        let markers = (1..=board.markers).map(Address::Marker);
        let registers = (1..=REGISTERS).map(Address::Register);
        let pwm = board.pwm_outputs().map(Address::Pwm);
        let mut all = outputs.chain(markers).chain(registers).chain(pwm);
        all.find(|point| point.to_string() == name).map(Place)
    }

    /// The point.
    pub fn point(self) -> Address {
        self.0
    }

    /// The cell of the program's memory, where it is one.
    pub fn cell(self) -> Option<Cell> {
        match self.0 {
            Address::Marker(number) => Some(Cell::Marker(number)),
            Address::Register(number) => Some(Cell::Register(number)),
            _ => None,
        }
    }

    /// The number of the output, where it is one: 0 or 1.
    pub fn output(self) -> Option<u8> {
        match self.0 {
            Address::Output(number) => Some(number),
            _ => None,
        }
    }

    /// Whether it can only be 0 or 1.
    pub fn is_bit(self) -> bool {
        self.0.is_bit()
    }
}

impl fmt::Display for Place {
    /// `Q1`, `M64`, `D3`, `P4`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
