//! What a point is.

/// What kind of point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// An input, from 1.
    Input,
    /// An output, from 1.
    Output,
    /// A marker, from 1.
    Marker,
    /// A system marker, from 1.
    System,
    /// No point but always 1, as `SM0.0` of Siemens is; its number is 0.
    Always,
    /// An analogue input, from 0.
    Analogue,
    /// The PWM of an output, by the output's number.
    Pwm,
    /// A register, from 1.
    Register,
    /// Eight markers as one number, from 1.
    Group,
    /// All inputs as one number; its number is 0.
    Inputs,
    /// All outputs as one number; its number is 0.
    Outputs,
    /// A timer, by the number in its name.
    Timer,
    /// A counter, by the number in its name.
    Counter,
}

impl Kind {
    /// Whether it is one bit.
    pub const fn is_bit(self) -> bool {
        use Kind::{Always, Input, Marker, Output, System};
        matches!(self, Input | Output | Marker | System | Always)
    }
}

/// A point of a board: which kind, and which of them. Whether a board has it, the board says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Address {
    /// What kind.
    pub kind: Kind,
    /// Which of them, counted as the kind says.
    pub number: u16,
}

impl Address {
    /// The point of this kind and number.
    pub const fn new(kind: Kind, number: u16) -> Address {
        Address { kind, number }
    }
}
